using UnityEngine;

namespace UnityEditor.SceneManagement
{
    /// <summary>What is edited: the scenes, or a prefab that was opened. Headless no prefab is opened.</summary>
    public static class StageUtility
    {
        /// <summary>Moves a new object into what is edited. It is made in the active scene, where it belongs as long as no prefab is open.</summary>
        public static void PlaceGameObjectInCurrentStage(GameObject gameObject) => MainThread.Check("PlaceGameObjectInCurrentStage");
    }
}
