using System;

namespace UnityEngine.Rendering
{
    /// <summary>The project's graphics settings.</summary>
    public sealed class GraphicsSettings : Object
    {
        GraphicsSettings()
        {
        }

        /// <summary>The pipeline of the project; null is the Built-in one.</summary>
        public static RenderPipelineAsset defaultRenderPipeline
        {
            get => RenderPipelines.Asset;
            set { MainThread.Check("set_defaultRenderPipeline"); RenderPipelines.Asset = value; }
        }

        /// <summary>The pipeline in use; null is the Built-in one.</summary>
        public static RenderPipelineAsset currentRenderPipeline => RenderPipelines.Asset;

        public static Type currentRenderPipelineAssetType => RenderPipelines.Asset?.GetType();

        public static bool isScriptableRenderPipelineEnabled => RenderPipelines.Asset != null;

        public static RenderPipelineAsset[] allConfiguredRenderPipelines =>
            RenderPipelines.Asset == null ? Array.Empty<RenderPipelineAsset>() : new[] { RenderPipelines.Asset };
    }
}
