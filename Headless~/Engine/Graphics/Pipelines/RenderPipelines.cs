using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>The project's render pipeline and its turn in the frame.</summary>
    static class RenderPipelines
    {
        static RenderPipelineAsset s_Asset;
        static RenderPipeline s_Pipeline;
        static bool s_Rendering;

        /// <summary>Null for the Built-in pipeline.</summary>
        internal static RenderPipelineAsset Asset
        {
            get => s_Asset != null ? s_Asset : null;
            set
            {
                if (ReferenceEquals(s_Asset, value))
                    return;
                var previous = s_Asset;
                EndPipeline();
                s_Asset = value;
                RenderPipelineManager.RaiseChanged(previous, value);
            }
        }

        /// <summary>What SubShaders call it.</summary>
        internal static string ShaderTag => Asset != null ? Asset.renderPipelineShaderTag : "";

        /// <summary>The pipeline, if it was made already.</summary>
        internal static RenderPipeline Existing => s_Pipeline;

        /// <summary>The pipeline, made at its first use; null for the Built-in one.</summary>
        internal static RenderPipeline Current
        {
            get
            {
                if (s_Pipeline != null || Asset == null)
                    return s_Pipeline;
                s_Pipeline = Asset.Create();
                RenderPipelineManager.RaiseCreated();
                return s_Pipeline;
            }
        }

        /// <summary>Renders cameras through the pipeline.</summary>
        internal static void Render(List<Camera> cameras) => Run(context => Current.RenderAll(context, cameras));

        /// <summary>Renders what a request asks for.</summary>
        internal static void Process<RequestData>(Camera camera, RequestData data) => Run(context => Current.Process(context, camera, data));

        internal static void Forget()
        {
            LogRouter.Guard(EndPipeline);
            s_Asset = null;
            RenderPipelineManager.Forget();
        }

        static void Run(Action<ScriptableRenderContext> work)
        {
            if (s_Rendering)
            {
                Debug.LogError("Recursive rendering is not supported in SRP (are you calling Camera.Render from within a render pipeline?).");
                return;
            }
            s_Rendering = true;
            try
            {
                var context = ScriptableRenderContext.Create();
                LogRouter.Guard(() => work(context));
                context.Submit();
            }
            finally
            {
                s_Rendering = false;
            }
        }

        static void EndPipeline()
        {
            if (s_Pipeline == null)
                return;
            var pipeline = s_Pipeline;
            s_Pipeline = null;
            pipeline.End();
            RenderPipelineManager.RaiseDisposed();
        }
    }
}
