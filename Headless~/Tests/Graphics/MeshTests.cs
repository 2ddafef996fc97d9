using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Draw = UnityEngine.Graphics;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>Meshes: their data, their checks, and every kind of them drawn.</summary>
    public sealed class MeshTests : DrawTest
    {
        static readonly Vector3[] s_Corners = { new(0, 0, 0), new(0, 1, 0), new(1, 1, 0), new(1, 0, 0) };

        [Test]
        public void Data_IsKeptAndCopied()
        {
            var mesh = Square();
            mesh.normals = Enumerable.Repeat(Vector3.back, 4).ToArray();
            mesh.colors32 = Enumerable.Repeat(new Color32(255, 0, 51, 255), 4).ToArray();
            mesh.SetUVs(1, s_Corners.Select(c => new Vector4(c.x, c.y, 5, 6)).ToArray());
            Assert.That((mesh.vertexCount, mesh.subMeshCount, mesh.triangles.Length), Is.EqualTo((4, 1, 6)));
            Assert.That(mesh.bounds, Is.EqualTo(new Bounds(new Vector3(0.5f, 0.5f, 0), new Vector3(1, 1, 0))), "with the triangles");
            Assert.That(mesh.colors[3].b, Is.EqualTo(0.2f).Within(1e-6));
            var coordinates = new List<Vector4>();
            mesh.GetUVs(1, coordinates);
            Assert.That(coordinates[2], Is.EqualTo(new Vector4(1, 1, 5, 6)));
            mesh.vertices[0] = Vector3.one;
            Assert.That(mesh.vertices[0], Is.EqualTo(Vector3.zero), "arrays are copies");
            var copy = Own(UnityEngine.Object.Instantiate(mesh));
            mesh.Clear();
            Assert.That((copy.vertexCount, mesh.vertexCount, mesh.triangles.Length), Is.EqualTo((4, 0, 0)));
        }

        [Test]
        public void Bounds_FollowWhenTheyAreAskedTo()
        {
            var mesh = Square();
            mesh.vertices = s_Corners.Select(c => 3 * c).ToArray();
            Assert.That(mesh.bounds.size.x, Is.EqualTo(1));
            mesh.RecalculateBounds();
            Assert.That(mesh.bounds.size.x, Is.EqualTo(3));
        }

        [Test]
        public void Normals_AreComputedFromTriangles()
        {
            var mesh = Square();
            mesh.RecalculateNormals();
            Assert.That(mesh.normals, Has.All.EqualTo(Vector3.back), "clockwise for who looks along +z");
        }

        [Test]
        public void WrongData_IsRefusedWithAnError()
        {
            var mesh = Square();
            LogAssert.Expect(LogType.Error, new Regex("Mesh.normals is out of bounds"));
            mesh.normals = new Vector3[3];
            LogAssert.Expect(LogType.Error, new Regex("referencing out of bounds vertices"));
            mesh.triangles = new[] { 0, 1, 4 };
            LogAssert.Expect(LogType.Error, new Regex("must be a multiple of 3"));
            mesh.triangles = new[] { 0, 1 };
            LogAssert.Expect(LogType.Error, new Regex("Submesh index is out of bounds"));
            mesh.SetTriangles(new[] { 0, 1, 2 }, 1);
            LogAssert.Expect(LogType.Error, new Regex("vertex array has less vertices"));
            mesh.vertices = new Vector3[2];
            Assert.That(mesh.triangles, Has.Length.EqualTo(6), "nothing changed");
        }

        [Test]
        public void WideIndices_AreNeededBeyond65535()
        {
            var mesh = Own(new Mesh { vertices = new Vector3[70000] });
            LogAssert.Expect(LogType.Error, new Regex("does not fit into 16 bits"));
            mesh.SetIndices(new[] { 0, 1, 69999 }, MeshTopology.Triangles, 0);
            mesh.indexFormat = IndexFormat.UInt32;
            mesh.SetIndices(new[] { 0, 1, 69999 }, MeshTopology.Triangles, 0);
            Assert.That(mesh.GetIndexCount(0), Is.EqualTo(3));
        }

        [Test]
        public void Uploaded_AndNoLongerReadable_IsDrawnButNotRead()
        {
            var mesh = Square();
            mesh.UploadMeshData(true);
            Assert.That(mesh.isReadable, Is.False);
            LogAssert.Expect(LogType.Error, new Regex("isReadable is false"));
            Assert.That(mesh.vertices, Is.Empty);
            Assert.That(Covered(mesh), Is.EqualTo(Size * Size));
        }

        [Test]
        public void ChangedMesh_IsDrawnAsItIsNow()
        {
            var mesh = Square();
            Assert.That(Covered(mesh), Is.EqualTo(Size * Size));
            mesh.vertices = s_Corners.Select(c => c / 2).ToArray();
            Assert.That(Covered(mesh), Is.EqualTo(Size * Size / 4));
        }

        [TestCase(MeshTopology.Triangles, new[] { 0, 1, 2 }, Size * (Size + 1) / 2, Size)]
        [TestCase(MeshTopology.Quads, new[] { 0, 1, 2, 3 }, Size * Size, 0)]
        [TestCase(MeshTopology.Lines, new[] { 0, 2 }, Size, 1)]
        [TestCase(MeshTopology.LineStrip, new[] { 0, 2, 3 }, 2 * Size, 2)]
        [TestCase(MeshTopology.Points, new[] { 4, 5, 6 }, 3, 0)]
        public void Topologies_AreDrawn(MeshTopology topology, int[] indices, int pixels, int tolerance)
        {
            var mesh = Own(new Mesh
            {
                vertices = s_Corners.Concat(new[] { new Vector3(0.11f, 0.11f, 0), new Vector3(0.51f, 0.51f, 0), new Vector3(0.8f, 0.3f, 0) }).ToArray(),
            });
            mesh.SetIndices(indices, topology, 0);
            Assert.That(mesh.GetTopology(0), Is.EqualTo(topology));
            Assert.That(Covered(mesh), Is.EqualTo(pixels).Within(tolerance));
        }

        [Test]
        public void SubMeshes_AreDrawnWithTheirMaterials()
        {
            var mesh = Own(new Mesh { vertices = s_Corners.Select(c => 4 * (c - new Vector3(0.5f, 0.5f, 0))).ToArray(), subMeshCount = 2 });
            mesh.SetTriangles(new[] { 0, 1, 2 }, 0);
            mesh.SetTriangles(new[] { 0, 2, 3 }, 1);
            Assert.That((mesh.GetSubMesh(1).indexStart, mesh.GetSubMesh(1).indexCount), Is.EqualTo((3, 3)));
            var renderer = Object(mesh, null, Vector3.zero).GetComponent<Renderer>();
            var colors = new[] { Color.red, Color.blue };
            renderer.sharedMaterials = colors.Select(c =>
            {
                var material = Material("Box");
                material.SetColor("_Color", c);
                return material;
            }).ToArray();
            var target = Target();
            Camera(target).Render();
            Assert.That(Pixel(target, 12, 20), Is.EqualTo(Color.red), "above the diagonal");
            Assert.That(Pixel(target, 20, 12), Is.EqualTo(Color.blue), "below it");
        }

        [Test]
        public void BaseVertex_IsAdded()
        {
            var mesh = Own(new Mesh { vertices = new Vector3[10].Concat(s_Corners).ToArray() });
            mesh.SetTriangles(new[] { 0, 1, 2, 0, 2, 3 }, 0, true, 10);
            Assert.That(Covered(mesh), Is.EqualTo(Size * Size));
        }

        [Test]
        public void AttributesThatAMeshLacks_AreWhite_Or0()
        {
            var target = Target();
            var mesh = Own(new Mesh { vertices = s_Corners, triangles = new[] { 0, 1, 2, 0, 2, 3 } });
            DrawNow(target, mesh, BuiltinAssets.Material(BuiltinAssets.SpritesDefault));
            Assert.That(Pixel(target, 5, 5), Is.EqualTo(Color.white), "the colour of vertices");
        }

        [Test]
        public void Primitives_AreUnitysInSize()
        {
            Assert.That(Of(BuiltinAssets.Cube).bounds.size, Is.EqualTo(Vector3.one));
            Assert.That(Of(BuiltinAssets.Quad).bounds.size, Is.EqualTo(new Vector3(1, 1, 0)));
            Assert.That(Of(BuiltinAssets.Plane).bounds.size, Is.EqualTo(new Vector3(10, 0, 10)));
            Assert.That((Of(BuiltinAssets.Sphere).bounds.size - Vector3.one).magnitude, Is.LessThan(0.01f));
            Assert.That((Of(BuiltinAssets.Cylinder).bounds.size - new Vector3(1, 2, 1)).magnitude, Is.LessThan(0.01f));
            Assert.That((Of(BuiltinAssets.Capsule).bounds.size - new Vector3(1, 2, 1)).magnitude, Is.LessThan(0.01f));
        }

        [Test]
        public void Primitives_AreClosed_AndFaceOutwards(
            [Values(PrimitiveType.Sphere, PrimitiveType.Capsule, PrimitiveType.Cylinder, PrimitiveType.Cube)] PrimitiveType type)
        {
            var mesh = Own(GameObject.CreatePrimitive(type)).GetComponent<MeshFilter>().sharedMesh;
            var (vertices, normals, triangles) = (mesh.vertices, mesh.normals, mesh.triangles);
            var edges = new Dictionary<(Vector3Int, Vector3Int), int>();
            for (var t = 0; t < triangles.Length; t += 3)
            {
                var (a, b, c) = (vertices[triangles[t]], vertices[triangles[t + 1]], vertices[triangles[t + 2]]);
                var face = Vector3.Cross(b - a, c - a);
                if (face.magnitude < 1e-7f)
                    continue;
                Assert.That(Vector3.Dot(face, (a + b + c) / 3), Is.Positive, "clockwise from outside");
                Assert.That(Vector3.Dot(face, normals[triangles[t]]), Is.Positive);
                foreach (var (from, to) in new[] { (a, b), (b, c), (c, a) })
                    edges[(Rounded(from), Rounded(to))] = 1 + (edges.TryGetValue((Rounded(from), Rounded(to)), out var count) ? count : 0);
            }
            Assert.That(edges.All(e => edges.ContainsKey((e.Key.Item2, e.Key.Item1))), Is.True, "each edge has two sides");

            static Vector3Int Rounded(Vector3 p) => new(Mathf.RoundToInt(p.x * 1e4f), Mathf.RoundToInt(p.y * 1e4f), Mathf.RoundToInt(p.z * 1e4f));
        }

        [Test]
        public void Filter_HasTheSharedMesh_OrACopyOfItsOwn()
        {
            var filter = Object(Square(), null, Vector3.zero).GetComponent<MeshFilter>();
            var shared = filter.sharedMesh;
            var own = Own(filter.mesh);
            Assert.That(own, Is.Not.SameAs(shared));
            Assert.That(filter.sharedMesh, Is.SameAs(own));
            Assert.That(own.name, Does.EndWith(" Instance"));
        }

        static Mesh Of(long id) => BuiltinAssets.Mesh(id);

        Mesh Square() => Own(new Mesh { name = "square", vertices = s_Corners, triangles = new[] { 0, 1, 2, 0, 2, 3 } });

        /// <summary>How many pixels it covers when the unit square is the whole picture.</summary>
        int Covered(Mesh mesh)
        {
            var target = Target();
            var material = Material("Box");
            material.SetFloat("_Cull", 0);
            DrawNow(target, mesh, material);
            return Pixels(target).Count(c => c.a > 0);
        }

        static void DrawNow(RenderTexture target, Mesh mesh, Material material)
        {
            Draw.SetRenderTarget(target);
            GL.Clear(true, true, Color.clear);
            GL.PushMatrix();
            GL.LoadOrtho();
            material.SetPass(0);
            Draw.DrawMeshNow(mesh, Matrix4x4.identity);
            GL.PopMatrix();
        }
    }
}
