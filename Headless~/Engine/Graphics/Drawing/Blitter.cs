using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>Draws a texture over a whole target.</summary>
    static class Blitter
    {
        const string CopyShader = "Hidden/BlitCopy";

        static readonly int s_MainTexture = Shader.PropertyToID("_MainTex"), s_ScaleOffset = Shader.PropertyToID("_MainTex_ST");
        static readonly MaterialPropertyBlock s_Block = new();
        static Material s_Copy;
        static Mesh s_Mesh;

        /// <summary>Draws into the present target.</summary>
        /// <param name="source">What shaders see as _MainTex; null leaves it alone.</param>
        /// <param name="material">Null copies.</param>
        /// <param name="pass">-1 for all passes.</param>
        /// <param name="scaleOffset">Of the texture coordinates, for a copy.</param>
        internal static void Draw(Texture source, Material material, int pass, Vector4 scaleOffset)
        {
            if (material == null)
                material = Copy;
            s_Block.Clear();
            if (source != null)
                s_Block.SetTexture(s_MainTexture, source);
            if (ReferenceEquals(material, s_Copy))
                s_Block.SetVector(s_ScaleOffset, scaleOffset);
            var view = Drawer.View;
            ImmediateDrawing.Set(Matrix4x4.identity, Matrix4x4.Ortho(0, 1, 0, 1, -1, 100));
            var passes = material.Passes;
            if (pass >= passes.Count)
                Debug.LogError($"Graphics.Blit: material '{material.NameForMessages}' has no pass {pass}");
            for (var i = pass < 0 ? 0 : pass; i < (pass < 0 ? passes.Count : System.Math.Min(pass + 1, passes.Count)); i++)
                Drawer.Draw(new DrawItem { Mesh = Mesh, Material = material, Block = s_Block, ObjectToWorld = Matrix4x4.identity }, passes[i]);
            Drawer.View = view;
            s_Block.Clear();
        }

        internal static void Forget()
        {
            s_Copy?.Kill();
            s_Mesh?.Kill();
            s_Copy = null;
            s_Mesh = null;
        }

        static Material Copy
        {
            get
            {
                if (s_Copy == null)
                {
                    s_Copy = new Material(Shader.Find(CopyShader));
                    ObjectRegistry.Remove(s_Copy);
                }
                return s_Copy;
            }
        }

        /// <summary>A square from 0 to 1.</summary>
        static Mesh Mesh
        {
            get
            {
                if (s_Mesh != null)
                    return s_Mesh;
                s_Mesh = new Mesh
                {
                    name = "Blit",
                    vertices = new[] { Vector3.zero, Vector3.right, Vector3.up, new Vector3(1, 1, 0) },
                    uv = new[] { Vector2.zero, Vector2.right, Vector2.up, Vector2.one },
                    triangles = new[] { 0, 2, 3, 0, 3, 1 },
                };
                ObjectRegistry.Remove(s_Mesh);
                return s_Mesh;
            }
        }
    }
}
