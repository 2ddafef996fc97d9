using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// One kernel by itself, with textures of any format that are made from arrays and bound by their names in Shaders/. The compact layout's textures are
    /// declared as floats, so that fields may be finer than the eight bits that the package stores.
    /// </summary>
    sealed class LoneKernel : IDisposable
    {
        const int GroupSize = 8;

        readonly ComputeShader shader;
        readonly int kernel;
        readonly VolumeGeometry geometry;
        readonly BrickGrid bricks;
        readonly List<UnityEngine.Object> textures = [];
        readonly List<GraphicsBuffer> buffers = [];

        LoneKernel(ComputeShader shader, string name, VolumeGeometry geometry)
        {
            this.shader = shader;
            this.geometry = geometry;
            bricks = new BrickGrid(geometry);
            kernel = shader.FindKernel(name);
            SetGrid();
        }

        /// <summary>Nothing is carved.</summary>
        public static LoneKernel SobelNormals(VolumeGeometry geometry)
        {
            var made = new LoneKernel(AnatomyCarveShaders.Load().SobelNormals, "SobelNormals", geometry);
            made.Set("_CarveCounts", 0, 1, 1);
            made.SetVolume("_Labels", GraphicsFormat.R8_UInt, new byte[geometry.VoxelCount]);
            made.SetRows("_Spheres", new uint[8], 32);
            made.SetRows("_MaskWords", new uint[1], 4);
            made.SetRows("_BrickSpheres", new uint[2 * made.bricks.Count], 8);
            made.SetRows("_SphereSlots", new uint[1], 4);
            return made;
        }

        /// <summary>Every sample is taken.</summary>
        public static LoneKernel Raymarch(VolumeGeometry geometry)
        {
            var made = new LoneKernel(AnatomyCarveShaders.Load().Raymarch, "Raymarch", geometry);
            made.Set("_Skip", 0, RaySettings.PartsOfStep);
            var map = new Texture3D(1, 1, 1, GraphicsFormat.R32_UInt, TextureCreationFlags.None) { name = "_SkipMap" };
            map.SetPixelData(new uint[1], 0);
            map.Apply(false, false);
            made.Bind("_SkipMap", map);
            return made;
        }

        public void Set(string name, float x, float y = 0, float z = 0, float w = 0) => shader.SetVector(name, new Vector4(x, y, z, w));

        public void Set(string name, VectorMm vector) => Set(name, (float)vector.X, (float)vector.Y, (float)vector.Z);

        public void SetInts(string name, params int[] values) => shader.SetInts(name, values);

        public void SetVolume<T>(string name, GraphicsFormat format, T[] voxels) where T : struct
        {
            var texture = new Texture3D(geometry.SizeI, geometry.SizeJ, geometry.SizeK, format, TextureCreationFlags.None) { name = name };
            texture.SetPixelData(voxels, 0);
            texture.Apply(false, false);
            Bind(name, texture);
        }

        public void SetPicture<T>(string name, GraphicsFormat format, int width, int height, T[] pixels) where T : struct
        {
            var texture = new Texture2D(width, height, format, TextureCreationFlags.None) { name = name };
            texture.SetPixelData(pixels, 0);
            texture.Apply(false, false);
            Bind(name, texture);
        }

        public RenderTexture VolumeTarget(string name, GraphicsFormat format)
        {
            var descriptor = new RenderTextureDescriptor(geometry.SizeI, geometry.SizeJ, format, 0);
            descriptor.dimension = TextureDimension.Tex3D;
            descriptor.volumeDepth = geometry.SizeK;
            return Target(name, descriptor);
        }

        public RenderTexture PictureTarget(string name, GraphicsFormat format, int width, int height) =>
            Target(name, new RenderTextureDescriptor(width, height, format, 0));

        /// <summary>Runs over all voxels.</summary>
        public void RunOverVolume()
        {
            var all = bricks.PackAll();
            SetRows("_Bricks", all.SelectMany(brick => new[] { brick, BrickPart.Whole.Packed }).ToArray(), 2 * sizeof(uint));
            Set("_VolumeDims", geometry.SizeI, geometry.SizeJ, geometry.SizeK, all.Length);
            Set("_BrickGrid", bricks.BricksX, bricks.BricksY, bricks.BricksZ, all.Length);
            shader.Dispatch(kernel, all.Length, 1, 1);
        }

        /// <summary>Runs over all pixels.</summary>
        public void RunOverPicture(int width, int height) =>
            shader.Dispatch(kernel, (width + GroupSize - 1) / GroupSize, (height + GroupSize - 1) / GroupSize, 1);

        public void Dispose()
        {
            buffers.ForEach(buffer => buffer.Dispose());
            textures.ForEach(UnityEngine.Object.DestroyImmediate);
        }

        void SetRows(string name, uint[] words, int stride)
        {
            var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, words.Length * sizeof(uint) / stride, stride) { name = name };
            buffers.Add(buffer);
            buffer.SetData(words);
            shader.SetBuffer(kernel, name, buffer);
        }

        void SetGrid()
        {
            var grid = new CentredGrid(geometry);
            Set("_VolumeDims", geometry.SizeI, geometry.SizeJ, geometry.SizeK);
            Set("_BrickGrid", bricks.BricksX, bricks.BricksY, bricks.BricksZ);
            Set("_StoredFirst", 0, 0, 0);
            Set("_StoredLast", geometry.SizeI - 1, geometry.SizeJ - 1, geometry.SizeK - 1);
            for (var row = 0; row < 3; row++)
            {
                Set("_IndexToMm" + row, grid[row, 0], grid[row, 1], grid[row, 2]);
                Set("_MmToIndex" + row, (float)geometry.LpsToIjk[row, 0], (float)geometry.LpsToIjk[row, 1], (float)geometry.LpsToIjk[row, 2]);
            }

            Set("_CentreIndex", grid.CentreI, grid.CentreJ, grid.CentreK, (float)geometry.ReferenceLengthMm);
        }

        RenderTexture Target(string name, RenderTextureDescriptor descriptor)
        {
            descriptor.enableRandomWrite = true;
            descriptor.msaaSamples = 1;
            var target = new RenderTexture(descriptor) { name = name };
            if (!target.Create()) throw new CommandException($"the device cannot make the texture {name} ({descriptor.graphicsFormat}).");
            Bind(name, target);
            return target;
        }

        void Bind(string name, Texture texture)
        {
            texture.filterMode = FilterMode.Bilinear;
            texture.wrapMode = TextureWrapMode.Clamp;
            textures.Add(texture);
            shader.SetTexture(kernel, name, texture);
        }
    }
}
