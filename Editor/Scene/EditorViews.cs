using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>Draws Scene and Game views anew outside Play, where nothing does it by itself. Volumes that were loaded there ask for it.</summary>
    static class EditorViews
    {
        public static void Refresh()
        {
            if (Application.isPlaying)
                return;
            SceneView.RepaintAll();
            EditorApplication.QueuePlayerLoopUpdate();
        }

        [InitializeOnLoadMethod]
        static void AnswerRequests()
        {
            EditorLink.Refresh = Refresh;
            EditorLink.Paused = () => EditorApplication.isPaused;
        }
    }
}
