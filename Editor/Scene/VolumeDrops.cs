using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>Volume assets that are dragged from the Project window into the Scene view or the Hierarchy become volumes there.</summary>
    static class VolumeDrops
    {
        [InitializeOnLoadMethod]
        static void Register()
        {
            DragAndDrop.AddDropHandler((DragAndDrop.SceneDropHandler)DropInScene);
            DragAndDrop.AddDropHandler((DragAndDrop.HierarchyDropHandler)DropInHierarchy);
        }

        static DragAndDropVisualMode DropInScene(
            Object dropUpon, Vector3 worldPosition, Vector2 viewportPosition, Transform parentForDraggedObjects, bool perform)
        {
            if (!HoldsVolume())
                return DragAndDropVisualMode.None;
            if (perform)
                foreach (Object dragged in DragAndDrop.objectReferences)
                    if (dragged is VolumeAsset asset)
                        Create(asset, parentForDraggedObjects).transform.position = worldPosition;
            return DragAndDropVisualMode.Copy;
        }

        static DragAndDropVisualMode DropInHierarchy(
            int dropTargetInstanceID, HierarchyDropFlags dropMode, Transform parentForDraggedObjects, bool perform)
        {
            if (!HoldsVolume())
                return DragAndDropVisualMode.None;
            if (!perform)
                return DragAndDropVisualMode.Copy;
            var target = EditorUtility.InstanceIDToObject(dropTargetInstanceID) as GameObject;
            bool upon = (dropMode & HierarchyDropFlags.DropUpon) != 0;
            Transform parent = target == null ? parentForDraggedObjects : upon ? target.transform : target.transform.parent;
            foreach (Object dragged in DragAndDrop.objectReferences)
                if (dragged is VolumeAsset asset)
                    PutBeside(Create(asset, parent).transform, upon ? null : target, (dropMode & HierarchyDropFlags.DropAbove) != 0);
            return DragAndDropVisualMode.Copy;
        }

        static void PutBeside(Transform made, GameObject sibling, bool above)
        {
            if (sibling != null)
                made.SetSiblingIndex(sibling.transform.GetSiblingIndex() + (above ? 0 : 1));
        }

        static GameObject Create(VolumeAsset asset, Transform parent) => VolumeObjects.CreateVolume(asset, parent != null ? parent.gameObject : null);

        static bool HoldsVolume()
        {
            foreach (Object dragged in DragAndDrop.objectReferences)
                if (dragged is VolumeAsset)
                    return true;
            return false;
        }
    }
}
