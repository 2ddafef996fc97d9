using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Something on a GameObject that cameras see.</summary>
    public partial class Renderer : Component
    {
        Material[] m_Materials = { null };
        Bounds? m_LocalBounds;
        Bounds? m_Bounds;
        MaterialPropertyBlock m_Block;
        Dictionary<int, MaterialPropertyBlock> m_Blocks;
        long m_SeenInFrame = long.MinValue;

        public Renderer()
        {
            if (Owner is not null)
                Renderers.All.Add(this);
        }

        public bool enabled { get; set; } = true;

        public bool forceRenderingOff { get; set; }

        /// <summary>Whether some camera drew it in the last frame.</summary>
        public bool isVisible => m_SeenInFrame >= Time.frameCount - 1;

        public ShadowCastingMode shadowCastingMode { get; set; } = ShadowCastingMode.On;

        public bool receiveShadows { get; set; } = true;

        public LightProbeUsage lightProbeUsage { get; set; } = LightProbeUsage.BlendProbes;

        public ReflectionProbeUsage reflectionProbeUsage { get; set; } = ReflectionProbeUsage.BlendProbes;

        public MotionVectorGenerationMode motionVectorGenerationMode { get; set; } = MotionVectorGenerationMode.Object;

        public uint renderingLayerMask { get; set; } = 1;

        public int rendererPriority { get; set; }

        /// <summary>Lower ones are drawn first among those of one queue.</summary>
        public int sortingOrder { get; set; }

        public int sortingLayerID { get; set; }

        public string sortingLayerName { get; set; } = "Default";

        public bool allowOcclusionWhenDynamic { get; set; } = true;

        /// <summary>The box around it in world space. A value set by hand sticks until <see cref="ResetBounds"/>.</summary>
        public Bounds bounds
        {
            get { Use("get_bounds"); return m_Bounds ?? (m_LocalBounds == null ? OwnWorldBounds : MeshMath.Transform(localToWorldMatrix, localBounds)); }
            set { Use("set_bounds"); m_Bounds = value; }
        }

        /// <summary>The box in local space. A value set by hand sticks until <see cref="ResetLocalBounds"/>.</summary>
        public Bounds localBounds
        {
            get { Use("get_localBounds"); return m_LocalBounds ?? OwnBounds; }
            set { Use("set_localBounds"); m_LocalBounds = value; }
        }

        public Matrix4x4 localToWorldMatrix => transform.localToWorldMatrix;

        public Matrix4x4 worldToLocalMatrix => transform.worldToLocalMatrix;

        /// <summary>The material itself, which others may use too.</summary>
        public Material sharedMaterial
        {
            get { Use("get_sharedMaterial"); return m_Materials.Length > 0 ? m_Materials[0] : null; }
            set
            {
                Use("set_sharedMaterial");
                if (m_Materials.Length == 0)
                    m_Materials = new Material[1];
                m_Materials[0] = value;
            }
        }

        /// <summary>One material per submesh; a copy of the list.</summary>
        public Material[] sharedMaterials
        {
            get { Use("get_sharedMaterials"); return (Material[])m_Materials.Clone(); }
            set { Use("set_sharedMaterials"); m_Materials = (Material[])(value ?? Array.Empty<Material>()).Clone(); }
        }

        /// <summary>The first material, from now on this renderer's own: reading it makes a copy, which is yours to destroy.</summary>
        public Material material
        {
            get { Use("get_material"); return Own(0); }
            set => sharedMaterial = value;
        }

        public Material[] materials
        {
            get
            {
                Use("get_materials");
                for (var i = 0; i < m_Materials.Length; i++)
                    Own(i);
                return (Material[])m_Materials.Clone();
            }
            set => sharedMaterials = value;
        }

        public void GetSharedMaterials(List<Material> m)
        {
            Use("GetSharedMaterials");
            (m ?? throw new ArgumentNullException(nameof(m))).Clear();
            m.AddRange(m_Materials);
        }

        public void SetSharedMaterials(List<Material> materials) =>
            sharedMaterials = materials?.ToArray() ?? throw new ArgumentNullException(nameof(materials));

        public void GetMaterials(List<Material> m)
        {
            (m ?? throw new ArgumentNullException(nameof(m))).Clear();
            m.AddRange(materials);
        }

        public void SetMaterials(List<Material> materials) => SetSharedMaterials(materials);

        public void ResetBounds() => m_Bounds = null;

        public void ResetLocalBounds() => m_LocalBounds = null;

        public bool HasPropertyBlock() => m_Block != null || m_Blocks is { Count: > 0 };

        /// <summary>Values that come before the materials'; they are copied. Null takes them away.</summary>
        public void SetPropertyBlock(MaterialPropertyBlock properties)
        {
            Use("SetPropertyBlock");
            m_Block = properties == null || properties.isEmpty ? null : properties.Copy();
        }

        public void SetPropertyBlock(MaterialPropertyBlock properties, int materialIndex)
        {
            Use("SetPropertyBlock");
            CheckIndex(materialIndex);
            m_Blocks ??= new Dictionary<int, MaterialPropertyBlock>();
            if (properties == null || properties.isEmpty)
                m_Blocks.Remove(materialIndex);
            else
                m_Blocks[materialIndex] = properties.Copy();
        }

        /// <summary>Replaces the block's contents by a copy of what was set.</summary>
        public void GetPropertyBlock(MaterialPropertyBlock properties)
        {
            Use("GetPropertyBlock");
            Fill(properties, m_Block);
        }

        public void GetPropertyBlock(MaterialPropertyBlock properties, int materialIndex)
        {
            Use("GetPropertyBlock");
            CheckIndex(materialIndex);
            MaterialPropertyBlock block = null;
            m_Blocks?.TryGetValue(materialIndex, out block);
            Fill(properties, block);
        }

        /// <summary>Whether it is to be drawn: switched on, in an active hierarchy, in the scene.</summary>
        internal bool IsShown => enabled && !forceRenderingOff && Owner.IsActive && !Owner.IsAsset;

        /// <summary>The mesh as it looks to a camera; null if there is none.</summary>
        internal virtual Mesh MeshFor(Camera camera) => null;

        /// <summary>Where the mesh's space lies.</summary>
        internal virtual Matrix4x4 MeshToWorld => localToWorldMatrix;

        internal virtual Bounds OwnBounds => default;

        internal virtual Bounds OwnWorldBounds => MeshMath.Transform(localToWorldMatrix, OwnBounds);

        internal IReadOnlyList<Material> Materials => m_Materials;

        internal MaterialPropertyBlock BlockOf(int material) =>
            m_Blocks != null && m_Blocks.TryGetValue(material, out var block) ? block : m_Block;

        internal void MarkSeen() => m_SeenInFrame = Time.frameCount;

        internal override void OnNativeDestroy() => Renderers.All.Remove(this);

        internal override void CopyNativeState(Component source, Func<Object, Object> remap)
        {
            var other = (Renderer)source;
            m_Materials = (Material[])other.m_Materials.Clone();
            (m_LocalBounds, m_Bounds) = (other.m_LocalBounds, other.m_Bounds);
            m_Block = other.m_Block?.Copy();
            m_Blocks = other.m_Blocks?.ToDictionary(b => b.Key, b => b.Value.Copy());
            (enabled, forceRenderingOff, shadowCastingMode, receiveShadows) =
                (other.enabled, other.forceRenderingOff, other.shadowCastingMode, other.receiveShadows);
            (lightProbeUsage, reflectionProbeUsage, motionVectorGenerationMode) =
                (other.lightProbeUsage, other.reflectionProbeUsage, other.motionVectorGenerationMode);
            (renderingLayerMask, rendererPriority, sortingOrder, sortingLayerID, sortingLayerName) =
                (other.renderingLayerMask, other.rendererPriority, other.sortingOrder, other.sortingLayerID, other.sortingLayerName);
        }

        Material Own(int index)
        {
            const string suffix = " (Instance)";
            if (index >= m_Materials.Length || m_Materials[index] == null)
                return null;
            if (!m_Materials[index].NameForMessages.EndsWith(suffix, StringComparison.Ordinal))
                m_Materials[index] = new Material(m_Materials[index]) { name = m_Materials[index].NameForMessages + suffix };
            return m_Materials[index];
        }

        void CheckIndex(int materialIndex)
        {
            if (materialIndex < 0 || materialIndex >= m_Materials.Length)
                throw new ArgumentOutOfRangeException(nameof(materialIndex), materialIndex, $"The renderer has {m_Materials.Length} materials");
        }

        static void Fill(MaterialPropertyBlock target, MaterialPropertyBlock source)
        {
            if (target == null)
                throw new ArgumentNullException(nameof(target));
            target.Clear();
            source?.Values.CopyTo(target.Values);
        }
    }

    /// <summary>All living renderers.</summary>
    static class Renderers
    {
        internal static List<Renderer> All { get; } = new();
    }
}
