using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Headless.Cli.Bench.Reference
{
    /// <summary>
    /// The reference path on the same driver: it recomputes everything in every frame, as the first prototype did (ReferenceVolume.compute, ReferenceRays.compute).
    /// For volumes whose axes are L, P, S.
    /// </summary>
    sealed class ReferencePath : IDisposable
    {
        const int Group = 4, PictureGroup = 8, FunctionSize = 4096;
        const float StepReferenceLengths = 0.5f;
        static readonly string[] VolumeKernels = ["Carve", "Opacity", "Colors", "Copy", "Normals"];

        readonly BenchScene scene;
        readonly ComputeShader volume, rays;
        readonly List<Object> textures = [];
        readonly GraphicsBuffer spheres, masks;
        readonly Vector4[] rows;
        readonly int wordsPerMask;
        long voxelBytes;

        public ReferencePath(BenchStage stage, BenchScene scene)
        {
            this.scene = scene;
            volume = stage.Host.LoadComputeShader(BenchFiles.Find("Reference", "ReferenceVolume.compute"));
            rays = stage.Host.LoadComputeShader(BenchFiles.Find("Reference", "ReferenceRays.compute"));
            wordsPerMask = (scene.Volume.Segments.Count + 31) / 32;
            rows = new Vector4[scene.Spheres.Count];
            spheres = new GraphicsBuffer(GraphicsBuffer.Target.Structured, rows.Length, 16);
            masks = new GraphicsBuffer(GraphicsBuffer.Target.Structured, rows.Length * wordsPerMask, 4);
            var words = new uint[rows.Length * wordsPerMask];
            for (var s = 0; s < rows.Length; s++) scene.Spheres[s].Mask.CopyWordsTo(words, s * wordsPerMask);
            masks.SetData(words);
            Bind();
            MoveActive(0);
        }

        /// <summary>Bytes per voxel that it keeps on the GPU.</summary>
        public double BytesPerVoxel => voxelBytes / (double)scene.Volume.Geometry.VoxelCount;

        /// <summary>Puts the active sphere so many moves from where it stands in the scene.</summary>
        public void MoveActive(double moves)
        {
            var centre = scene.Volume.Geometry.CentreLps;
            for (var s = 0; s < rows.Length; s++)
            {
                var sphere = scene.Spheres[s];
                var place = sphere.CentreLps - centre + (s == rows.Length - 1 ? moves : 0) * scene.Move;
                rows[s] = new Vector4((float)place.X, (float)place.Y, (float)place.Z, (float)sphere.RadiusMm);
            }

            spheres.SetData(rows);
        }

        /// <summary>The five passes over the volume.</summary>
        public void UpdateVolume()
        {
            var geometry = scene.Volume.Geometry;
            foreach (var name in VolumeKernels)
            {
                volume.Dispatch(volume.FindKernel(name), Groups(geometry.SizeI, Group), Groups(geometry.SizeJ, Group), Groups(geometry.SizeK, Group));
            }
        }

        /// <summary>The two passes over the picture.</summary>
        public void Render()
        {
            foreach (var name in new[] { "Color", "FirstSegment" })
            {
                rays.Dispatch(rays.FindKernel(name), Groups(scene.Width, PictureGroup), Groups(scene.Height, PictureGroup), 1);
            }
        }

        /// <summary>The pixels that are opaque, for a look whether it draws at all.</summary>
        public double OpaqueShare(BenchStage stage)
        {
            var color = textures.OfType<RenderTexture>().Single(texture => texture.name == "reference color");
            var floats = System.Runtime.InteropServices.MemoryMarshal.Cast<byte, float>(stage.Host.ReadTexture(color));
            var opaque = 0;
            for (var pixel = 3; pixel < floats.Length; pixel += 4) opaque += floats[pixel] > 0.5f ? 1 : 0;
            return 4.0 * opaque / floats.Length;
        }

        public void Dispose()
        {
            foreach (var texture in textures) Object.DestroyImmediate(texture);
            Object.DestroyImmediate(volume);
            Object.DestroyImmediate(rays);
            spheres.Dispose();
            masks.Dispose();
        }

        static int Groups(int size, int group) => (size + group - 1) / group;

        void Bind()
        {
            var geometry = scene.Volume.Geometry;
            Texture3D intensity = Read("intensity", GraphicsFormat.R16_UInt, 2, scene.Volume.Intensity.Codes);
            Texture3D labels = Read("labels", GraphicsFormat.R8_UInt, 1, Array.ConvertAll(scene.Volume.Labels.Indices, index => (byte)index));
            var (clipped, smoothed) = (Written("clipped", GraphicsFormat.R32_UInt, 4), Written("smoothed", GraphicsFormat.R32_SFloat, 4));
            var (colors, copy) = (Written("colors", GraphicsFormat.R8G8B8A8_UNorm, 4), Written("copy", GraphicsFormat.R8G8B8A8_UNorm, 4));
            var normals = Written("normals", GraphicsFormat.R16G16B16A16_SFloat, 8);
            // The prototype kept its carved opacity twice.
            Written("second opacity", GraphicsFormat.R32_SFloat, 4);
            var function = scene.TransferFunction ?? scene.Volume.AutomaticTransferFunction;
            foreach (var kernel in VolumeKernels.Select(volume.FindKernel))
            {
                volume.SetBuffer(kernel, "_SphereRows", spheres);
                volume.SetBuffer(kernel, "_SphereMasks", masks);
                volume.SetTexture(kernel, "_Intensity", intensity);
                volume.SetTexture(kernel, "_Labels", labels);
                volume.SetTexture(kernel, "_Function", Function(function));
                volume.SetTexture(kernel, "_LabelColors", LabelColors());
                volume.SetTexture(kernel, "_Clipped", clipped);
                volume.SetTexture(kernel, "_ClippedOut", clipped);
                volume.SetTexture(kernel, "_Smoothed", smoothed);
                volume.SetTexture(kernel, "_SmoothedOut", smoothed);
                volume.SetTexture(kernel, "_Colors", colors);
                volume.SetTexture(kernel, "_ColorsOut", colors);
                volume.SetTexture(kernel, "_CopyOut", copy);
                volume.SetTexture(kernel, "_NormalsOut", normals);
            }

            foreach (var kernel in new[] { "Color", "FirstSegment" }.Select(rays.FindKernel))
            {
                rays.SetTexture(kernel, "_Matter", copy);
                rays.SetTexture(kernel, "_Normals", normals);
                rays.SetTexture(kernel, "_Labels", labels);
                rays.SetTexture(kernel, "_ColorOut", Picture("color", GraphicsFormat.R32G32B32A32_SFloat));
                rays.SetTexture(kernel, "_DepthOut", Picture("depth", GraphicsFormat.R32_SFloat));
                rays.SetTexture(kernel, "_SegmentOut", Picture("segment", GraphicsFormat.R32_UInt));
            }

            var scale = scene.Volume.Intensity.CodeScale / (function.LookupMax - function.LookupMin);
            var offset = (scene.Volume.Intensity.CodeOffset - function.LookupMin) / (function.LookupMax - function.LookupMin);
            volume.SetVector("_Dims", new Vector4(geometry.SizeI, geometry.SizeJ, geometry.SizeK, rows.Length));
            volume.SetVector("_Mm", Vector(geometry.SpacingMm));
            volume.SetVector("_Lookup", new Vector4((float)scale, (float)offset, FunctionSize - 1, wordsPerMask));
            BindCamera(scene.Rays());
        }

        void BindCamera(PictureRays picture)
        {
            var geometry = scene.Volume.Geometry;
            var reference = (float)geometry.ReferenceLengthMm;
            rays.SetVector("_Picture", new Vector4(picture.Width, picture.Height, StepReferenceLengths * reference, reference));
            rays.SetVector("_Size", new Vector4(geometry.SizeI, geometry.SizeJ, geometry.SizeK));
            rays.SetVector("_Spacing", Vector(geometry.SpacingMm));
            rays.SetVector("_Eye", Vector(picture.Origin - geometry.CentreLps));
            rays.SetVector("_Direction", Vector(picture.Direction));
            rays.SetVector("_DirectionDx", Vector(picture.DirectionDx));
            rays.SetVector("_DirectionDy", Vector(picture.DirectionDy));
            rays.SetVector("_Light", Vector(-1 / picture.Direction.Length * picture.RayThroughPixel(picture.Width / 2, picture.Height / 2).Direction));
        }

        static Vector4 Vector(VectorMm v) => new((float)v.X, (float)v.Y, (float)v.Z);

        Texture3D Read<T>(string name, GraphicsFormat format, int bytes, T[] voxels) where T : struct
        {
            var geometry = scene.Volume.Geometry;
            var texture = new Texture3D(geometry.SizeI, geometry.SizeJ, geometry.SizeK, format, TextureCreationFlags.None) { name = "reference " + name };
            texture.SetPixelData(voxels, 0);
            texture.Apply(false, true);
            textures.Add(texture);
            voxelBytes += bytes * geometry.VoxelCount;
            return texture;
        }

        RenderTexture Written(string name, GraphicsFormat format, int bytes)
        {
            var geometry = scene.Volume.Geometry;
            voxelBytes += bytes * geometry.VoxelCount;
            return Make(name, new RenderTextureDescriptor(geometry.SizeI, geometry.SizeJ, format, 0)
            {
                dimension = TextureDimension.Tex3D, volumeDepth = geometry.SizeK, enableRandomWrite = true,
            });
        }

        RenderTexture Picture(string name, GraphicsFormat format) =>
            (RenderTexture)textures.FirstOrDefault(texture => texture.name == "reference " + name)
            ?? Make(name, new RenderTextureDescriptor(scene.Width, scene.Height, format, 0) { enableRandomWrite = true });

        RenderTexture Make(string name, RenderTextureDescriptor descriptor)
        {
            var texture = new RenderTexture(descriptor) { name = "reference " + name, filterMode = FilterMode.Bilinear, wrapMode = TextureWrapMode.Clamp };
            texture.Create();
            textures.Add(texture);
            return texture;
        }

        Texture2D Function(OpacityTransferFunction function) => Table("function", FunctionSize, scene.Volume.Segments.Count, GraphicsFormat.R32_SFloat, () =>
        {
            var lookup = function.Lookup();
            var shown = scene.Segments ?? scene.Volume.Segments;
            return shown.SelectMany(segment => lookup.Select(opacity => opacity * segment.Opacity)).ToArray();
        });

        Texture2D LabelColors() => Table("label colors", scene.Volume.Segments.Count, 1, GraphicsFormat.R32G32B32A32_SFloat, () => scene.Volume.Segments
            .SelectMany(segment => new[] { segment.Color.RedFloat, segment.Color.GreenFloat, segment.Color.BlueFloat, 1f }).ToArray());

        Texture2D Table(string name, int width, int height, GraphicsFormat format, Func<float[]> texels)
        {
            if (textures.OfType<Texture2D>().FirstOrDefault(made => made.name == "reference " + name) is { } found) return found;
            var texture = new Texture2D(width, height, format, TextureCreationFlags.None) { name = "reference " + name };
            texture.SetPixelData(texels(), 0);
            texture.Apply(false, true);
            textures.Add(texture);
            return texture;
        }
    }
}
