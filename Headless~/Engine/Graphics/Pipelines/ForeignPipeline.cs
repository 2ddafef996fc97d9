using System.Collections.Generic;

namespace UnityEngine.Rendering
{
    /// <summary>A pipeline that this host knows by its tag only: it raises its events, and of the scene it draws nothing.</summary>
    sealed class ForeignPipeline : RenderPipeline
    {
        protected override void Render(ScriptableRenderContext context, Camera[] cameras) => Render(context, new List<Camera>(cameras));

        protected override void Render(ScriptableRenderContext context, List<Camera> cameras)
        {
            BeginContextRendering(context, cameras);
            foreach (var camera in cameras)
            {
                BeginCameraRendering(context, camera);
                context.Submit();
                if (Object.IsAlive(camera))
                    Clear(camera);
                EndCameraRendering(context, camera);
                context.Submit();
            }
            EndContextRendering(context, cameras);
            context.Submit();
        }

        static void Clear(Camera camera)
        {
            foreach (var picture in CameraPicture.Of(camera))
            {
                if (EmptyPictures.TrySkip(picture))
                    continue;
                var restore = DrawTargets.Remember();
                picture.Begin();
                picture.Clear();
                CameraPicture.End();
                restore();
            }
        }
    }

    /// <summary>Its settings.</summary>
    sealed class ForeignPipelineAsset : RenderPipelineAsset<ForeignPipeline>
    {
        internal string Tag { get; set; } = "";

        public override string renderPipelineShaderTag => Tag;

        protected override RenderPipeline CreatePipeline() => new ForeignPipeline();
    }
}
