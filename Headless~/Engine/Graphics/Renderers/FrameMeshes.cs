using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>A mesh that Graphics.RenderMesh asked for.</summary>
    struct FrameMesh
    {
        internal DrawItem Item;
        internal Camera Camera;
        internal int Layer;
        internal int Priority;
        internal Bounds Bounds;
        internal Rendering.ShadowCastingMode Shadows;
    }

    /// <summary>
    /// Meshes to be drawn in this frame only. As in Unity they live until all cameras have rendered (PostLateUpdate.ClearImmediateRenderers): a camera
    /// that renders twice in a frame draws those of both times.
    /// </summary>
    static class FrameMeshes
    {
        static readonly List<FrameMesh> s_Meshes = new();

        internal static IReadOnlyList<FrameMesh> All => s_Meshes;

        internal static void Add(in RenderParams parameters, Mesh mesh, int subMesh, Matrix4x4 objectToWorld)
        {
            MainThread.Check("Graphics.RenderMesh");
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh));
            if (parameters.material == null)
                throw new ArgumentNullException("rparams.material");
            if (subMesh < 0 || subMesh >= mesh.subMeshCount)
                throw new ArgumentOutOfRangeException("submeshIndex", subMesh, $"The mesh has {mesh.subMeshCount} submeshes");
            var world = parameters.worldBounds;
            s_Meshes.Add(new FrameMesh
            {
                Item = new DrawItem
                {
                    Mesh = mesh,
                    SubMesh = subMesh,
                    Material = parameters.material,
                    Block = parameters.matProps?.Copy(),
                    ObjectToWorld = objectToWorld,
                },
                Camera = parameters.camera,
                Layer = parameters.layer,
                Priority = parameters.rendererPriority,
                Bounds = world.size == Vector3.zero ? MeshMath.Transform(objectToWorld, mesh.bounds) : world,
                Shadows = parameters.shadowCastingMode,
            });
        }

        /// <summary>All cameras have rendered.</summary>
        internal static void Clear() => s_Meshes.Clear();
    }
}
