using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEngine;
using Object = UnityEngine.Object;

namespace AnatomyCarve
{
    /// <summary>The carving that a volume starts with: a text that was edited in the Editor, or else a carving file, or else nothing.</summary>
    sealed class StartCarving
    {
        object carved; // the volume's origin: a volume is large, none is held that is not shown
        string usedText = "";
        TextAsset usedFile;
        string usedFileText;
        int imports;

        /// <summary>Whether the present carving is that of a volume, or of a coarser one of the same data; null = there is none.</summary>
        public bool IsOf(SegmentedVolume volume) => carved == volume?.Origin;

        /// <summary>Whether a volume would start with something else than it did the last time.</summary>
        public bool Differs(string text, TextAsset file)
        {
            if (text != usedText || file != usedFile)
                return true;
            if (imports == EditorLink.Imports)
                return false;
            imports = EditorLink.Imports;
            return TextOf(file) != usedFileText;
        }

        /// <summary>Takes note that the present carving is what a volume would start with.</summary>
        public void SetUsed(string text, TextAsset file)
        {
            usedText = text;
            usedFile = file;
            usedFileText = TextOf(file);
            imports = EditorLink.Imports;
        }

        static string TextOf(TextAsset file) => file != null ? file.text : null;

        /// <summary>The carving of a volume; null where there is no volume. What is odd in it is logged; what cannot be read counts as nothing.</summary>
        /// <param name="document">What it was read from; null = nothing.</param>
        public CarvingStack Of(SegmentedVolume volume, string text, TextAsset file, Object owner, out CarvingDocument document)
        {
            SetUsed(text, file);
            carved = volume?.Origin;
            document = null;
            if (volume == null)
                return null;
            bool edited = !string.IsNullOrEmpty(text);
            if (!edited && file == null)
                return new CarvingStack(volume.Segments.Count);
            try
            {
                document = CarvingFile.Parse(edited ? text : file.text, edited ? $"{owner.name}'s start carving" : file.name);
            }
            catch (CarvingFileException e)
            {
                Debug.LogError($"{owner.name} starts without a carving. {e.Message}", owner);
                return new CarvingStack(volume.Segments.Count);
            }
            CarvingBinding binding = CarvingBinding.Bind(document, volume.Segments);
            foreach (string warning in binding.Warnings)
                Debug.LogWarning(warning, owner);
            return new CarvingStack(volume.Segments.Count, binding.Fixed, binding.Active);
        }
    }
}
