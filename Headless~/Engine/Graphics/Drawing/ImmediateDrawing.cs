using System.Collections.Generic;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>Material.SetPass and Graphics.DrawMeshNow: draws into the present target, with matrices of GL's.</summary>
    static class ImmediateDrawing
    {
        static readonly Stack<ViewSetup> s_Stack = new();
        static Material s_Material;
        static PassProgram s_Pass;

        internal static Matrix4x4 View
        {
            get => Drawer.View.Left.View;
            set => Set(value, Projection);
        }

        internal static Matrix4x4 Projection
        {
            get => Drawer.View.Left.Projection;
            set => Set(View, value);
        }

        internal static bool SetPass(Material material, int index)
        {
            s_Material = material;
            s_Pass = index >= 0 && index < material.Passes.Count ? material.Passes[index] : null;
            if (s_Pass == null)
                Debug.LogError($"Trying to access pass {index}, but material '{material.NameForMessages}' with shader '{material.shader.NameForMessages}' has "
                    + $"{material.Passes.Count}");
            return s_Pass != null;
        }

        internal static void Push() => s_Stack.Push(Drawer.View);

        internal static void Pop()
        {
            if (s_Stack.Count == 0)
                Debug.LogError("GL.PopMatrix without GL.PushMatrix");
            else
                Drawer.View = s_Stack.Pop();
        }

        /// <summary>Draws with the pass that was set.</summary>
        internal static void Draw(Mesh mesh, Matrix4x4 objectToWorld, int subMesh)
        {
            if (mesh == null)
                throw new System.ArgumentNullException(nameof(mesh));
            if (s_Pass == null || s_Material == null)
            {
                Debug.LogError("Graphics.DrawMeshNow needs Material.SetPass before it");
                return;
            }
            for (var i = subMesh < 0 ? 0 : subMesh; i < (subMesh < 0 ? mesh.subMeshCount : subMesh + 1); i++)
                Drawer.Draw(new DrawItem { Mesh = mesh, SubMesh = i, Material = s_Material, ObjectToWorld = objectToWorld }, s_Pass);
        }

        /// <summary>Sets both matrices.</summary>
        internal static void Set(Matrix4x4 view, Matrix4x4 projection) =>
            Drawer.View = ViewSetup.Of(view, projection, DrawTargets.Width, DrawTargets.Height);

        internal static void Forget()
        {
            s_Stack.Clear();
            s_Material = null;
            s_Pass = null;
        }
    }
}
