using System;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Phantoms;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// What anti-aliasing leaves of plates and vessels that are two voxels thick: the mean of the anti-aliased opacity over the voxels that a label
    /// map gives them, all of opacity 1, away from their ends.
    /// </summary>
    static class ThinStructures
    {
        const int Size = 32;
        const double HalfThickness = 1;
        const double Inner = 10; // voxels from the middle that count

        // The offset from the middle makes an upright plate two voxels thick and an upright vessel two voxels wide.
        static readonly (string Name, VectorMm Direction)[] Directions =
        [
            ("upright", new VectorMm(0, 0, 1)), ("45 degrees", new VectorMm(0, 1, 1)),
            ("diagonal", new VectorMm(1, 1, 1)), ("oblique", new VectorMm(0.3, 0.5, 1)),
        ];


        /// <summary>Percent by structure; null where the device has no compact layout.</summary>
        public static JsonObject Kept(BenchStage stage)
        {
            var kept = new JsonObject();
            foreach (var (name, direction) in Directions)
            {
                var axis = direction.Normalized();
                var plate = Measure(stage, place => Math.Abs(place.Dot(axis)) < HalfThickness);
                var vessel = Measure(stage, place => place.Cross(axis).Length < HalfThickness);
                if (plate == null) return null;
                kept[$"plate, {name}"] = plate;
                kept[$"vessel, {name}"] = vessel;
            }

            return kept;
        }

        static double? Measure(BenchStage stage, Func<VectorMm, bool> holds)
        {
            var geometry = Grids.Centred(Size, Size, Size);
            var volume = PhantomVolumes.OfSegments(geometry, 1, place => holds(place - geometry.CentreLps) ? 1 : 0);
            stage.Show(volume);
            stage.Renderer.TransferFunction = PhantomVolumes.Everything;
            stage.Renderer.Render(ParallelViews.Along(new VectorMm(0, 0, 1), geometry.CentreLps, 10, 8, 100));
            var codes = Texels.ReadPackageTexture(stage.Renderer, "AnatomyCarve anti-aliased opacity");
            if (codes == null) return null;
            double sum = 0;
            var voxels = 0;
            Grids.ForEach(geometry, (i, j, k, voxel) =>
            {
                var fromMiddle = geometry.IjkToLps.TransformPoint(new PointMm(i, j, k)) - geometry.CentreLps;
                if (volume.Labels.Indices[voxel] != 1 || fromMiddle.Length > Inner) return;
                sum += codes[voxel] / 255.0;
                voxels++;
            });
            return 100 * sum / voxels;
        }
    }
}
