using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Scenes
{
    /// <summary>The scenes of a file. Volumes are made when they are first needed; the last two are kept.</summary>
    sealed class BenchScenes
    {
        const int Kept = 2;

        readonly SceneFile file;
        readonly LinkedList<(string Name, SegmentedVolume Volume)> kept = new();

        public BenchScenes(SceneFile file) => this.file = file;

        /// <summary>The names of all scenes.</summary>
        public IReadOnlyCollection<string> Names => file.Scenes.Keys;

        /// <summary>A scene.</summary>
        /// <exception cref="CommandException">The file has none of this name, or the machine lacks its volume.</exception>
        public BenchScene Get(string name)
        {
            if (!file.Scenes.TryGetValue(name, out var text)) throw new CommandException($"there is no scene \"{name}\" in the file of scenes.");
            if (!IsPresent(name)) throw new CommandException($"scene \"{name}\": {file.Volumes[text.Volume].Scan} is not on this machine.");
            return new BenchScene(name, text, VolumeOf(text.Volume));
        }

        /// <summary>Whether the file has the scene and the machine its volume.</summary>
        public bool IsPresent(string name) =>
            file.Scenes.TryGetValue(name, out var text) && (file.Volumes[text.Volume].Scan is not { } scan || File.Exists(Resolve(scan)));

        SegmentedVolume VolumeOf(string name)
        {
            var found = kept.FirstOrDefault(item => item.Name == name);
            if (found.Volume == null) found = (name, Make(file.Volumes[name]));
            kept.Remove(found);
            kept.AddFirst(found);
            if (kept.Count > Kept) kept.RemoveLast();
            return found.Volume;
        }

        static SegmentedVolume Make(VolumeText text)
        {
            if (text.Scan == null)
            {
                var body = new BodyShape(text.Body[0], text.Body[1], text.Body.Length > 2 ? text.Body[2] : double.PositiveInfinity);
                return CtPhantom.Volume(
                    text.Dims[0], text.Dims[1], text.Dims[2], new VectorMm(text.SpacingMm[0], text.SpacingMm[1], text.SpacingMm[2]), text.Organs, body);
            }

            return SegmentedVolumeReader.Read(
                VolumeSource.OfFile(Resolve(text.Scan)), text.Labels == null ? null : VolumeSource.OfFile(Resolve(text.Labels)), CancellationToken.None, null);
        }

        static string Resolve(string path) => Path.GetFullPath(path, BenchFiles.Root);
    }
}
