using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>Which render pipelines draw the shader <c>AnatomyCarve/Carved Volume</c>.</summary>
    static class RenderPipelines
    {
        const string Universal = "UniversalPipeline";

        /// <summary>Why a pipeline does not draw volumes, as a sentence; null where it does.</summary>
        /// <param name="pipeline">Null = the Built-in one.</param>
        public static string Problem(RenderPipelineAsset pipeline)
        {
            if (pipeline == null || pipeline.renderPipelineShaderTag == Universal)
                return null;
            return $"{pipeline.GetType().Name} is not supported: use the Universal or the Built-in Render Pipeline "
                + "(Project Settings > Graphics), or show what CarvedVolumeRenderer.Render makes.";
        }
    }
}
