using System.Collections.Generic;
using System.IO;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Formats;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Phantoms;
using AnatomyCarve.Headless.Cli.Commands;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>The scenes that pictures' errors are measured on: the demo's head, whose matter is opaque, and a phantom of translucent matter.</summary>
    static class ErrorScenes
    {
        public const string DemoHead = "demo head", Translucent = "translucent organs";

        public static readonly string[] Names = [DemoHead, Translucent];

        public static IEnumerable<ErrorScene> All(MeasureContext context) => Names.Select(name => Named(name, context.Stage.Host.PackageRoot));

        /// <summary>A scene by its name.</summary>
        /// <param name="name">one of <see cref="Names"/></param>
        /// <param name="packageRoot">the folder of package.json</param>
        public static ErrorScene Named(string name, string packageRoot) => name switch
        {
            DemoHead => Head(Path.Combine(packageRoot, "Samples~", "DemoHead")),
            Translucent => Organs(),
            _ => throw new CommandException($"there is no scene \"{name}\"."),
        };

        static ErrorScene Head(string folder)
        {
            string Sample(string file) => Path.Combine(folder, file);
            var volume = SegmentedVolumeReader.Read(Sample("Colin27.nrrd"), Sample("Colin27.seg.nrrd"), default, null);
            var carving = CarvingBinding.Bind(CarvingFile.Read(Sample("demo.carving.json")), volume.Segments);
            var spheres = carving.Active == null ? carving.Fixed : [.. carving.Fixed, carving.Active];
            return new ErrorScene(DemoHead, volume, TransferFunctionFile.Read(Sample("Colin27.vp")), spheres, CameraFile.Read(Sample("demo.camera.json")));
        }

        static ErrorScene Organs()
        {
            var volume = TranslucentOrgans.Make();
            var all = SegmentMask.All(volume.Segments.Count);
            ClipSphere[] spheres =
            [
                new(new PointMm(-14, -22, 12), 17, all.With(TranslucentOrgans.Bone, false)), new(new PointMm(20, -18, -9), 12, all),
            ];
            var camera = new PerspectiveCamera(new PointMm(-60, -190, 70), new PointMm(0, 0, 0), new VectorMm(0, 0, 1), 24);
            return new ErrorScene(Translucent, volume, TranslucentOrgans.TransferFunction, spheres, camera);
        }
    }
}
