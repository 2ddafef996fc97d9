namespace UnityEngine.Rendering.Universal
{
    /// <summary>The settings of the pipeline that stands for URP.</summary>
    sealed class UniversalRenderPipelineAsset : RenderPipelineAsset<UniversalRenderPipeline>
    {
        Material m_Default;

        /// <summary>Whether all cameras make a texture of their depth.</summary>
        internal bool SupportsCameraDepthTexture { get; set; }

        public override string renderPipelineShaderTag => "UniversalPipeline";

        public override Shader defaultShader => Shader.Find("Universal Render Pipeline/Lit");

        public override Material defaultMaterial
        {
            get
            {
                if (m_Default == null)
                {
                    m_Default = new Material(defaultShader) { name = "Lit", IsAsset = true };
                    ObjectRegistry.Remove(m_Default);
                }
                return m_Default;
            }
        }

        protected override void OnDisable() => m_Default?.Kill();

        protected override RenderPipeline CreatePipeline() => new UniversalRenderPipeline(this);
    }
}
