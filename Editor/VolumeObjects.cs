using AnatomyCarve.Desktop;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>Makes GameObjects of this package in the open scene or prefab: one step to undo, with a name of their own, selected.</summary>
    static class VolumeObjects
    {
        /// <summary>A GameObject that loads, carves and renders a volume.</summary>
        /// <param name="asset">The volume; null = it is to be chosen later.</param>
        /// <param name="parent">Null = none.</param>
        public static GameObject CreateVolume(VolumeAsset asset, GameObject parent)
        {
            string name = asset != null ? asset.name : "Carved Volume";

            // Inactive while it is put together, so that it loads once, and the right volume.
            var volume = new GameObject(name);
            volume.SetActive(false);
            volume.AddComponent<VolumeLoader>().Asset = asset;
            volume.AddComponent<ClipSphereStack>();
            volume.AddComponent<CarvedVolumeRenderer>();
            Place(volume, parent);
            volume.SetActive(true);
            Finish(volume, "Create " + name);
            return volume;
        }

        /// <summary>A GameObject that points at a volume, its parent's unless another one is set.</summary>
        public static GameObject CreatePointer(GameObject parent)
        {
            var pointer = new GameObject("Segment Pointer", typeof(SegmentPointer));
            Place(pointer, parent);
            Finish(pointer, "Create Segment Pointer");
            return pointer;
        }

        /// <summary>A camera that mouse and keys turn around a volume, with a clip sphere and a pointer for the mouse.</summary>
        /// <param name="volume">Null = to be wired later.</param>
        public static GameObject CreateMouseCamera(CarvedVolumeRenderer volume)
        {
            var camera = new GameObject("Mouse Camera", typeof(Camera), typeof(OrbitView), typeof(SegmentPointer), typeof(MouseSphere), typeof(MousePointer));
            camera.GetComponent<Camera>().nearClipPlane = 0.01f;
            camera.GetComponent<SegmentPointer>().Target = volume;
            camera.GetComponent<OrbitView>().Target = volume != null ? volume.transform : null;
            camera.GetComponent<MouseSphere>().Stack = volume != null ? volume.Stack : null;
            Place(camera, null);
            camera.transform.position = (volume != null ? volume.transform.position : Vector3.zero) + DistanceTo(volume) * Vector3.back;
            Finish(camera, "Create Mouse Camera");
            return camera;
        }

        /// <summary>From where a camera of 60 degrees sees all of a volume; an arm's length where it is not loaded.</summary>
        static float DistanceTo(CarvedVolumeRenderer volume) => volume != null && volume.Volume != null
            ? 2f * VolumeBox.BoundsIn(volume.Volume.Geometry, volume.transform.localToWorldMatrix).extents.magnitude
            : 0.6f;

        static void Place(GameObject made, GameObject parent)
        {
            if (parent == null)
                StageUtility.PlaceGameObjectInCurrentStage(made);
            GameObjectUtility.SetParentAndAlign(made, parent);
            GameObjectUtility.EnsureUniqueNameForSibling(made);
        }

        static void Finish(GameObject made, string undoName)
        {
            Undo.RegisterCreatedObjectUndo(made, undoName);
            Selection.activeGameObject = made;
        }
    }
}
