using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>The report of a rendering as JSON.</summary>
    static class RenderReport
    {
        /// <param name="request">what was asked for</param>
        /// <param name="scene">the scene after rendering</param>
        /// <param name="camera">where it was rendered from</param>
        /// <param name="picture">the picture in main memory</param>
        /// <param name="samples">samples that the rays took, or -1</param>
        /// <param name="warnings">what was odd</param>
        /// <param name="timesMs">milliseconds by step</param>
        public static JsonObject Make(RenderRequest request, RenderScene scene, PerspectiveCamera camera, PictureData picture, long samples,
            IReadOnlyList<string> warnings, IReadOnlyDictionary<string, double> timesMs)
        {
            var quality = scene.Renderer.Quality;
            var statistics = scene.Renderer.Statistics;
            return new JsonObject
            {
                ["volume"] = request.Phantom is { } phantom ? $"phantom {phantom}" : request.VolumePath,
                ["labels"] = request.LabelsPath,
                ["carving"] = request.CarvingPath,
                ["spheres"] = scene.Stack.Carving.Spheres.Count,
                ["transferFunction"] = scene.Renderer.TransferFunction.ToString(),
                ["camera"] = camera.ToJson(),
                ["size"] = new JsonArray(picture.Width, picture.Height),
                ["quality"] = new JsonObject
                {
                    ["name"] = request.QualityName,
                    ["stepReferenceLengths"] = quality.Step,
                    ["cut"] = quality.CutMode.ToString().ToLowerInvariant(),
                    ["filter"] = quality.Filter.ToString().ToLowerInvariant(),
                    ["antiAliasing"] = quality.AntiAliasing,
                    ["firstVisibleAlpha"] = quality.FirstVisibleAlpha,
                    ["opaqueAlpha"] = quality.OpaqueAlpha,
                },
                ["warnings"] = new JsonArray(warnings.Select(warning => (JsonNode)warning).ToArray()),
                ["outputs"] = new JsonObject
                {
                    ["picture"] = FromReport(request, request.OutputPath),
                    ["depth"] = FromReport(request, request.DepthPath),
                    ["segments"] = FromReport(request, request.SegmentsPath),
                },
                ["segments"] = Segments(scene.Loader.Volume.Segments, picture),
                ["stages"] = new JsonArray(
                    Stage("ClipVoxels", statistics.ClipVoxels),
                    Stage("AntiAlias", statistics.AntiAlias),
                    Stage("SobelNormals", statistics.SobelNormals),
                    new JsonObject
                    {
                        ["name"] = "Raymarch",
                        ["dispatches"] = statistics.Raymarch.Dispatches,
                        ["rays"] = statistics.Raymarch.Elements,
                        ["samples"] = samples < 0 ? null : samples,
                    }),
                ["memory"] = Memory(scene),
                ["bytesResident"] = statistics.BytesResident,
                ["resources"] = new JsonArray(statistics.Resources
                    .Select(resource => (JsonNode)new JsonObject { ["name"] = resource.Name, ["bytes"] = resource.Bytes }).ToArray()),
                ["timesMs"] = new JsonObject(timesMs.Select(time => KeyValuePair.Create<string, JsonNode>(time.Key, System.Math.Round(time.Value, 3)))),
                ["device"] = new JsonObject
                {
                    ["name"] = SystemInfo.graphicsDeviceName,
                    ["type"] = SystemInfo.graphicsDeviceType.ToString(),
                    ["version"] = SystemInfo.graphicsDeviceVersion,
                    ["kernelCompiler"] = request.Project.KernelCompiler.ToString().ToLowerInvariant(),
                },
            };
        }

        // Resident without the picture; forecast = as the file is, before anything was made coarser.
        static JsonObject Memory(RenderScene scene)
        {
            var geometry = scene.Loader.Volume.Geometry;
            var resident = scene.Renderer.Statistics.VolumeBytesResident;
            return new JsonObject
            {
                ["voxels"] = new JsonArray(geometry.SizeI, geometry.SizeJ, geometry.SizeK),
                ["layout"] = scene.Renderer.Statistics.Layout.ToString().ToLowerInvariant(),
                ["gpuBytes"] = resident,
                ["gpuBytesPerVoxel"] = System.Math.Round((double)resident / geometry.VoxelCount, 4),
                ["cpuBytes"] = MemoryForecast.Of(scene.Loader.Volume).CpuBytes,
                ["forecast"] = new JsonObject
                {
                    ["sentence"] = scene.Forecast.ToString(),
                    ["gpuBytes"] = scene.Forecast.GpuBytes,
                    ["gpuBytesPerVoxel"] = System.Math.Round(scene.Forecast.GpuBytesPerVoxel, 4),
                    ["cpuBytes"] = scene.Forecast.CpuBytes,
                    ["cpuPeakBytes"] = scene.Forecast.CpuPeakBytes,
                },
            };
        }

        static JsonArray Segments(SegmentTable table, PictureData picture)
        {
            var pixels = new int[table.Count];
            foreach (var index in picture.Segments)
            {
                if (index != PictureData.NoSegment) pixels[index]++;
            }

            return new JsonArray(table.Select(segment => (JsonNode)new JsonObject
            {
                ["index"] = segment.Index,
                ["label"] = segment.Label,
                ["name"] = segment.Name,
                ["visiblePixels"] = pixels[segment.Index],
            }).ToArray());
        }

        static JsonObject Stage(string name, StageStatistics stage) => new()
        {
            ["name"] = name,
            ["dispatches"] = stage.Dispatches,
            ["bricks"] = stage.Bricks,
            ["voxels"] = stage.Elements,
        };

        // Relative to the report, so that the files can be moved together.
        static string FromReport(RenderRequest request, string path) => path == null ? null
            : Path.GetRelativePath(Path.GetDirectoryName(Path.GetFullPath(request.ReportPath))!, Path.GetFullPath(path));
    }
}
