using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>The meshes that every project has, in Unity's sizes. Vertices are not in Unity's order.</summary>
    static class MeshPrimitives
    {
        const int Around = 24;

        /// <summary>1 x 1 x 1 about the origin.</summary>
        internal static Mesh Cube()
        {
            var builder = new Builder();
            foreach (var normal in new[] { Vector3.right, Vector3.left, Vector3.up, Vector3.down, Vector3.forward, Vector3.back })
            {
                var up = Mathf.Abs(normal.y) > 0.5f ? Vector3.forward : Vector3.up;
                builder.Face(normal * 0.5f, Vector3.Cross(normal, up) * 0.5f, up * 0.5f, normal);
            }
            return builder.ToMesh("Cube");
        }

        /// <summary>1 x 1 in x and y, seen from -z.</summary>
        internal static Mesh Quad()
        {
            var builder = new Builder();
            builder.Face(Vector3.zero, Vector3.right * 0.5f, Vector3.up * 0.5f, Vector3.back);
            return builder.ToMesh("Quad");
        }

        /// <summary>10 x 10 in x and z, in 10 x 10 squares, seen from above.</summary>
        internal static Mesh Plane()
        {
            const int squares = 10;
            var builder = new Builder();
            for (var z = 0; z <= squares; z++)
                for (var x = 0; x <= squares; x++)
                    builder.Vertex(new Vector3(x - squares * 0.5f, 0, z - squares * 0.5f), Vector3.up,
                        new Vector2((float)x / squares, (float)z / squares));
            builder.Grid(0, squares, squares);
            return builder.ToMesh("Plane");
        }

        /// <summary>Of radius 0.5.</summary>
        internal static Mesh Sphere() => Round("Sphere", 0f);

        /// <summary>Of radius 0.5 and height 2.</summary>
        internal static Mesh Capsule() => Round("Capsule", 0.5f);

        /// <summary>Of radius 0.5 and height 2.</summary>
        internal static Mesh Cylinder()
        {
            var builder = new Builder();
            for (var end = 0; end <= 1; end++)
                for (var i = 0; i <= Around; i++)
                {
                    var outward = Direction(i, Around);
                    builder.Vertex(outward * 0.5f + Vector3.up * (end * 2 - 1), outward, new Vector2((float)i / Around, end));
                }
            builder.Grid(0, Around, 1);
            builder.Disc(Vector3.up, Vector3.up);
            builder.Disc(Vector3.down, Vector3.down);
            return builder.ToMesh("Cylinder");
        }

        /// <summary>Two half spheres, each moved away from the middle.</summary>
        static Mesh Round(string name, float apart)
        {
            const int halfRings = Around / 4;
            var builder = new Builder();
            var rings = 0;
            for (var half = 0; half <= 1; half++)
                for (var ring = 0; ring <= halfRings; ring++, rings++)
                {
                    var latitude = (half * halfRings + ring) * Mathf.PI / (2 * halfRings) - Mathf.PI / 2;
                    for (var i = 0; i <= Around; i++)
                    {
                        var normal = Direction(i, Around) * Mathf.Cos(latitude) + Vector3.up * Mathf.Sin(latitude);
                        var position = normal * 0.5f + Vector3.up * (apart * (half * 2 - 1));
                        builder.Vertex(position, normal, new Vector2((float)i / Around, (position.y + 0.5f + apart) / (1 + 2 * apart)));
                    }
                }
            builder.Grid(0, Around, rings - 1);
            return builder.ToMesh(name);
        }

        // To the right for one who looks at it from outside, so that a grid of it is seen from there.
        static Vector3 Direction(int step, int steps)
        {
            var angle = step * 2 * Mathf.PI / steps;
            return new Vector3(Mathf.Cos(angle), 0, Mathf.Sin(angle));
        }

        sealed class Builder
        {
            readonly List<Vector3> m_Vertices = new();
            readonly List<Vector3> m_Normals = new();
            readonly List<Vector2> m_Uvs = new();
            readonly List<int> m_Triangles = new();

            internal void Vertex(Vector3 position, Vector3 normal, Vector2 uv)
            {
                m_Vertices.Add(position);
                m_Normals.Add(normal);
                m_Uvs.Add(uv);
            }

            /// <summary>A rectangle whose right side and upper side, for one who sees it from where the normal points to, are given.</summary>
            internal void Face(Vector3 centre, Vector3 right, Vector3 up, Vector3 normal)
            {
                var first = m_Vertices.Count;
                for (var y = -1; y <= 1; y += 2)
                    for (var x = -1; x <= 1; x += 2)
                        Vertex(centre + x * right + y * up, normal, new Vector2((x + 1) / 2, (y + 1) / 2));
                Square(first, first + 1, first + 2, first + 3);
            }

            internal void Disc(Vector3 centre, Vector3 normal)
            {
                var first = m_Vertices.Count;
                Vertex(centre, normal, new Vector2(0.5f, 0.5f));
                for (var i = 0; i <= Around; i++)
                {
                    // Clockwise as seen from where the normal points to.
                    var outward = Direction(i, Around);
                    if (normal.y > 0)
                        outward.z = -outward.z;
                    Vertex(centre + outward * 0.5f, normal, new Vector2(outward.x + 1, outward.z + 1) * 0.5f);
                }
                for (var i = 1; i <= Around; i++)
                    m_Triangles.AddRange(new[] { first, first + i, first + i + 1 });
            }

            /// <summary>Squares between rows of vertices: each row runs to the right, the next one lies above.</summary>
            internal void Grid(int first, int columns, int rows)
            {
                for (var row = 0; row < rows; row++)
                    for (var column = 0; column < columns; column++)
                    {
                        var corner = first + row * (columns + 1) + column;
                        Square(corner, corner + 1, corner + columns + 1, corner + columns + 2);
                    }
            }

            internal Mesh ToMesh(string name)
            {
                var mesh = new Mesh { name = name };
                mesh.SetVertices(m_Vertices);
                mesh.SetNormals(m_Normals);
                mesh.SetUVs(0, m_Uvs);
                mesh.triangles = m_Triangles.ToArray();
                return mesh;
            }

            void Square(int lowerLeft, int lowerRight, int upperLeft, int upperRight) =>
                m_Triangles.AddRange(new[] { lowerLeft, upperLeft, upperRight, lowerLeft, upperRight, lowerRight });
        }
    }
}
