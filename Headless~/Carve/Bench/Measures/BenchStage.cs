using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Error;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Headless.Cli.Commands;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Rendering;

namespace AnatomyCarve.Headless.Cli.Bench.Measures
{
    /// <summary>The engine with one volume's GameObject: what measures of the GPU run on.</summary>
    sealed class BenchStage : IDisposable
    {
        readonly RenderScene scene;

        public BenchStage(RenderProject project, Warnings warnings) => scene = new RenderScene(project, warnings);

        public UnityHost Host => scene.Host;

        public CarvedVolumeRenderer Renderer => scene.Renderer;

        public ClipSphereStack Stack => scene.Stack;

        public CarvingStack Carving => scene.Stack.Carving;

        /// <summary>Shows a volume, uncarved, as a new renderer does.</summary>
        public void Show(SegmentedVolume volume)
        {
            if (scene.Loader.Volume != volume) scene.Loader.SetVolume(volume);
            scene.Host.Step();
            scene.Stack.Clear();
            Carving.HistoryLimit = 0;
            Renderer.Quality = RenderQuality.Balanced();
            Renderer.TransferFunction = null;
            Renderer.Segments = null;
            Renderer.CountSamples = false;
        }

        /// <summary>Shows a scene, with its spheres before they move.</summary>
        public void Show(BenchScene bench)
        {
            Show(bench.Volume);
            Renderer.TransferFunction = bench.TransferFunction;
            if (bench.Segments != null) Renderer.Segments = bench.Segments;
            if (bench.Spheres.Count > 0) Carving.Replace(bench.Spheres.Take(bench.Spheres.Count - 1), bench.Spheres[^1]);
        }

        /// <summary>Brings the volume's textures up to date: a picture of one pixel.</summary>
        public void Update() => Render(new OrbitCamera(0, 0).RaysAround(Renderer.Volume.Geometry, 1, 1));

        /// <summary>Makes a picture; it is the stage's own and used again.</summary>
        public CarvedPicture Render(PictureRays rays)
        {
            var picture = Renderer.Render(rays);
            scene.ThrowIfFailed();
            return picture ?? throw new CommandException($"the volume cannot be rendered: {Renderer.Problem}");
        }

        /// <summary>What the kernels wrote: the volume's textures as they are stored, in the order of their names.</summary>
        public IReadOnlyList<byte[]> ReadTextures() => Resources.FindObjectsOfTypeAll<RenderTexture>()
            .Where(texture => texture.dimension == TextureDimension.Tex3D && texture.name.StartsWith("AnatomyCarve", StringComparison.Ordinal))
            .OrderBy(texture => texture.name, StringComparer.Ordinal)
            .Select(Host.ReadTexture)
            .ToArray();

        /// <summary>The anti-aliased opacities that rays read, one byte per voxel; of the compact layout.</summary>
        public byte[] ReadAntiAliased() => Texels.ReadPackageTexture(Renderer, "AnatomyCarve anti-aliased opacity")
            ?? throw new CommandException("the device cannot write the compact layout.");

        /// <summary>Fails if anything was logged as an error.</summary>
        public void ThrowIfFailed() => scene.ThrowIfFailed();

        public void Dispose() => scene.Dispose();
    }
}
