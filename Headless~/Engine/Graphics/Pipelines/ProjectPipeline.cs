using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>The render pipelines that a project can have here.</summary>
    enum PipelineKind
    {
        BuiltIn = 0,
        Universal = 1,
        HighDefinition = 2,
        Other = 3,
    }

    /// <summary>Makes the project one of a render pipeline: its package and its asset.</summary>
    static class ProjectPipeline
    {
        const string Version = "17.0.4";
        const string HighDefinitionPackage = "com.unity.render-pipelines.high-definition";

        static RenderPipelineAsset s_Asset;

        /// <param name="kind">The pipeline.</param>
        /// <param name="depthTexture">Whether URP's cameras all make a depth texture.</param>
        internal static void Choose(PipelineKind kind, bool depthTexture = false)
        {
            Forget();
            if (kind == PipelineKind.BuiltIn)
                return;
            ShaderEnvironment.Install(ShaderEnvironment.CorePackage, Version);
            if (kind == PipelineKind.Universal)
                ShaderEnvironment.Install(ShaderEnvironment.UniversalPackage, Version);
            if (kind == PipelineKind.HighDefinition)
                ShaderEnvironment.Install(HighDefinitionPackage, Version);
            s_Asset = Create(kind, depthTexture);
            s_Asset.IsAsset = true;
            ObjectRegistry.Remove(s_Asset);
            RenderPipelines.Asset = s_Asset;
        }

        internal static void Forget()
        {
            if (s_Asset is null)
                return;
            if (ReferenceEquals(RenderPipelines.Asset, s_Asset))
                RenderPipelines.Asset = null;
            s_Asset.Kill();
            s_Asset = null;
            foreach (var package in new[] { ShaderEnvironment.CorePackage, ShaderEnvironment.UniversalPackage, HighDefinitionPackage })
                ShaderEnvironment.Install(package, null);
        }

        static RenderPipelineAsset Create(PipelineKind kind, bool depthTexture)
        {
            if (kind == PipelineKind.Universal)
            {
                var universal = ScriptableObject.CreateInstance<UniversalRenderPipelineAsset>();
                universal.name = "UniversalRenderPipelineAsset";
                universal.SupportsCameraDepthTexture = depthTexture;
                return universal;
            }
            var foreign = ScriptableObject.CreateInstance<ForeignPipelineAsset>();
            (foreign.name, foreign.Tag) = kind == PipelineKind.HighDefinition
                ? ("HDRenderPipelineAsset", "HDRenderPipeline")
                : ("OtherPipelineAsset", "OtherPipeline");
            return foreign;
        }
    }
}
