using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace AnatomyCarve.Headless.Cli.Bench.Scenes
{
    /// <summary>A file of scenes: volumes, cameras, spheres and moves, each under its name.</summary>
    sealed record SceneFile
    {
        /// <summary>The version that this program reads.</summary>
        public const int KnownVersion = 1;

        static readonly JsonSerializerOptions Options = new(JsonSerializerDefaults.Web)
        {
            UnmappedMemberHandling = JsonUnmappedMemberHandling.Disallow,
            ReadCommentHandling = JsonCommentHandling.Skip,
        };

        public required int Version { get; init; }

        public required Dictionary<string, VolumeText> Volumes { get; init; }

        public required Dictionary<string, SceneText> Scenes { get; init; }

        /// <summary>The committed scenes, in the package's checkout.</summary>
        /// <exception cref="CommandException">The program lies outside of a checkout.</exception>
        public static string DefaultPath => BenchFiles.Find("scenes.json");

        /// <exception cref="CommandException">It cannot be read, or says something that makes no sense; the message says what.</exception>
        public static SceneFile Read(string path)
        {
            SceneFile file;
            try
            {
                file = JsonSerializer.Deserialize<SceneFile>(File.ReadAllText(path), Options);
            }
            catch (JsonException exception)
            {
                throw new CommandException($"{path}: not a file of scenes: {exception.Message}");
            }

            if (file.Version != KnownVersion) throw new CommandException($"{path}: version {file.Version} is not known; this program reads {KnownVersion}.");
            foreach (var (name, volume) in file.Volumes)
            {
                if (volume.Problem() is { } problem) throw new CommandException($"{path}: volume \"{name}\": {problem}.");
            }

            foreach (var (name, scene) in file.Scenes)
            {
                if (scene.Problem(file.Volumes.Keys) is { } problem) throw new CommandException($"{path}: scene \"{name}\": {problem}.");
            }

            return file;
        }
    }

    /// <summary>A volume: a phantom of a size, or files.</summary>
    sealed record VolumeText
    {
        /// <summary>A phantom's voxels along i, j, k.</summary>
        public int[] Dims { get; init; }

        /// <summary>Its spacing along i, j, k.</summary>
        public double[] SpacingMm { get; init; }

        /// <summary>Its organs.</summary>
        public int Organs { get; init; }

        /// <summary>The half axes of its body, as parts of its sides; without the third the body has no ends.</summary>
        public double[] Body { get; init; }

        /// <summary>Or the scan's file, relative to the checkout. Where it does not exist, its scenes are left out.</summary>
        public string Scan { get; init; }

        public string Labels { get; init; }

        public string Problem()
        {
            if (Scan != null) return Dims == null ? null : "either a phantom's \"dims\" or a \"scan\"";
            if (Dims is not { Length: 3 } || Dims.Any(side => side is < 1 or > 2048)) return "\"dims\" are three numbers from 1 to 2048";
            if (SpacingMm is not { Length: 3 } || SpacingMm.Any(spacing => !(spacing > 0))) return "\"spacingMm\" are three numbers above 0";
            if (Organs is < 0 or > 255) return "\"organs\" are 0 to 255";
            return Body is { Length: 2 or 3 } && Body.All(axis => axis > 0) ? null : "\"body\" are two or three numbers above 0";
        }
    }

    /// <summary>A clip sphere; places are relative to the volume's centre, LPS.</summary>
    sealed record SphereText
    {
        public double[] CentreMm { get; init; }

        public double RadiusMm { get; init; }

        /// <summary>The segments that it does not clip.</summary>
        public int[] Spared { get; init; } = [];
    }

    /// <summary>What is shown of a volume, and what happens to it.</summary>
    sealed record SceneText
    {
        public string Volume { get; init; }

        /// <summary>value:opacity,value:opacity,...</summary>
        public string TransferFunction { get; init; }

        /// <summary>The segments that are shown; absent = all.</summary>
        public int[] Shown { get; init; }

        /// <summary>Azimuth, elevation and field of view of a camera that sees the whole volume, degrees.</summary>
        public double[] Camera { get; init; } = [20, 10, 30];

        /// <summary>The picture's pixels.</summary>
        public int[] Size { get; init; } = [512, 512];

        /// <summary>The spheres; the last one is the active one.</summary>
        public SphereText[] Spheres { get; init; } = [];

        /// <summary>So many further spheres of this radius on a lattice over the volume, before the others.</summary>
        public int Crowd { get; init; }

        public double CrowdRadiusMm { get; init; }

        /// <summary>How far the crowd's spheres stay away from the last sphere's surface; absent = they are everywhere.</summary>
        public double? CrowdAwayMm { get; init; }

        /// <summary>How far the active sphere moves, LPS.</summary>
        public double[] MoveMm { get; init; }

        /// <summary>The segment of the active sphere's mask that is toggled.</summary>
        public int? Toggled { get; init; }

        public string Problem(IReadOnlyCollection<string> volumes)
        {
            if (Volume == null || !volumes.Contains(Volume)) return $"there is no volume \"{Volume}\"";
            if (Camera is not { Length: 3 }) return "\"camera\" is azimuth, elevation and field of view";
            if (Size is not { Length: 2 } || Size.Any(side => side is < 1 or > 4096)) return "\"size\" are two numbers from 1 to 4096";
            if (Spheres.Any(sphere => sphere.CentreMm is not { Length: 3 } || !(sphere.RadiusMm >= 0))) return "spheres have \"centreMm\" and \"radiusMm\"";
            if (MoveMm != null && (MoveMm.Length != 3 || Spheres.Length == 0)) return "\"moveMm\" are three numbers, and there is a sphere to move";
            return Toggled != null && Spheres.Length == 0 ? "there is no sphere whose mask could be toggled" : null;
        }
    }
}
