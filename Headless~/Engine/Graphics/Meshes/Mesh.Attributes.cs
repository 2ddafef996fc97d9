using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed partial class Mesh
    {
        /// <summary>Positions. The bounds do not follow; <see cref="triangles"/> and RecalculateBounds see to them.</summary>
        public Vector3[] vertices
        {
            get => Read(VertexAttribute.Position, v => (Vector3)v);
            set => SetVertices(value);
        }

        public Vector3[] normals
        {
            get => Read(VertexAttribute.Normal, v => (Vector3)v);
            set => SetNormals(value);
        }

        public Vector4[] tangents
        {
            get => Read(VertexAttribute.Tangent, v => v);
            set => SetTangents(value);
        }

        public Color[] colors
        {
            get => Read(VertexAttribute.Color, v => (Color)v);
            set => SetColors(value);
        }

        /// <summary>Colours of eight bits per channel.</summary>
        public Color32[] colors32
        {
            get => Read(VertexAttribute.Color, v => (Color32)(Color)v);
            set => SetColors(value);
        }

        public Vector2[] uv { get => ReadUVs(0); set => SetUVs(0, value); }

        public Vector2[] uv2 { get => ReadUVs(1); set => SetUVs(1, value); }

        public Vector2[] uv3 { get => ReadUVs(2); set => SetUVs(2, value); }

        public Vector2[] uv4 { get => ReadUVs(3); set => SetUVs(3, value); }

        public Vector2[] uv5 { get => ReadUVs(4); set => SetUVs(4, value); }

        public Vector2[] uv6 { get => ReadUVs(5); set => SetUVs(5, value); }

        public Vector2[] uv7 { get => ReadUVs(6); set => SetUVs(6, value); }

        public Vector2[] uv8 { get => ReadUVs(7); set => SetUVs(7, value); }

        public void SetVertices(Vector3[] inVertices)
        {
            Change("SetVertices");
            var count = inVertices?.Length ?? 0;
            foreach (var subMesh in m_SubMeshes)
                foreach (var index in subMesh.Indices)
                    if (index + subMesh.BaseVertex >= count)
                    {
                        Debug.LogError("Mesh.vertices is too small. The supplied vertex array has less vertices than are referenced by the triangles array.");
                        return;
                    }
            if (count != vertexCount)
            {
                // Attributes of another number of vertices have no meaning any more.
                foreach (var attribute in new List<VertexAttribute>(m_Channels.Keys))
                    if (attribute != VertexAttribute.Position && m_Channels[attribute].Count != count)
                        m_Channels.Remove(attribute);
            }
            if (count == 0)
                m_Channels.Remove(VertexAttribute.Position);
            else
                m_Channels[VertexAttribute.Position] = MeshChannel.Of(inVertices);
        }

        public void SetVertices(List<Vector3> inVertices) => SetVertices(inVertices?.ToArray());

        public void SetNormals(Vector3[] inNormals) => Set(VertexAttribute.Normal, "normals", inNormals, MeshChannel.Of);

        public void SetNormals(List<Vector3> inNormals) => SetNormals(inNormals?.ToArray());

        public void SetTangents(Vector4[] inTangents) => Set(VertexAttribute.Tangent, "tangents", inTangents, MeshChannel.Of);

        public void SetTangents(List<Vector4> inTangents) => SetTangents(inTangents?.ToArray());

        public void SetColors(Color[] inColors) => Set(VertexAttribute.Color, "colors", inColors, MeshChannel.Of);

        public void SetColors(List<Color> inColors) => SetColors(inColors?.ToArray());

        public void SetColors(Color32[] inColors) => Set(VertexAttribute.Color, "colors32", inColors, MeshChannel.Of);

        public void SetColors(List<Color32> inColors) => SetColors(inColors?.ToArray());

        /// <param name="channel">0 to 7.</param>
        /// <param name="uvs">One per vertex; none takes the channel away.</param>
        public void SetUVs(int channel, Vector2[] uvs) => Set(UV(channel), "uv", uvs, MeshChannel.Of);

        public void SetUVs(int channel, Vector3[] uvs) => Set(UV(channel), "uv", uvs, MeshChannel.Of);

        public void SetUVs(int channel, Vector4[] uvs) => Set(UV(channel), "uv", uvs, MeshChannel.Of);

        public void SetUVs(int channel, List<Vector2> uvs) => SetUVs(channel, uvs?.ToArray());

        public void SetUVs(int channel, List<Vector3> uvs) => SetUVs(channel, uvs?.ToArray());

        public void SetUVs(int channel, List<Vector4> uvs) => SetUVs(channel, uvs?.ToArray());

        public void GetVertices(List<Vector3> vertices) => Fill(vertices, this.vertices);

        public void GetNormals(List<Vector3> normals) => Fill(normals, this.normals);

        public void GetColors(List<Color> colors) => Fill(colors, this.colors);

        public void GetUVs(int channel, List<Vector2> uvs) => Fill(uvs, ReadUVs(channel));

        public void GetUVs(int channel, List<Vector3> uvs) => Fill(uvs, Read(UV(channel), v => (Vector3)v));

        public void GetUVs(int channel, List<Vector4> uvs) => Fill(uvs, Read(UV(channel), v => v));

        static VertexAttribute UV(int channel) => channel is >= 0 and < 8 ? VertexAttribute.TexCoord0 + channel
            : throw new ArgumentOutOfRangeException(nameof(channel), channel, "The uv index is invalid. Must be in the range 0 to 7.");

        static void Fill<T>(List<T> target, T[] values)
        {
            if (target == null)
                throw new ArgumentNullException(nameof(target), "The result list cannot be null.");
            target.Clear();
            target.AddRange(values);
        }

        Vector2[] ReadUVs(int channel) => Read(UV(channel), v => (Vector2)v);

        T[] Read<T>(VertexAttribute attribute, Func<Vector4, T> convert)
        {
            Use("get_" + attribute);
            if (!isReadable)
            {
                Debug.LogError($"Not allowed to access {attribute} on mesh '{NameForMessages}' (isReadable is false)");
                return Array.Empty<T>();
            }
            return m_Channels.TryGetValue(attribute, out var channel) ? channel.Read(convert) : Array.Empty<T>();
        }

        void Set<T>(VertexAttribute attribute, string name, T[] values, Func<T[], MeshChannel> make)
        {
            Change("set_" + name);
            if (values == null || values.Length == 0)
                m_Channels.Remove(attribute);
            else if (values.Length != vertexCount)
                Debug.LogError($"Mesh.{name} is out of bounds. The supplied array needs to be the same size as the Mesh.vertices array.");
            else
                m_Channels[attribute] = make(values);
        }
    }
}
