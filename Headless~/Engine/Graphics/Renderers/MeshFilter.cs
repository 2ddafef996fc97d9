using System;

namespace UnityEngine
{
    /// <summary>The mesh of a MeshRenderer.</summary>
    public sealed class MeshFilter : Component
    {
        Mesh m_Mesh;
        Mesh m_Own;

        public MeshFilter()
        {
        }

        /// <summary>The mesh itself, which others may use too.</summary>
        public Mesh sharedMesh
        {
            get { Use("get_sharedMesh"); return m_Mesh; }
            set { Use("set_sharedMesh"); m_Mesh = value; }
        }

        /// <summary>A mesh of this filter's own: reading it copies one that others may use. It is yours to destroy.</summary>
        public Mesh mesh
        {
            get
            {
                Use("get_mesh");
                if (m_Mesh == null)
                    m_Mesh = new Mesh { name = "" };
                else if (m_Mesh != m_Own)
                    m_Mesh = Copy(m_Mesh);
                return m_Own = m_Mesh;
            }
            set => m_Own = sharedMesh = value;
        }

        static Mesh Copy(Mesh mesh)
        {
            var copy = (Mesh)mesh.CloneNative();
            copy.name = mesh.NameForMessages + " Instance";
            return copy;
        }

        internal override void CopyNativeState(Component source, Func<Object, Object> remap) => m_Mesh = ((MeshFilter)source).m_Mesh;
    }
}
