using System;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Tests.Kernels;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using Random = System.Random;
using Range = NUnit.Framework.RangeAttribute;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>
    /// What an edit leaves on the GPU against what a fresh renderer computes in full, byte by byte: opacity, anti-aliased opacity, normals and skip map after
    /// every step of random scripts of edits.
    /// </summary>
    sealed class IncrementalTests : PlayModeScene
    {
        static readonly string[] Textures = { "AnatomyCarve opacity", "AnatomyCarve anti-aliased opacity", "AnatomyCarve normals", "AnatomyCarve skip map" };

        [Test]
        public void Textures_AfterEachEditOfARandomScript_AreThoseOfAFullComputation([Range(1, 12)] int seed, [Values] CutMode cut) => Check(seed, cut, 25);

        [Test, Explicit("10,000 edits take minutes"), Category("Long")]
        public void Textures_AfterEachOfTenThousandEdits_AreThoseOfAFullComputation([Range(101, 150)] int seed, [Values] CutMode cut) => Check(seed, cut, 100);

        /// <summary>In some bricks an edit of this script changes only what spheres do to segments that nothing shows; the normals there follow too.</summary>
        [Test]
        public void Textures_AfterEditsOfSegmentsThatNothingShows_AreThoseOfAFullComputation([Values] CutMode cut) => Check(144, cut, 32);

        void Check(int seed, CutMode cut, int edits)
        {
            var random = new Random(seed);
            SegmentedVolume volume = RandomMatter.Volume(random, 2 + random.Next(12), 14, 40);
            CarvedVolumeRenderer edited = MakeRenderer(volume, cut);
            Edit(edited.Stack.Carving, volume.Geometry, random);
            edited.Render(RandomMatter.Rays(volume.Geometry, random, 8));
            RenderTexture[] ofEdited = Find(new RenderTexture[0]);
            CarvedVolumeRenderer full = MakeRenderer(volume, cut);
            full.Render(RandomMatter.Rays(volume.Geometry, random, 8));
            RenderTexture[] ofFull = Find(ofEdited);
            long changed = 0;
            for (int edit = 0; edit < edits; edit++)
            {
                byte[][] before = Array.ConvertAll(ofEdited, Bytes);
                Edit(edited.Stack.Carving, volume.Geometry, random);
                edited.Render(RandomMatter.Rays(volume.Geometry, random, 8));
                full.Stack.Carving.Replace(edited.Stack.Carving.Fixed, edited.Stack.Carving.Active);
                full.TransferFunction = Ramp(); // another object: everything is computed
                full.Render(RandomMatter.Rays(volume.Geometry, random, 8));
                byte[][] now = Array.ConvertAll(ofEdited, Bytes), expected = Array.ConvertAll(ofFull, Bytes);
                for (int t = 0; t < Textures.Length; t++)
                {
                    int different = Enumerable.Range(0, now[t].Length).Count(n => now[t][n] != expected[t][n]);
                    Assert.That(different, Is.Zero, $"bytes of {Textures[t]}, seed {seed}, edit {edit}, {volume.Geometry.SizeI} x {volume.Geometry.SizeJ} x {volume.Geometry.SizeK}");
                    changed += Enumerable.Range(0, now[t].Length).Count(n => now[t][n] != before[t][n]);
                }
            }
            Assert.That(changed, Is.GreaterThan(1000), "bytes that edits changed, seed " + seed);
        }

        CarvedVolumeRenderer MakeRenderer(SegmentedVolume volume, CutMode cut)
        {
            CarvedVolumeRenderer renderer = MakeVolume(volume);
            renderer.Quality = new RenderQuality { CutMode = cut };
            renderer.TransferFunction = Ramp();
            return renderer;
        }

        static OpacityTransferFunction Ramp() => OpacityTransferFunction.Parse("100:0,400:0.4,900:1");

        static void Edit(CarvingStack carving, VolumeGeometry geometry, Random random)
        {
            double Along(int size) => (size + 8) * random.NextDouble() - 4.5;
            double size = geometry.SpacingMm.Length * Math.Max(geometry.SizeI, Math.Max(geometry.SizeJ, geometry.SizeK));
            switch (carving.Active is null ? 0 : random.Next(9))
            {
                case 0:
                case 1:
                    PointMm anywhere = geometry.IjkToLps.TransformPoint(new PointMm(Along(geometry.SizeI), Along(geometry.SizeJ), Along(geometry.SizeK)));
                    carving.SetActive(anywhere, 0.4 * size * random.NextDouble());
                    break;
                case 2:
                case 3:
                    double[] step = RayScene.RandomDirection(random);
                    double length = 3 * geometry.ReferenceLengthMm * random.NextDouble();
                    carving.SetActive(carving.Active.CentreLps + length * new VectorMm(step[0], step[1], step[2]), carving.Active.RadiusMm * (0.9 + 0.2 * random.NextDouble()));
                    break;
                case 4:
                    carving.FixActive();
                    break;
                case 5:
                    carving.SetActiveMask(carving.ActiveMask.Toggled(random.Next(carving.SegmentCount)));
                    break;
                case 6:
                    double share = random.NextDouble();
                    carving.SetActiveMask(SegmentMask.FromIndices(carving.SegmentCount, Enumerable.Range(0, carving.SegmentCount).Where(_ => random.NextDouble() < share)));
                    break;
                case 7:
                    carving.Undo();
                    break;
                default:
                    if (random.Next(3) == 0)
                        carving.Redo();
                    else
                        carving.RemoveLast();
                    break;
            }
        }

        /// <summary>The textures of the only renderer besides one whose textures are known.</summary>
        static RenderTexture[] Find(RenderTexture[] known) => Array.ConvertAll(
            Textures, name => Resources.FindObjectsOfTypeAll<RenderTexture>().Single(texture => texture.name == name && !known.Contains(texture)));

        static byte[] Bytes(RenderTexture texture) =>
            texture.graphicsFormat == GraphicsFormat.R32_UInt ? KernelRig.Read<uint>(texture).SelectMany(BitConverter.GetBytes).ToArray() : KernelRig.Read<byte>(texture);
    }
}
