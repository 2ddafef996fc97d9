using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>A mesh that a camera sees.</summary>
    struct VisibleMesh
    {
        internal DrawItem Item;
        internal int Queue;
        internal int Order;
        internal float Distance;
        internal int Number;
    }

    /// <summary>What a camera sees of the scene and of this frame's meshes: by layer and frustum, sorted for drawing.</summary>
    sealed class VisibleMeshes
    {
        const int LastOpaque = (int)RenderQueue.GeometryLast;

        readonly List<VisibleMesh> m_Opaque = new();
        readonly List<VisibleMesh> m_Transparent = new();
        readonly Camera m_Camera;
        readonly Plane[][] m_Frusta;
        readonly Matrix4x4 m_View;
        int m_Count;

        VisibleMeshes(Camera camera)
        {
            m_Camera = camera;
            m_Frusta = Array.ConvertAll(camera.CullingMatrices(), GeometryUtility.CalculateFrustumPlanes);
            m_View = camera.worldToCameraMatrix;
        }

        /// <summary>From front to back.</summary>
        internal IReadOnlyList<VisibleMesh> Opaque => m_Opaque;

        /// <summary>Those of queues above 2500, from back to front.</summary>
        internal IReadOnlyList<VisibleMesh> Transparent => m_Transparent;

        internal bool IsEmpty => m_Opaque.Count == 0 && m_Transparent.Count == 0;

        internal static VisibleMeshes Of(Camera camera)
        {
            var visible = new VisibleMeshes(camera);
            foreach (var renderer in Renderers.All)
                visible.Add(renderer);
            foreach (var mesh in FrameMeshes.All)
                visible.Add(mesh);
            visible.m_Opaque.Sort(FrontToBack);
            visible.m_Transparent.Sort(BackToFront);
            return visible;
        }

        void Add(Renderer renderer)
        {
            if (!renderer.IsShown || renderer.shadowCastingMode == ShadowCastingMode.ShadowsOnly || !Sees(renderer.Owner.layer))
                return;
            var bounds = renderer.bounds;
            if (!IsInside(bounds))
                return;
            var mesh = renderer.MeshFor(m_Camera);
            if (mesh == null)
                return;
            renderer.MarkSeen();
            var materials = renderer.Materials;
            // Materials beyond the last submesh draw that one again.
            for (var i = 0; i < materials.Count; i++)
                Add(new DrawItem
                {
                    Mesh = mesh,
                    SubMesh = Math.Min(i, mesh.subMeshCount - 1),
                    Material = materials[i],
                    Block = renderer.BlockOf(i),
                    ObjectToWorld = renderer.MeshToWorld,
                }, bounds, renderer.sortingOrder);
        }

        void Add(in FrameMesh mesh)
        {
            if ((mesh.Camera is not null && mesh.Camera != m_Camera) || !Sees(mesh.Layer) || mesh.Shadows == ShadowCastingMode.ShadowsOnly
                || mesh.Item.Mesh == null || mesh.Item.Material == null || !IsInside(mesh.Bounds))
                return;
            Add(mesh.Item, mesh.Bounds, mesh.Priority);
        }

        void Add(in DrawItem item, Bounds bounds, int order)
        {
            var queue = item.Material != null ? item.Material.renderQueue : (int)RenderQueue.Geometry;
            (queue <= LastOpaque ? m_Opaque : m_Transparent).Add(new VisibleMesh
            {
                Item = item,
                Queue = queue,
                Order = order,
                Distance = Distance(bounds.center),
                Number = m_Count++,
            });
        }

        bool IsInside(Bounds bounds) => Array.Exists(m_Frusta, planes => GeometryUtility.TestPlanesAABB(planes, bounds));

        bool Sees(int layer) => (m_Camera.cullingMask & (1 << layer)) != 0;

        // From the eye, or along the view where there is no eye.
        float Distance(Vector3 point)
        {
            var seen = m_View.MultiplyPoint3x4(point);
            return m_Camera.orthographic ? -seen.z : seen.magnitude;
        }

        static int FrontToBack(VisibleMesh a, VisibleMesh b) => Compare(a, b, a.Distance.CompareTo(b.Distance));

        static int BackToFront(VisibleMesh a, VisibleMesh b) => Compare(a, b, b.Distance.CompareTo(a.Distance));

        static int Compare(in VisibleMesh a, in VisibleMesh b, int byDistance)
        {
            var difference = a.Order.CompareTo(b.Order);
            if (difference == 0)
                difference = a.Queue.CompareTo(b.Queue);
            if (difference == 0)
                difference = byDistance;
            return difference != 0 ? difference : a.Number.CompareTo(b.Number);
        }
    }
}
