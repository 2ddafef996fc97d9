namespace UnityEngine
{
    /// <summary>Reads what cameras see: renderers, meshes' filters, lights, and a scene's ambient light.</summary>
    static class RendererReaders
    {
        internal static void ReadRenderer(Renderer r, NativeFields f)
        {
            r.enabled = f.Get("m_Enabled", r.enabled);
            r.sharedMaterials = f.Get("m_Materials", r.sharedMaterials);
            r.shadowCastingMode = f.Get("m_CastShadows", r.shadowCastingMode);
            r.receiveShadows = f.Get("m_ReceiveShadows", r.receiveShadows);
            r.lightProbeUsage = f.Get("m_LightProbeUsage", r.lightProbeUsage);
            r.reflectionProbeUsage = f.Get("m_ReflectionProbeUsage", r.reflectionProbeUsage);
            r.motionVectorGenerationMode = f.Get("m_MotionVectors", r.motionVectorGenerationMode);
            r.allowOcclusionWhenDynamic = f.Get("m_DynamicOccludee", r.allowOcclusionWhenDynamic);
            r.renderingLayerMask = f.Get("m_RenderingLayerMask", r.renderingLayerMask);
            r.rendererPriority = f.Get("m_RendererPriority", r.rendererPriority);
            r.sortingLayerID = f.Get("m_SortingLayerID", r.sortingLayerID);
            r.sortingOrder = f.Get("m_SortingOrder", r.sortingOrder);
        }

        internal static void ReadMeshFilter(MeshFilter m, NativeFields f) => m.sharedMesh = f.Get("m_Mesh", m.sharedMesh);

        internal static void ReadLight(Light l, NativeFields f)
        {
            l.type = f.Get("m_Type", l.type);
            l.color = f.Get("m_Color", l.color);
            l.intensity = f.Get("m_Intensity", l.intensity);
            l.bounceIntensity = f.Get("m_BounceIntensity", l.bounceIntensity);
            l.range = f.Get("m_Range", l.range);
            l.spotAngle = f.Get("m_SpotAngle", l.spotAngle);
            l.innerSpotAngle = f.Get("m_InnerSpotAngle", l.innerSpotAngle);
            l.cullingMask = f.Get("m_CullingMask", (LayerMask)l.cullingMask);
            l.renderingLayerMask = unchecked((int)f.Get("m_RenderingLayerMask", (uint)l.renderingLayerMask));
            var shadows = f.Part("m_Shadows");
            l.shadows = f.Get(shadows, "m_Type", l.shadows);
            l.shadowStrength = f.Get(shadows, "m_Strength", l.shadowStrength);
        }

        /// <summary>A scene's RenderSettings: of them the host knows the ambient light.</summary>
        internal static void ReadRenderSettings(NativeFields f)
        {
            RenderSettings.ambientLight = f.Get("m_AmbientSkyColor", RenderSettings.ambientLight);
            RenderSettings.ambientIntensity = f.Get("m_AmbientIntensity", RenderSettings.ambientIntensity);
        }
    }
}
