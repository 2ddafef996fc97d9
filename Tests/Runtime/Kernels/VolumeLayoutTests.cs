using System;
using System.Collections.Generic;
using System.IO;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>VolumeLayout.hlsl, read as text, against the C# side: limits, structs, names.</summary>
    public sealed class VolumeLayoutTests
    {
        static readonly Assembly Package = typeof(AnatomyCarveShaders).Assembly;

        [Test]
        public void Limits_AreTheSameInHlslAndCSharp()
        {
            string layout = Read("VolumeLayout.hlsl");
            Assert.That(Define(layout, "BRICK_SIZE"), Is.EqualTo(BrickGrid.BrickSize));
            Assert.That(Define(layout, "SEGMENTS_PER_ROW"), Is.EqualTo(Constant("LookupTextures", "SegmentsPerRow")));
            Assert.That(Define(layout, "GROUP_THREADS"), Is.EqualTo(Define(layout, "GROUP_SIZE") * Define(layout, "GROUP_SIZE")));
        }

        [Test]
        public void Reaches_AreTheSameInHlslAndCSharp()
        {
            Assert.That(Define(Read("SobelNormals.compute"), "SOBEL_REACH"), Is.EqualTo(CarvingReach.SobelVoxels));
            Assert.That(Define(Read("Bricks.hlsl"), "OPACITY_STEP"), Is.EqualTo(BrickPart.OpacityStep));
            Assert.That(Define(Read("Bricks.hlsl"), "NORMALS_STEP"), Is.EqualTo(BrickPart.NormalsStep));
            Assert.That(Define(Read("Bricks.hlsl"), "STRIP_COLUMNS"), Is.EqualTo(BrickPart.StripColumns));
            Assert.That(Define(Read("Bricks.hlsl"), "STRIP_ROWS"), Is.EqualTo(BrickPart.StripRows));
            Assert.That(Define(Read("Bricks.hlsl"), "STRIPS"), Is.EqualTo(BrickPart.Strips));
            Assert.That(Regex.Match(Read("OpacityTile.hlsl"), @"TILE_SIZE \(BRICK_SIZE \+ (\d+)\)").Groups[1].Value, Is.EqualTo((2 * CarvingReach.AntiAliasVoxels).ToString()));
            Assert.That(Number(Read("ClipSpheres.hlsl"), "SURFACE_REACH"), Is.EqualTo(CarvingReach.SurfaceExtents));
        }

        [Test]
        public void FirstVisiblePoint_IsLookedForInTheSamePlacesInHlslAndCSharp()
        {
            Type walk = typeof(SegmentPicker).Assembly.GetType("AnatomyCarve.Picking.RayWalk", true);
            object Picker(string name) => walk.GetField(name, BindingFlags.Static | BindingFlags.NonPublic).GetValue(null);
            Assert.That(Number(Read("Raymarch.hlsl"), "NEARLY"), Is.EqualTo(Picker("Nearly")));
            Assert.That(Number(Read("Raymarch.hlsl"), "FURTHER_STEPS"), Is.EqualTo(Picker("FurtherSteps")));
            Assert.That(Number(Read("Raymarch.hlsl"), "EDGE_REACH"), Is.EqualTo(Picker("EdgeReach")));
            Assert.That(Number(Read("Raymarch.hlsl"), "PLATEAU"), Is.EqualTo(Picker("Plateau")));
            Assert.That(Read("Raymarch.hlsl"), Does.Contain("ONE_CODE = 1.0 / 255.0;").And.Contain("SHADED_ALPHA = 1.0 - 1.0 / 512.0;"));
            Assert.That((Picker("OneCode"), RaySettings.DefaultOpaqueAlpha), Is.EqualTo((1 / 255.0, 1 - 1 / 512.0)));
        }

        [Test]
        public void SkipCells_AreTheSameInHlslAndCSharp()
        {
            string cells = Read("SkipCells.hlsl");
            Assert.That(Define(cells, "CELL_SIZE"), Is.EqualTo(Constant("SkipStructure", "CellSize")));
            Assert.That(1 << Define(cells, "CELL_SHIFT"), Is.EqualTo(Define(cells, "CELL_SIZE")));
            Assert.That(Define(cells, "FARTHEST_CELL"), Is.EqualTo(Constant("SkipStructure", "FarthestCell")));
            Assert.That(Define(cells, "CELLS_PER_TEXEL"), Is.EqualTo(Constant("SkipStructure", "CellsPerTexel")));
            Assert.That(1 << Define(cells, "TEXEL_SHIFT"), Is.EqualTo(Define(cells, "CELLS_PER_TEXEL")));
        }

        [Test]
        public void SphereRow_HasTheSameLayoutInHlslAndCSharp()
        {
            Type row = Package.GetType("AnatomyCarve.SphereBuffers+SphereRow", true);
            List<string[]> members = Members(Read("VolumeLayout.hlsl"), "struct", "SphereRow");
            Assert.That(members.Count, Is.EqualTo(2));
            Assert.That(members[0], Is.EqualTo(new[] { "float4", "centreRadius" }));
            Assert.That(members[1], Is.EqualTo(new[] { "uint4", "mask" }));
            Assert.That(Marshal.SizeOf(row), Is.EqualTo(16 * members.Count));
            Assert.That((int)Marshal.OffsetOf(row, "CentreRadius"), Is.EqualTo(0));
            Assert.That((int)Marshal.OffsetOf(row, "MaskOffset"), Is.EqualTo(16), "mask.x");
            Assert.That((int)Marshal.OffsetOf(row, "MaskWord0"), Is.EqualTo(20), "mask.y");
            Assert.That((int)Marshal.OffsetOf(row, "MaskWord2"), Is.EqualTo(28), "mask.w");
        }

        [TestCase("VolumeLayout.hlsl", "CarvedVolume")]
        [TestCase("VolumeLayout.hlsl", "RaymarchSettings")]
        [TestCase("Raymarch.compute", "RaymarchView")]
        [TestCase("SkipRegion.hlsl", "SkipRegion")]
        public void ConstantBuffer_IsMadeOfRowsThatCSharpKnows(string file, string name)
        {
            List<string[]> members = Members(Read(file), "cbuffer", name);
            Assert.That(members, Is.Not.Empty);
            foreach (string[] member in members)
            {
                Assert.That(member[0], Is.EqualTo("float4").Or.EqualTo("int4"), member[1] + ": anything but rows of 16 bytes is packed differently by Direct3D and Vulkan");
                AssertIdExists(member[1]);
            }
        }

        [TestCase("CarvedVolume")]
        [TestCase("RaymarchSettings")]
        public void ConstantBuffer_OfMaterials_HoldsNoIntegers(string name) =>
            Assert.That(Members(Read("VolumeLayout.hlsl"), "cbuffer", name).ConvertAll(member => member[0]), Is.All.EqualTo("float4"));

        [TestCase("CarvedVolume")]
        [TestCase("RaymarchSettings")]
        public void ConstantBuffer_OfMaterials_IsDeclaredByTheEyeShader(string name)
        {
            Shader shader = AnatomyCarveShaders.Load().CarvedVolume;
            foreach (string[] member in Members(Read("VolumeLayout.hlsl"), "cbuffer", name))
                Assert.That(shader.FindPropertyIndex(member[1]), Is.GreaterThanOrEqualTo(0), member[1] + ": URP's SRP Batcher would not keep it per material");
        }

        [Test]
        public void Resources_AreAllKnownToCSharp()
        {
            int found = 0;
            foreach (string file in Directory.GetFiles(Path.GetDirectoryName(PathOf("VolumeLayout.hlsl"))))
            {
                if (file.EndsWith(".meta", StringComparison.Ordinal))
                    continue;
                foreach (Match match in Regex.Matches(File.ReadAllText(file), @"^(?:(?:RW)?(?:Texture[23]D|StructuredBuffer)<[^>]+>|#define \w+_TARGET)\s+(_\w+)", RegexOptions.Multiline))
                {
                    AssertIdExists(match.Groups[1].Value);
                    found++;
                }
            }
            Assert.That(found, Is.GreaterThan(15));
        }

        static void AssertIdExists(string property)
        {
            FieldInfo field = Package.GetType("AnatomyCarve.ShaderIds", true).GetField(property.TrimStart('_'), BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic);
            Assert.That(field, Is.Not.Null, property + " is missing in ShaderIds");
            Assert.That(field.GetValue(null), Is.EqualTo(Shader.PropertyToID(property)), property);
        }

        static int Constant(string type, string name) =>
            (int)Package.GetType("AnatomyCarve." + type, true).GetField(name, BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic).GetValue(null);

        static int Define(string text, string name) => int.Parse(Regex.Match(text, @"#define " + name + @" (\d+)").Groups[1].Value, System.Globalization.CultureInfo.InvariantCulture);

        static double Number(string text, string name) => double.Parse(Regex.Match(text, name + @" = ([0-9.]+)").Groups[1].Value, System.Globalization.CultureInfo.InvariantCulture);

        /// <summary>Type and name of each member of a struct or cbuffer.</summary>
        static List<string[]> Members(string text, string kind, string name)
        {
            var members = new List<string[]>();
            string body = Regex.Match(text, kind + @" " + name + @"\s*\{([^}]*)\}").Groups[1].Value;
            foreach (Match match in Regex.Matches(body, @"^\s*(\w+) ([^;]+);", RegexOptions.Multiline))
                foreach (string member in match.Groups[2].Value.Split(','))
                    members.Add(new[] { match.Groups[1].Value, member.Trim() });
            return members;
        }

        static string Read(string file) => File.ReadAllText(PathOf(file));

        static string PathOf(string file, [CallerFilePath] string here = "") =>
            Path.GetFullPath(Path.Combine(Path.GetDirectoryName(here), "..", "..", "..", "Shaders", file));
    }
}
