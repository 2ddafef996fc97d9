using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The entry in Unity's menus that makes a volume's GameObject.</summary>
    static class CarvedVolumeMenu
    {
        /// <summary>Makes a GameObject that loads, carves and renders a volume, selects it, and can be undone.</summary>
        [MenuItem("GameObject/AnatomyCarve/Carved Volume", false, 10)]
        static void Create(MenuCommand command)
        {
            var volume = new GameObject("Carved Volume", typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer));
            GameObjectUtility.SetParentAndAlign(volume, command.context as GameObject);
            Undo.RegisterCreatedObjectUndo(volume, "Create Carved Volume");
            Selection.activeGameObject = volume;
        }
    }
}
