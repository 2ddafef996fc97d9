using System;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Phantoms;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>A cut's surface as it is seen, against the sphere.</summary>
    /// <param name="Normals">against the sphere's where the light comes from</param>
    /// <param name="AtSurface">against the sphere's where the ray meets it</param>
    /// <param name="LitMeanVoxels">how far behind the sphere the light comes from</param>
    sealed record CutErrors(AngleErrors Normals, AngleErrors AtSurface, double DepthRmsVoxels, double DepthMeanVoxels, double LitMeanVoxels, int Missing)
    {
        public JsonObject ToJson()
        {
            var json = Normals.ToJson();
            json["againstTheSurfaceThatTheRayMeets"] = AtSurface.ToJson();
            json["depthRmsVoxels"] = DepthRmsVoxels;
            json["depthMeanVoxels"] = DepthMeanVoxels;
            json["litMeanVoxels"] = LitMeanVoxels;
            json["pixelsWithoutHit"] = Missing;
            return json;
        }
    }

    /// <summary>An opaque block whose front face has a clip sphere's half in it, seen from the front and aslant.</summary>
    sealed class CutBlock
    {
        const double MarginVoxels = 3;
        static readonly double MostSlanted = Math.Cos(70 * Math.PI / 180);
        static readonly VectorMm[] Views = [new VectorMm(0, 0, 1), new VectorMm(0.35, -0.25, 1).Normalized()];

        readonly VolumeGeometry geometry;
        readonly Ball sphere;
        readonly double faceZ;

        /// <param name="radiusMm">the sphere's</param>
        /// <param name="spacing">of the voxels, mm</param>
        public CutBlock(double radiusMm, double[] spacing)
        {
            int Voxels(double lengthMm, double spacingMm) => (int)Math.Ceiling(lengthMm / spacingMm + 4 * MarginVoxels);
            geometry = Grids.Centred(
                Voxels(2 * radiusMm, spacing[0]), Voxels(2 * radiusMm, spacing[1]), Voxels(radiusMm, spacing[2]), spacing[0], spacing[1], spacing[2]);
            faceZ = geometry.CornerOffset(0).Z + MarginVoxels * spacing[2];
            sphere = new Ball(new PointMm(0.31, -0.17, faceZ), radiusMm);
        }

        /// <param name="pictureSize">of the pictures that are looked at, pixels along a side</param>
        public CutErrors Measure(BenchStage stage, RenderQuality quality, int pictureSize)
        {
            stage.Show(PhantomVolumes.OfSegments(geometry, 1, place => place.Z > faceZ ? 1 : 0));
            stage.Renderer.TransferFunction = PhantomVolumes.Everything;
            stage.Renderer.Quality = quality;
            stage.Stack.Carving.Replace([new ClipSphere(sphere.Centre, sphere.RadiusMm, SegmentMask.All(2))]);
            AngleErrors normals = new(), atSurface = new();
            double sum = 0, sumOfSquares = 0, litSum = 0;
            int seenPixels = 0, missing = 0;
            foreach (var view in Views)
            {
                var rays = ParallelViews.Along(view, sphere.Centre, 2 * sphere.RadiusMm, pictureSize, 3 * sphere.RadiusMm);
                var seen = SeenNormals.Look(stage.Renderer, rays);
                for (var pixel = 0; pixel < pictureSize * pictureSize; pixel++)
                {
                    var ray = rays.RayThroughPixel(pixel % pictureSize, pixel / pictureSize);
                    if (!MeetsCut(ray, out var depthMm)) continue;
                    if (!seen.Shows(pixel))
                    {
                        missing++;
                        continue;
                    }

                    normals.Add(seen.Normals[pixel], -sphere.NormalAt(ray.At(seen.LitMm[pixel])));
                    atSurface.Add(seen.Normals[pixel], -sphere.NormalAt(ray.At(depthMm)));

                    var error = (seen.DepthsMm[pixel] - depthMm) / geometry.ReferenceLengthMm;
                    sum += error;
                    litSum += (seen.LitMm[pixel] - depthMm) / geometry.ReferenceLengthMm;
                    sumOfSquares += error * error;
                    seenPixels++;
                }
            }

            return new CutErrors(normals, atSurface, Math.Sqrt(sumOfSquares / seenPixels), sum / seenPixels, litSum / seenPixels, missing);
        }

        /// <summary>Whether a ray comes in through the cut's opening and meets the cut well below the face, at no grazing angle.</summary>
        bool MeetsCut(RayMm ray, out double depthMm)
        {
            var margin = MarginVoxels * geometry.SpacingMm.Z;
            var opening = ray.At((faceZ - ray.Origin.Z) / ray.Direction.Z);
            depthMm = sphere.Crossing(ray).Out;
            if (double.IsNaN(depthMm) || (opening - sphere.Centre).Length > sphere.RadiusMm - margin) return false;
            var place = ray.At(depthMm);
            return place.Z > faceZ + margin && sphere.NormalAt(place).Dot(ray.Direction) >= MostSlanted;
        }
    }
}
