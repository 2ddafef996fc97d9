using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The entries in Unity's menus that make this package's GameObjects.</summary>
    static class CarvedVolumeMenu
    {
        const string Folder = "GameObject/AnatomyCarve/";
        const int Priority = 10;

        /// <summary>A volume: of the asset that is selected in the Project window, or without one.</summary>
        [MenuItem(Folder + "Carved Volume", false, Priority)]
        static void CreateVolume(MenuCommand command) => VolumeObjects.CreateVolume(Selection.activeObject as VolumeAsset, command.context as GameObject);

        /// <summary>A pointer; below a volume it points at that one.</summary>
        [MenuItem(Folder + "Segment Pointer", false, Priority + 1)]
        static void CreatePointer(MenuCommand command) => VolumeObjects.CreatePointer(command.context as GameObject);

        /// <summary>A camera for mouse and keys; it looks at the selected volume, or else at any volume of the scene.</summary>
        [MenuItem(Folder + "Mouse Camera", false, Priority + 2)]
        static void CreateMouseCamera(MenuCommand command)
        {
            var context = command.context as GameObject;
            CarvedVolumeRenderer selected = context != null ? context.GetComponentInParent<CarvedVolumeRenderer>() : null;
            VolumeObjects.CreateMouseCamera(selected != null ? selected : Object.FindFirstObjectByType<CarvedVolumeRenderer>());
        }
    }
}
