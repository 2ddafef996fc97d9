using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using AnatomyCarve.Carving;
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

        public static LoneKernel SobelNormals(VolumeGeometry geometry) => new(AnatomyCarveShaders.Load().SobelNormals, "SobelNormals", geometry);

        public static LoneKernel Raymarch(VolumeGeometry geometry) => new(AnatomyCarveShaders.Load().Raymarch, "Raymarch", geometry);

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
            var list = new GraphicsBuffer(GraphicsBuffer.Target.Structured, all.Length, Marshal.SizeOf<uint>()) { name = "_Bricks" };
            buffers.Add(list);
            list.SetData(all);
            shader.SetBuffer(kernel, "_Bricks", list);
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

        void SetGrid()
        {
            var grid = new CentredGrid(geometry);
            Set("_VolumeDims", geometry.SizeI, geometry.SizeJ, geometry.SizeK);
            Set("_BrickGrid", bricks.BricksX, bricks.BricksY, bricks.BricksZ);
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
