using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>How Graphics.RenderMesh and the like draw.</summary>
    public struct RenderParams
    {
        public RenderParams(Material mat)
        {
            layer = 0;
            renderingLayerMask = 1;
            rendererPriority = 0;
            worldBounds = new Bounds(Vector3.zero, Vector3.zero);
            camera = null;
            motionVectorMode = MotionVectorGenerationMode.Camera;
            reflectionProbeUsage = ReflectionProbeUsage.Off;
            material = mat;
            matProps = null;
            shadowCastingMode = ShadowCastingMode.Off;
            receiveShadows = false;
            lightProbeUsage = LightProbeUsage.Off;
        }

        public int layer { get; set; }

        public uint renderingLayerMask { get; set; }

        public int rendererPriority { get; set; }

        /// <summary>Of no size: the mesh's own.</summary>
        public Bounds worldBounds { get; set; }

        /// <summary>The only camera that draws it; null for all.</summary>
        public Camera camera { get; set; }

        public MotionVectorGenerationMode motionVectorMode { get; set; }

        public ReflectionProbeUsage reflectionProbeUsage { get; set; }

        public Material material { get; set; }

        /// <summary>Copied with the call.</summary>
        public MaterialPropertyBlock matProps { get; set; }

        public ShadowCastingMode shadowCastingMode { get; set; }

        public bool receiveShadows { get; set; }

        public LightProbeUsage lightProbeUsage { get; set; }
    }
}
