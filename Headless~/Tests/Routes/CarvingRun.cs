using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Shaders;
using UnityEngine.Shaders.Direct3D;

namespace AnatomyCarve.Headless.Tests.Routes
{
    /// <summary>What the package's components make of a random carving on a host of its own.</summary>
    sealed class CarvingRun
    {
        public const string Opacity = "AnatomyCarve opacity";

        const int Edits = 3;

        readonly List<string> errors = [];

        CarvingRun()
        {
        }

        /// <summary>The volumes on the GPU after each edit, by name, as bytes.</summary>
        public List<Dictionary<string, byte[]>> Volumes { get; } = [];

        /// <summary>A picture after each edit.</summary>
        public List<PictureData> Pictures { get; } = [];

        /// <summary>Samples of each picture.</summary>
        public List<long> Samples { get; } = [];

        /// <summary>Kernels that went by FXC.</summary>
        public int KernelsByFxc { get; private set; }

        public static CarvingRun Of(KernelCompiler compiler, int seed, CutMode cut, TextureLayout layout)
        {
            var run = new CarvingRun();
            int before = ByFxc;
            using (UnityHost host = UnityHost.Start(new HostOptions { KernelCompiler = compiler, Log = run.Remember }))
                run.Carve(new RandomCarving(seed), cut, layout);
            run.KernelsByFxc = ByFxc - before;
            Assert.That(run.errors, Is.Empty, $"{compiler}, seed {seed}");
            return run;
        }

        static int ByFxc => FxcRoute.CompileCount + FxcRoute.CacheHitCount;

        void Carve(RandomCarving carving, CutMode cut, TextureLayout layout)
        {
            var o = new GameObject("Volume", typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer));
            var renderer = o.GetComponent<CarvedVolumeRenderer>();
            renderer.Loader.SetVolume(carving.Volume);
            renderer.TransferFunction = carving.TransferFunction;
            renderer.Layout = layout;
            for (int n = 0; n < Edits; n++)
            {
                // Both variants of the kernel must give the same picture; that with a count is the second.
                renderer.CountSamples = n > 0;
                renderer.Quality = carving.NextQuality(cut);
                carving.Edit(renderer.Stack.Carving);
                CarvedPicture picture = renderer.Render(carving.NextRays());
                Assert.That(picture, Is.Not.Null, renderer.Problem + string.Join("\n", errors));
                Pictures.Add(picture.Read());
                Samples.Add(picture.ReadSampleCount());
                Volumes.Add(Resources.FindObjectsOfTypeAll<RenderTexture>().Where(t => t.dimension == TextureDimension.Tex3D).ToDictionary(t => t.name, Read));
            }
        }

        static byte[] Read(RenderTexture texture)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture);
            request.WaitForCompletion();
            Assert.That(request.hasError, Is.False, texture.name);
            return Enumerable.Range(0, request.layerCount).SelectMany(layer => request.GetData<byte>(layer).ToArray()).ToArray();
        }

        void Remember(LogType type, string message, string stackTrace)
        {
            if (type is LogType.Error or LogType.Exception or LogType.Assert)
                errors.Add(message);
        }
    }
}
