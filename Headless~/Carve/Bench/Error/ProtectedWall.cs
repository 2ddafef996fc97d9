using System;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Phantoms;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// A block of two segments that meet in a plane; the sphere clips one of them, so that the other stands in the cut as a wall. Normals as seen of
    /// cut and wall, one to four voxels from where they meet, and farther away.
    /// </summary>
    sealed class ProtectedWall
    {
        const double WallX = 4, FaceZ = -13, Near = 1, Far = 4;
        static readonly VectorMm View = new VectorMm(0.45, 0.1, 1).Normalized();

        readonly VolumeGeometry geometry;
        readonly Ball sphere;

        public ProtectedWall(double radiusMm)
        {
            var size = 2 * (int)Math.Ceiling(radiusMm + 6);
            geometry = Grids.Centred(size, size, 32);
            sphere = new Ball(new PointMm(0.31, -0.17, FaceZ), radiusMm);
        }

        public JsonObject Measure(BenchStage stage, RenderQuality quality, int pictureSize)
        {
            stage.Show(PhantomVolumes.OfSegments(geometry, 2, place => place.Z < FaceZ ? 0 : place.X < WallX ? 1 : 2));
            stage.Renderer.TransferFunction = PhantomVolumes.Everything;
            stage.Renderer.Quality = quality;
            stage.Stack.Carving.Replace([new ClipSphere(sphere.Centre, sphere.RadiusMm, SegmentMask.All(3).With(2, false))]);
            var rays = ParallelViews.Along(View, sphere.Centre, 2 * sphere.RadiusMm, pictureSize, 3 * sphere.RadiusMm);
            var seen = SeenNormals.Look(stage.Renderer, rays);
            AngleErrors cutNear = new(), cutFar = new(), wallNear = new(), wallFar = new();
            var otherSegment = 0;
            for (var pixel = 0; pixel < pictureSize * pictureSize; pixel++)
            {
                var ray = rays.RayThroughPixel(pixel % pictureSize, pixel / pictureSize);
                if (!Hit(ray, out var onWall, out var normal, out var fromCorner) || fromCorner < Near) continue;
                if (!onWall && seen.Shows(pixel)) normal = -sphere.NormalAt(ray.At(seen.LitMm[pixel]));
                (onWall ? fromCorner < Far ? wallNear : wallFar : fromCorner < Far ? cutNear : cutFar).Add(seen.Normals[pixel], normal);
                if (seen.Segments[pixel] != (onWall ? 2 : 1)) otherSegment++;
            }

            return new JsonObject
            {
                ["cut, 1 to 4 voxels from the wall"] = cutNear.ToJson(),
                ["cut, farther"] = cutFar.ToJson(),
                ["wall, 1 to 4 voxels from the cut"] = wallNear.ToJson(),
                ["wall, farther"] = wallFar.ToJson(),
                ["pixelsOfAnotherSegment"] = otherSegment,
            };
        }

        /// <summary>What a ray that comes in through the opening meets first, three voxels or more below the face.</summary>
        /// <param name="fromCorner">the distance from where wall and cut meet, across the surface that is hit, mm</param>
        bool Hit(RayMm ray, out bool onWall, out VectorMm normal, out double fromCorner)
        {
            (onWall, normal, fromCorner) = (false, default, 0);
            var opening = ray.At((FaceZ - ray.Origin.Z) / ray.Direction.Z);
            if (opening.X > WallX - 2 || (opening - sphere.Centre).Length > sphere.RadiusMm - 3) return false;
            var toCut = sphere.Crossing(ray).Out;
            var toWall = (WallX - ray.Origin.X) / ray.Direction.X;
            onWall = toWall < toCut;
            var place = ray.At(Math.Min(toCut, toWall));
            normal = onWall ? new VectorMm(-1, 0, 0) : -sphere.NormalAt(place);
            fromCorner = onWall ? sphere.RadiusMm - (place - sphere.Centre).Length : WallX - place.X;
            return place.Z > FaceZ + 3;
        }
    }
}
