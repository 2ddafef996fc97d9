using UnityEngine;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>The mesh filter and the mesh renderer of a GameObject whose mesh and material are a volume's.</summary>
    sealed class VolumeSurface
    {
        readonly MeshFilter filter;
        readonly MeshRenderer renderer;

        /// <summary>Takes those of a GameObject, or adds them: scenes of before they were required lack them.</summary>
        public VolumeSurface(GameObject owner)
        {
            if (!owner.TryGetComponent(out filter))
                filter = owner.AddComponent<MeshFilter>();
            if (!owner.TryGetComponent(out renderer))
                renderer = owner.AddComponent<MeshRenderer>();
            Clear(); // a clone has its original's
            renderer.shadowCastingMode = ShadowCastingMode.Off; // the shader has no pass for them
            renderer.receiveShadows = false;
        }

        public void Show(Mesh mesh, Material material)
        {
            if (filter.sharedMesh != mesh)
                filter.sharedMesh = mesh;
            if (renderer.sharedMaterial != material)
                renderer.sharedMaterial = material;
        }

        /// <summary>Has cameras draw nothing. Components that were destroyed meanwhile are fine.</summary>
        public void Clear()
        {
            if (filter != null && filter.sharedMesh is object)
                filter.sharedMesh = null;
            if (renderer != null && renderer.sharedMaterial is object)
                renderer.sharedMaterial = null;
        }
    }
}
