using System;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>The device in use, made at the first need, and its turn in the frame.</summary>
    static class Gpu
    {
        static GpuContext s_Context;

        /// <summary>Whether a device was made.</summary>
        internal static bool IsStarted => s_Context != null;

        /// <summary>The device; the first call makes it.</summary>
        /// <exception cref="VulkanException">There is none; the message says what to install.</exception>
        internal static GpuContext Context
        {
            get
            {
                MainThread.Check("Graphics device access");
                return s_Context ??= new GpuContext();
            }
        }

        /// <summary>Start of a frame: read-backs that are ready are handed out. Never makes a device.</summary>
        internal static void BeginFrame()
        {
            if (s_Context == null)
                return;
            s_Context.Stream.Poll();
            s_Context.Readbacks.BeginFrame();
            s_Context.Messages.Drain();
        }

        /// <summary>End of a frame: hands the frame's work to the device.</summary>
        internal static void EndFrame()
        {
            if (s_Context == null)
                return;
            RenderTexturePool.EndFrame();
            s_Context.Stream.Submit();
            s_Context.Messages.Drain();
        }

        /// <summary>Ends the device: waits for its work, reports what was not freed, frees everything.</summary>
        internal static GpuReport Shutdown()
        {
            ForgetDrawing();
            if (s_Context == null)
                return new GpuReport();
            RenderTexturePool.Clear();
            BuiltinTextures.Clear();
            var context = s_Context;
            var report = context.Shutdown();
            s_Context = null;
            ShaderGlobals.Clear();
            return report;
        }

        /// <summary>Ends what drawing made for itself, whether there is a device or not.</summary>
        static void ForgetDrawing()
        {
            DrawTargets.Forget();
            ImmediateDrawing.Forget();
            Drawer.Forget();
            ScreenBuffer.Clear();
            Headset.Forget();
            Blitter.Forget();
            DefaultTextures.Clear();
            BuiltinAssets.Clear();
            BuiltinShaders.Clear();
            RenderPipelines.Forget();
            ProjectPipeline.Forget();
        }
    }
}
