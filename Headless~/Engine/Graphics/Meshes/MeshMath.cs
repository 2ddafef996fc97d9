namespace UnityEngine
{
    /// <summary>Bounds and normals of vertices.</summary>
    static class MeshMath
    {
        internal static Bounds Bounds(Vector3[] vertices)
        {
            if (vertices.Length == 0)
                return default;
            var bounds = new Bounds(vertices[0], Vector3.zero);
            foreach (var vertex in vertices)
                bounds.Encapsulate(vertex);
            return bounds;
        }

        /// <summary>Clockwise triangles face the viewer.</summary>
        internal static Vector3[] Normals(Vector3[] vertices, int[] triangles)
        {
            var normals = new Vector3[vertices.Length];
            for (var t = 0; t < triangles.Length; t += 3)
            {
                var (a, b, c) = (triangles[t], triangles[t + 1], triangles[t + 2]);
                var normal = Vector3.Cross(vertices[b] - vertices[a], vertices[c] - vertices[a]);
                normals[a] += normal;
                normals[b] += normal;
                normals[c] += normal;
            }
            for (var i = 0; i < normals.Length; i++)
            {
                // Vector3.normalized takes lengths below 1e-5 for zero, which the area of a small triangle is.
                var length = normals[i].magnitude;
                normals[i] = length > 0f ? normals[i] / length : Vector3.zero;
            }
            return normals;
        }

        /// <summary>The box around a transformed box.</summary>
        internal static Bounds Transform(Matrix4x4 matrix, Bounds bounds)
        {
            var e = bounds.extents;
            var reach = new Vector3(
                Mathf.Abs(matrix.m00) * e.x + Mathf.Abs(matrix.m01) * e.y + Mathf.Abs(matrix.m02) * e.z,
                Mathf.Abs(matrix.m10) * e.x + Mathf.Abs(matrix.m11) * e.y + Mathf.Abs(matrix.m12) * e.z,
                Mathf.Abs(matrix.m20) * e.x + Mathf.Abs(matrix.m21) * e.y + Mathf.Abs(matrix.m22) * e.z);
            return new Bounds(matrix.MultiplyPoint3x4(bounds.center), reach * 2f);
        }
    }
}
