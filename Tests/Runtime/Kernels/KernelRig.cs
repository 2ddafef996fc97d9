using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>
    /// Runs one kernel by itself on plain Unity API, with resources that a test makes from arrays. It shares nothing with the package's own
    /// dispatching, so that a mistake there cannot hide here.
    /// </summary>
    sealed class KernelRig : IDisposable
    {
        /// <summary>A brick's part in the packing of <c>_Bricks</c>: of all eight strips of its columns the places 0 to 7.</summary>
        public const uint WholeBrick = 0xFFFFFFFFu;

        readonly ComputeShader shader;
        readonly int kernel;
        readonly string name;
        readonly string[] keywords;
        int spheres;
        readonly List<UnityEngine.Object> objects = new List<UnityEngine.Object>();
        readonly Dictionary<string, GraphicsBuffer> buffers = new Dictionary<string, GraphicsBuffer>();

        KernelRig(ComputeShader shader, string name, params string[] keywords)
        {
            Assert.That(shader == null, Is.False, "the compute shader is missing");
            this.shader = shader;
            this.name = name;
            this.keywords = keywords;
            shader.DisableKeyword("PORTABLE_LAYOUT"); // a renderer may have left it so: the shader is an asset that all share
            kernel = shader.FindKernel(name);
        }

        public static KernelRig ClipVoxels(bool portable = false) => new KernelRig(AnatomyCarveShaders.Load().ClipVoxels, "ClipVoxels", Layout(portable));

        public static KernelRig AntiAlias(bool portable = false) => new KernelRig(AnatomyCarveShaders.Load().AntiAlias, "AntiAlias", Layout(portable));

        public static KernelRig SobelNormals(bool portable = false) => new KernelRig(AnatomyCarveShaders.Load().SobelNormals, "SobelNormals", Layout(portable));

        public static KernelRig Raymarch(bool countSamples = false, bool portable = false) =>
            new KernelRig(AnatomyCarveShaders.Load().Raymarch, "Raymarch", countSamples ? "COUNT_SAMPLES" : null, Layout(portable));

        static string Layout(bool portable) => portable ? "PORTABLE_LAYOUT" : null;

        public void Set(string name, Vector4 value) => shader.SetVector(name, value);

        public void SetCounts(int spheres, int wordsPerMask, int segments, bool smoothCut)
        {
            this.spheres = spheres;
            shader.SetVector("_CarveCounts", new Vector4(spheres, wordsPerMask, segments, smoothCut ? 1 : 0));
        }

        /// <summary>What SobelNormals reads where nothing is carved: one segment, no sphere.</summary>
        public void SetUncarved(KernelGrid grid)
        {
            SetCounts(0, 1, 1, false);
            SetVolume("_Labels", GraphicsFormat.R8_UInt, grid, new byte[grid.VoxelCount]);
            SetRows("_Spheres", new Vector4[2], 32);
            SetRows("_MaskWords", new uint[1]);
        }

        public void SetPictureSize(int width, int height, bool sceneDepth) => shader.SetInts("_PictureSize", width, height, sceneDepth ? 1 : 0, 0);

        /// <summary>Sets the grid's rows of the constant buffer CarvedVolume; no brick list.</summary>
        public void Set(KernelGrid grid)
        {
            SetBrickCounts(grid, 0, 0);
            for (int row = 0; row < 3; row++)
            {
                shader.SetVector("_IndexToMm" + row, new Vector4(grid.IndexToMm[row, 0], grid.IndexToMm[row, 1], grid.IndexToMm[row, 2], 0));
                shader.SetVector("_MmToIndex" + row, new Vector4((float)grid.MmToIndex[row, 0], (float)grid.MmToIndex[row, 1], (float)grid.MmToIndex[row, 2], 0));
            }
            shader.SetVector("_CentreIndex", new Vector4((grid.SizeI - 1) * 0.5f, (grid.SizeJ - 1) * 0.5f, (grid.SizeK - 1) * 0.5f, grid.ReferenceMm));
        }

        public void SetVolume<T>(string name, GraphicsFormat format, KernelGrid grid, T[] voxels, FilterMode filter = FilterMode.Point)
            where T : struct
        {
            var texture = new Texture3D(grid.SizeI, grid.SizeJ, grid.SizeK, format, TextureCreationFlags.None) { name = name };
            Keep(texture, filter);
            texture.SetPixelData(voxels, 0);
            texture.Apply(false, false);
            shader.SetTexture(kernel, name, texture);
        }

        /// <summary>Opacities as the rig's layout has them.</summary>
        public void SetOpacities(string name, KernelGrid grid, byte[] codes)
        {
            if (IsPortable)
                SetPacked(name, grid, codes);
            else
                SetVolume(name, GraphicsFormat.R8_UNorm, grid, codes);
        }

        /// <summary>Where a kernel writes a byte (opacities) or two (normals) for each voxel, as the rig's layout has them.</summary>
        public RenderTexture BytesTarget(string name, KernelGrid grid, int bytesPerVoxel) =>
            IsPortable ? PackedTarget(name, grid, bytesPerVoxel) : VolumeTarget(name, bytesPerVoxel == 1 ? GraphicsFormat.R8_UNorm : GraphicsFormat.R8G8_UNorm, grid);

        /// <summary>What it wrote, voxel by voxel.</summary>
        public byte[] ReadBytes(RenderTexture target, KernelGrid grid, int bytesPerVoxel) =>
            IsPortable ? Unpack(Read<uint>(target), grid, bytesPerVoxel) : Read<byte>(target);

        bool IsPortable => Array.IndexOf(keywords, Layout(true)) >= 0;

        /// <summary>A 3D texture of 32-bit whole numbers, of any size.</summary>
        public void SetTexels(string name, int width, int height, int depth, uint[] texels)
        {
            var texture = new Texture3D(width, height, depth, GraphicsFormat.R32_UInt, TextureCreationFlags.None) { name = name };
            Keep(texture, FilterMode.Point);
            texture.SetPixelData(texels, 0);
            texture.Apply(false, false);
            shader.SetTexture(kernel, name, texture);
        }

        /// <summary>A volume packed along k: each texel holds the same bytes of several voxels, the first in its lowest bits.</summary>
        public void SetPacked(string name, KernelGrid grid, byte[] bytes)
        {
            int bytesPerVoxel = bytes.Length / grid.VoxelCount, perTexel = 4 / bytesPerVoxel, depth = (grid.SizeK + perTexel - 1) / perTexel;
            var texels = new uint[grid.SizeI * grid.SizeJ * depth];
            grid.ForEach((i, j, k) =>
            {
                for (int b = 0; b < bytesPerVoxel; b++)
                    texels[i + grid.SizeI * (j + grid.SizeJ * (k / perTexel))] |=
                        (uint)bytes[bytesPerVoxel * grid.Index(i, j, k) + b] << 8 * (b + bytesPerVoxel * (k % perTexel));
            });
            var texture = new Texture3D(grid.SizeI, grid.SizeJ, depth, GraphicsFormat.R32_UInt, TextureCreationFlags.None) { name = name };
            Keep(texture, FilterMode.Point);
            texture.SetPixelData(texels, 0);
            texture.Apply(false, false);
            shader.SetTexture(kernel, name, texture);
        }

        /// <summary>The bytes of the voxels of a packed volume.</summary>
        public static byte[] Unpack(uint[] texels, KernelGrid grid, int bytesPerVoxel)
        {
            int perTexel = 4 / bytesPerVoxel;
            var bytes = new byte[bytesPerVoxel * grid.VoxelCount];
            grid.ForEach((i, j, k) =>
            {
                uint texel = texels[i + grid.SizeI * (j + grid.SizeJ * (k / perTexel))];
                for (int b = 0; b < bytesPerVoxel; b++)
                    bytes[bytesPerVoxel * grid.Index(i, j, k) + b] = (byte)(texel >> 8 * (b + bytesPerVoxel * (k % perTexel)));
            });
            return bytes;
        }

        public void SetPicture<T>(string name, GraphicsFormat format, int width, int height, T[] pixels)
            where T : struct
        {
            var texture = new Texture2D(width, height, format, TextureCreationFlags.None) { name = name };
            Keep(texture, FilterMode.Point);
            texture.SetPixelData(pixels, 0);
            texture.Apply(false, false);
            shader.SetTexture(kernel, name, texture);
        }

        public void SetRows<T>(string name, T[] rows, int stride = 0)
            where T : struct
        {
            int size = Marshal.SizeOf<T>();
            stride = stride > 0 ? stride : size;
            var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, rows.Length * size / stride, stride) { name = name };
            if (buffers.TryGetValue(name, out GraphicsBuffer former))
                former.Dispose();
            buffers[name] = buffer;
            buffer.SetData(rows);
            shader.SetBuffer(kernel, name, buffer);
        }

        public RenderTexture VolumeTarget(string name, GraphicsFormat format, KernelGrid grid)
        {
            var descriptor = new RenderTextureDescriptor(grid.SizeI, grid.SizeJ, format, 0) { dimension = TextureDimension.Tex3D, volumeDepth = grid.SizeK };
            return Target(name, descriptor);
        }

        public RenderTexture PackedTarget(string name, KernelGrid grid, int bytesPerVoxel)
        {
            int perTexel = 4 / bytesPerVoxel;
            return Target(name, new RenderTextureDescriptor(grid.SizeI, grid.SizeJ, GraphicsFormat.R32_UInt, 0)
            {
                dimension = TextureDimension.Tex3D, volumeDepth = (grid.SizeK + perTexel - 1) / perTexel,
            });
        }

        public RenderTexture PictureTarget(string name, GraphicsFormat format, int width, int height) =>
            Target(name, new RenderTextureDescriptor(width, height, format, 0));

        /// <summary>Dispatches over a list of bricks, all of the grid by default, in rows of groups; parts: what of each brick, <see cref="WholeBrick"/> by default.</summary>
        public void DispatchBricks(KernelGrid grid, uint[] bricks = null, int groupsPerRow = 0, uint[] parts = null)
        {
            bricks = bricks ?? grid.AllBricks();
            groupsPerRow = groupsPerRow > 0 ? groupsPerRow : bricks.Length;
            SetBrickCounts(grid, bricks.Length, groupsPerRow);
            SetRows("_Bricks", bricks.Select((brick, n) => new Vector2Int((int)brick, (int)(parts?[n] ?? WholeBrick))).ToArray());
            if (name == "AntiAlias")
                SetRows("_BrickMatter", new Vector2[grid.AllBricks().Length]);
            if (name == "ClipVoxels" || name == "SobelNormals")
                SetSpheresOfBricks(bricks.Length);
            Dispatch(groupsPerRow, (bricks.Length + groupsPerRow - 1) / groupsPerRow);
        }

        public void Dispatch(int groupsX, int groupsY)
        {
            foreach (LocalKeyword any in shader.keywordSpace.keywords)
                shader.DisableKeyword(any); // renderers share the shader, and leave it as they used it last
            foreach (string keyword in keywords)
                if (keyword != null)
                    shader.EnableKeyword(keyword);
            shader.Dispatch(kernel, groupsX, groupsY, 1);
            foreach (string keyword in keywords)
                if (keyword != null)
                    shader.DisableKeyword(keyword);
        }

        public static T[] Read<T>(RenderTexture target)
            where T : struct
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(target, 0);
            request.WaitForCompletion();
            Assert.That(request.hasError, Is.False, target.name + " cannot be read back");
            var all = new List<T>();
            for (int layer = 0; layer < request.layerCount; layer++)
                all.AddRange(request.GetData<T>(layer).ToArray());
            return all.ToArray();
        }

        public uint[] ReadRows(string name)
        {
            var rows = new uint[buffers[name].count * buffers[name].stride / sizeof(uint)];
            buffers[name].GetData(rows);
            return rows;
        }

        public void Dispose()
        {
            foreach (GraphicsBuffer buffer in buffers.Values)
                buffer.Dispose();
            foreach (UnityEngine.Object made in objects)
                UnityEngine.Object.DestroyImmediate(made);
            buffers.Clear();
            objects.Clear();
        }

        RenderTexture Target(string name, RenderTextureDescriptor descriptor)
        {
            descriptor.enableRandomWrite = true;
            descriptor.msaaSamples = 1;
            var target = new RenderTexture(descriptor) { name = name };
            objects.Add(target);
            Assert.That(target.Create(), Is.True, name + " cannot be created");
            shader.SetTexture(kernel, name, target);
            return target;
        }

        /// <summary>Every brick is tested against every sphere.</summary>
        void SetSpheresOfBricks(int bricks)
        {
            var ranges = new uint[2 * bricks];
            for (int b = 0; b < bricks; b++)
                ranges[2 * b + 1] = (uint)spheres;
            var slots = new uint[Math.Max(1, spheres)];
            for (uint s = 0; s < slots.Length; s++)
                slots[s] = s;
            SetRows("_BrickSpheres", ranges, 2 * sizeof(uint));
            SetRows("_SphereSlots", slots);
        }

        void Keep(Texture texture, FilterMode filter)
        {
            texture.filterMode = filter;
            texture.wrapMode = TextureWrapMode.Clamp;
            objects.Add(texture);
        }

        void SetBrickCounts(KernelGrid grid, int bricks, int groupsPerRow)
        {
            shader.SetVector("_VolumeDims", new Vector4(grid.SizeI, grid.SizeJ, grid.SizeK, bricks));
            shader.SetVector("_BrickGrid", new Vector4(grid.BricksI, grid.BricksJ, grid.BricksK, groupsPerRow));
            shader.SetVector("_StoredFirst", Vector4.zero);
            shader.SetVector("_StoredLast", new Vector4(grid.SizeI - 1, grid.SizeJ - 1, grid.SizeK - 1, 0));
        }
    }
}
