using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>The box that a volume fills, in its local space: a parallelepiped for grids that are rotated or sheared.</summary>
    static class VolumeBox
    {
        // Corners as VolumeGeometry.CornerOffset has them.
        static readonly int[] Faces =
        {
            0, 4, 6, 2, // low i; seen from outside clockwise where i, j, k are left-handed, as Unity's x, y, z
            1, 3, 7, 5,
            0, 1, 5, 4,
            2, 6, 7, 3,
            0, 2, 3, 1,
            4, 5, 7, 6,
        };

        /// <summary>The box as a mesh whose faces look outwards; destroy it when done.</summary>
        public static Mesh MakeMesh(VolumeGeometry geometry)
        {
            var corners = new Vector3[VolumeGeometry.Corners];
            for (int c = 0; c < VolumeGeometry.Corners; c++)
                corners[c] = Corner(geometry, c);
            var mesh = new Mesh { name = "AnatomyCarve volume box", hideFlags = HideFlags.HideAndDontSave };
            mesh.SetVertices(corners);
            mesh.SetIndices(Triangles(IsLeftHanded(corners)), MeshTopology.Triangles, 0);
            mesh.RecalculateBounds();
            mesh.UploadMeshData(true);
            return mesh;
        }

        /// <summary>The bounds of the box in a space.</summary>
        public static Bounds BoundsIn(VolumeGeometry geometry, in Matrix4x4 localToSpace)
        {
            var bounds = new Bounds(localToSpace.MultiplyPoint3x4(Corner(geometry, 0)), Vector3.zero);
            for (int c = 1; c < VolumeGeometry.Corners; c++)
                bounds.Encapsulate(localToSpace.MultiplyPoint3x4(Corner(geometry, c)));
            return bounds;
        }

        static Vector3 Corner(VolumeGeometry geometry, int corner) =>
            VolumeSpace.LpsToLocal(geometry, geometry.CentreLps + geometry.CornerOffset(corner));

        static bool IsLeftHanded(Vector3[] corners) =>
            Vector3.Dot(Vector3.Cross(corners[1] - corners[0], corners[2] - corners[0]), corners[4] - corners[0]) > 0f;

        static int[] Triangles(bool leftHanded)
        {
            var triangles = new int[Faces.Length / 4 * 6];
            for (int face = 0; face < Faces.Length / 4; face++)
            {
                int a = Faces[4 * face], b = Faces[4 * face + 1], c = Faces[4 * face + 2], d = Faces[4 * face + 3];
                int[] order = leftHanded ? new[] { a, b, c, a, c, d } : new[] { a, c, b, a, d, c };
                order.CopyTo(triangles, 6 * face);
            }
            return triangles;
        }
    }
}
