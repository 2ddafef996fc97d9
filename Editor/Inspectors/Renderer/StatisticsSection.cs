using System;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// What a renderer holds on the GPU and what it has done. Asked for twice a second at most: the list of resources is made anew each time.
    /// </summary>
    sealed class StatisticsSection
    {
        const double SecondsBetween = 0.5;

        static readonly GUIContent Memory = new GUIContent("GPU memory", "Textures and buffers of the volume and its pictures, without the driver's padding");
        static readonly GUIContent Layout = new GUIContent("Texture layout", "How the volume lies in textures; Automatic while it is not on the GPU");
        static readonly GUIContent Dispatches = new GUIContent("Volume kernels run", "They run only when something was edited");
        static readonly GUIContent Bricks = new GUIContent("Bricks computed", "Bricks of 8 x 8 x 8 voxels that were clipped, anti-aliased, given normals");
        static readonly GUIContent Pictures = new GUIContent("Pictures rendered", "By Render; cameras draw by themselves");
        static readonly GUIContent ResetCounts = new GUIContent("Reset counts");

        readonly GUIContent memory = new GUIContent(), layout = new GUIContent();
        readonly GUIContent dispatches = new GUIContent(), bricks = new GUIContent(), pictures = new GUIContent();
        double nextTime;

        public void Draw(RenderStatistics statistics)
        {
            if (Event.current.type == EventType.Layout && EditorApplication.timeSinceStartup >= nextTime)
                Take(statistics);
            EditorGUILayout.LabelField(Memory, memory);
            EditorGUILayout.LabelField(Layout, layout);
            EditorGUILayout.LabelField(Dispatches, dispatches);
            EditorGUILayout.LabelField(Bricks, bricks);
            EditorGUILayout.LabelField(Pictures, pictures);
            if (GUILayout.Button(ResetCounts, EditorStyles.miniButton, GUILayout.ExpandWidth(false)))
            {
                statistics.Reset();
                nextTime = 0;
            }
        }

        void Take(RenderStatistics statistics)
        {
            nextTime = EditorApplication.timeSinceStartup + SecondsBetween;
            memory.text = VolumeSummary.Bytes(statistics.BytesResident);
            layout.text = statistics.Layout.ToString();
            dispatches.text = Number(statistics.VolumeDispatches);
            bricks.text = Number(statistics.ClipVoxels.Bricks) + ", " + Number(statistics.AntiAlias.Bricks) + ", " + Number(statistics.SobelNormals.Bricks);
            pictures.text = Number(statistics.Raymarch.Dispatches);
        }

        static string Number(long number) => FormattableString.Invariant($"{number:N0}");
    }
}
