using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEditor;

namespace AnatomyCarve.Editor
{
    /// <summary>Writes a renderer's <see cref="VolumeAppearance"/> through its SerializedProperty, so that undo and prefab overrides see each edit.</summary>
    sealed class AppearanceProperty
    {
        readonly SerializedProperty custom, points, segments;

        /// <param name="appearance">The property of type <see cref="VolumeAppearance"/>.</param>
        public AppearanceProperty(SerializedProperty appearance)
        {
            custom = appearance.FindPropertyRelative("customTransferFunction");
            points = appearance.FindPropertyRelative("transferFunction");
            segments = appearance.FindPropertyRelative("segments");
        }

        public SerializedProperty Segments => segments;

        public SerializedProperty Points => points;

        /// <summary>Whether several renderers are edited that have different functions.</summary>
        public bool HasMixedFunctions => custom.hasMultipleDifferentValues || points.hasMultipleDifferentValues;

        /// <summary>Lets the function be chosen from each volume's intensities. The points stay, for when that is turned off again.</summary>
        public void SetAutomatic() => custom.boolValue = false;

        public void SetFunction(IReadOnlyList<TransferPoint> function)
        {
            custom.boolValue = true;
            points.arraySize = function.Count;
            for (int p = 0; p < function.Count; p++)
            {
                SerializedProperty point = points.GetArrayElementAtIndex(p);
                point.FindPropertyRelative("value").floatValue = (float)function[p].Value;
                point.FindPropertyRelative("opacity").floatValue = (float)function[p].Opacity;
            }
        }

        /// <summary>Sets one segment's looks, as a slider does many times a second.</summary>
        public void SetSegment(SegmentAppearance look)
        {
            int index = segments.arraySize - 1;
            while (index >= 0 && segments.GetArrayElementAtIndex(index).FindPropertyRelative("label").longValue != look.Label)
                index--;
            if (index < 0)
            {
                index = segments.arraySize;
                segments.arraySize = index + 1;
            }
            Write(index, look);
        }

        /// <summary>Sets all segments that look other than their volume says.</summary>
        public void SetSegments(IReadOnlyList<SegmentAppearance> looks)
        {
            segments.arraySize = looks.Count;
            for (int index = 0; index < looks.Count; index++)
                Write(index, looks[index]);
        }

        void Write(int index, SegmentAppearance look)
        {
            SerializedProperty segment = segments.GetArrayElementAtIndex(index);
            segment.FindPropertyRelative("label").longValue = look.Label;
            segment.FindPropertyRelative("color").colorValue = look.Color;
            segment.FindPropertyRelative("opacity").floatValue = look.Opacity;
        }
    }
}
