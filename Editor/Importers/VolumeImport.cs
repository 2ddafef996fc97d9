using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEditor.AssetImporters;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// One import of a volume's file. It depends on the file, on its settings and on the segmentation's file alone; it needs no GPU, and writes
    /// nothing but the asset, so that Unity may run it in a worker process. Progress is Unity's to show.
    /// </summary>
    sealed class VolumeImport
    {
        /// <summary>What fixes the fileIDs of an asset's objects: never to be changed.</summary>
        const string Volume = "volume", Data = "data", Thumbnail = "thumbnail", Segmentation = "segmentation";

        const int ThumbnailSize = 128;

        readonly AssetImportContext context;

        public VolumeImport(AssetImportContext context) => this.context = context;

        /// <summary>Reads the file and makes its asset. What is wrong with a file is said in Unity's Console, and no asset is made.</summary>
        public void Run(VolumeImporter settings)
        {
            string scan = context.assetPath;
            string labels = null;
            try
            {
                if (IsSegmentation(settings.Role))
                {
                    ImportSegmentation();
                    return;
                }

                labels = LabelsOf(settings);
                ImportScan(labels);
            }
            catch (AnatomyCarveException e)
            {
                context.LogImportError(InTheProject(e.Message, scan, labels));
            }
        }

        static string Physical(string path) => FileUtil.GetPhysicalPath(path);

        /// <summary>A message with the paths of the project in place of those on this machine's disk.</summary>
        static string InTheProject(string message, params string[] paths) =>
            paths.Where(p => p != null).Aggregate(message, (text, path) => text.Replace(Physical(path), path));

        bool IsSegmentation(VolumeRole role) => role == VolumeRole.Segmentation
            || (role == VolumeRole.Automatic && (VolumeFileNames.IsSegmentation(context.assetPath) || NrrdHeaderPeek.HasSegments(Physical(context.assetPath))));

        /// <summary>The path of the segmentation that goes with the scan; null for none.</summary>
        /// <exception cref="AnatomyCarveException">The chosen file does not exist.</exception>
        string LabelsOf(VolumeImporter settings)
        {
            if (settings.Labels == LabelsChoice.None)
                return null;
            if (settings.Labels == LabelsChoice.File)
                return Chosen(settings.LabelsFile);
            var found = new List<string>();
            foreach (string candidate in VolumeFileNames.SegmentationsOf(context.assetPath))
            {
                // Those that are missing too: when one comes, the scan is imported anew.
                context.DependsOnSourceAsset(candidate);
                if (File.Exists(Physical(candidate)))
                    found.Add(candidate);
            }

            if (found.Count > 1)
            {
                context.LogImportWarning(
                    $"{context.assetPath}: {found.Count} segmentations lie beside it; {found[0]} is used. Choose another in the import settings.");
            }

            return found.FirstOrDefault();
        }

        string Chosen(string file)
        {
            if (string.IsNullOrEmpty(file))
            {
                throw new AnatomyCarveException(
                    $"{context.assetPath}: its import settings choose a segmentation but name no file; expected a path from the scan's folder.");
            }

            string path = VolumeFileNames.Beside(context.assetPath, file);
            context.DependsOnSourceAsset(path);
            if (!File.Exists(Physical(path)))
                throw new AnatomyCarveException($"{context.assetPath}: the segmentation that its import settings name, {path}, does not exist.");
            return path;
        }

        void ImportScan(string labels)
        {
            SegmentedVolume volume = SegmentedVolumeReader.Read(
                Physical(context.assetPath), labels == null ? null : Physical(labels), CancellationToken.None, null);
            foreach (string warning in volume.Warnings)
                context.LogImportWarning(warning);
            string[] sources = new[] { context.assetPath, labels }.Where(p => p != null).Select(Path.GetFileName).ToArray();
            VolumeAsset asset = VolumeAsset.Create(volume, PackedVolume.Write(volume), VolumeThumbnail.Render(volume, ThumbnailSize), sources);
            context.AddObjectToAsset(Volume, asset, asset.Thumbnail);
            context.AddObjectToAsset(Data, asset.Data);
            context.AddObjectToAsset(Thumbnail, asset.Thumbnail);
            context.SetMainObject(asset);
        }

        void ImportSegmentation()
        {
            VolumeData data = VolumeReader.Read(Physical(context.assetPath));
            LabelMap labels = LabelMap.FromVolumeData(data);
            foreach (string warning in data.Warnings.Concat(labels.Warnings))
                context.LogImportWarning($"{Path.GetFileName(context.assetPath)}: {warning}");
            SegmentationAsset asset = SegmentationAsset.Create(labels, Path.GetFileName(context.assetPath));
            context.AddObjectToAsset(Segmentation, asset);
            context.SetMainObject(asset);
        }
    }
}
