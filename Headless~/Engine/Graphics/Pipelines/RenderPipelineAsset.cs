using System;

namespace UnityEngine.Rendering
{
    /// <summary>The settings of a render pipeline, which makes it.</summary>
    public abstract class RenderPipelineAsset : ScriptableObject
    {
        protected RenderPipelineAsset()
        {
        }

        /// <summary>The value of the tag "RenderPipeline" by which SubShaders say that they are for it.</summary>
        public virtual string renderPipelineShaderTag => "";

        public virtual Type pipelineType => null;

        public virtual Material defaultMaterial => null;

        public virtual Shader defaultShader => null;

        public virtual Material defaultLineMaterial => null;

        protected abstract RenderPipeline CreatePipeline();

        protected virtual void OnValidate()
        {
        }

        protected virtual void OnDisable()
        {
        }

        internal RenderPipeline Create() => CreatePipeline();
    }

    /// <summary>The same with the pipeline's type.</summary>
    public abstract class RenderPipelineAsset<TRenderPipeline> : RenderPipelineAsset where TRenderPipeline : RenderPipeline
    {
        protected RenderPipelineAsset()
        {
        }

        public sealed override Type pipelineType => typeof(TRenderPipeline);

        public override string renderPipelineShaderTag => typeof(TRenderPipeline).Name;
    }
}
