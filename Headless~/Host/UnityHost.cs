using System;
using System.IO;
using System.Linq;
using System.Threading;
using Unity.Collections;
using UnityEditor;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.InputSystem;
using UnityEngine.SceneManagement;
using UnityEngine.Shaders;

namespace AnatomyCarve.Headless
{
    /// <summary>A running engine: what Unity's player executable is to a game. One at a time per process; the thread that starts it is the main
    /// thread.</summary>
    public sealed partial class UnityHost : IDisposable
    {
        /// <summary>One frame of a headset, in seconds.</summary>
        public const float DefaultFrameSeconds = 1f / 72f;

        /// <summary>The fileID by which YAML refers to the ComputeShader in a .compute file.</summary>
        const long ComputeShaderFileId = 7200000;

        /// <summary>The same for the Shader in a .shader file.</summary>
        const long ShaderFileId = 4800000;

        /// <summary>How the engine marks what the validation layer says.</summary>
        const string ValidationPrefix = "Vulkan validation";

        readonly Action<LogType, string, string> m_Log;
        bool m_Disposed;
        int m_Errors;
        int m_ValidationMessages;

        UnityHost(HostOptions options)
        {
            PackageRoot = Path.GetFullPath(options.PackageRoot ?? FindPackageRoot(AppContext.BaseDirectory));
            m_Log = options.Log ?? ToStandardError;
        }

        /// <summary>The folder of package.json.</summary>
        public string PackageRoot { get; }

        /// <summary>True once Application.Quit was called.</summary>
        public bool QuitRequested => Application.QuitRequested;

        /// <summary>What was left at the end; null before <see cref="Dispose"/>.</summary>
        public HostReport Report { get; private set; }

        /// <summary>Starts the engine, reads the package's .meta files and runs the start-up methods. The device is made at its first use.</summary>
        /// <exception cref="InvalidOperationException">A host runs already.</exception>
        /// <exception cref="DirectoryNotFoundException">There is no package.</exception>
        public static UnityHost Start(HostOptions options = null)
        {
            options ??= new HostOptions();
            var host = new UnityHost(options);
            EngineLoop.Start(
                new EnginePaths(options.DataFolder ?? Path.Combine(Path.GetTempPath(), "anatomycarve-host"), options.StreamingAssets), !options.PlayMode);
            try
            {
                host.Begin(options);
            }
            catch
            {
                host.Dispose();
                throw;
            }

            return host;
        }

        /// <summary>One frame of <paramref name="dt"/> seconds.</summary>
        public void Step(float dt = DefaultFrameSeconds)
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            if (Application.InEditMode)
            {
                EditorApplication.Tick();
                EditorApplication.TakeQueuedPlayerLoop();
            }

            EngineLoop.Step(dt);
        }

        /// <summary>Frames until the condition holds.</summary>
        /// <returns>False if it did not within <paramref name="maxFrames"/> frames.</returns>
        public bool RunUntil(Func<bool> condition, int maxFrames)
        {
            ArgumentNullException.ThrowIfNull(condition);
            for (var frame = 0; frame < maxFrames; frame++)
            {
                if (condition())
                    return true;
                Step();
            }

            return condition();
        }

        /// <summary>The window's picture as it is stored, RGBA with eight bits each, the bottom row first.</summary>
        public byte[] ReadScreen()
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            return ScreenBuffer.Read();
        }

        /// <summary>An eye's picture in the headset, as <see cref="ReadScreen"/>; 0 is the left one.</summary>
        /// <exception cref="InvalidOperationException">There is no headset.</exception>
        public byte[] ReadEye(int eye)
        {
            CheckEye(eye);
            return Headset.Read(eye);
        }

        /// <summary>A target's depth buffer as it is stored, the bottom row first: 1 at the near plane, 0 at the far one.</summary>
        /// <exception cref="ArgumentException">The target has no depth of 32-bit floats, or was not created.</exception>
        public float[] ReadDepth(RenderTexture target)
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            ArgumentNullException.ThrowIfNull(target);
            if (target.depthStencilFormat != GraphicsFormat.D32_SFloat || !target.IsCreated())
                throw new ArgumentException($"Texture {target.name} has no depth buffer of 32-bit floats", nameof(target));
            return DepthOf(target, 0);
        }

        /// <summary>The depth buffer of an eye's picture in the headset, as <see cref="ReadDepth"/>.</summary>
        /// <exception cref="InvalidOperationException">There is no headset.</exception>
        public float[] ReadEyeDepth(int eye)
        {
            CheckEye(eye);
            return DepthOf(Headset.Eyes, eye);
        }

        /// <summary>Ends everything, the device too, and fills <see cref="Report"/>.</summary>
        public void Dispose()
        {
            if (m_Disposed)
                return;
            m_Disposed = true;
            m_Errors = 0;
            var objects = EngineLoop.Stop();
            EditorStartup.Forget();
            var device = Gpu.Shutdown();
            var arrays = NativeMemory.LeakCount;
            NativeMemory.ForgetLeaks();
            Application.ForgetSubscribers();
            LogRouter.Sink = null;
            MainThread.Unbind();
            Report = new HostReport(objects, device.Leaks, arrays, m_Errors, m_ValidationMessages);
        }

        void Begin(HostOptions options)
        {
            LogRouter.Sink = OnLog;
            Screen.width = options.ScreenWidth;
            Screen.height = options.ScreenHeight;
            ColorSpaces.Active = options.ColorSpace;
            GpuOptions.Validation = options.Validation;
            GpuOptions.PackageRoot = PackageRoot;
            GpuOptions.CacheFolder = options.CacheFolder;
            (GpuOptions.DeviceType, GpuOptions.ComputeShaders) = (options.GraphicsDeviceType, options.ComputeShaders);
            GpuOptions.KernelRoute = (KernelRoute)options.KernelCompiler;
            GpuOptions.DeniedFormats.Clear();
            GpuOptions.DeniedFormats.UnionWith(options.DeniedFormats);
            EngineLoop.EarlyUpdate += Gpu.BeginFrame;
            EngineLoop.FrameEnd += Gpu.EndFrame;
            ProjectPipeline.Choose((PipelineKind)options.RenderPipeline, options.UniversalDepthTexture);
            Put(options.Headset, options.Stereo);
            AssetImporters.Register(".compute", ComputeShaderFileId, ComputeShader.Load);
            AssetImporters.Register(".shader", ShaderFileId, Shader.Load);
            AssetImporters.Register("." + InputActionAsset.Extension, InputActionsImporter.Import);
            TextAssets.Register();
            ImportedAssets.Install();
            AddRoots(options.ExtraRoots.Prepend(PackageRoot));
            InstalledPackages.Set(PackageManifest.Read(PackageRoot).Dependencies.Concat(options.Packages));
            BuildScenes.Set(options.Scenes.Select(ProjectPath));
            if (options.PlayMode)
                StartupMethods.Run();
            else
                EditorStartup.Run();
        }

        void CheckEye(int eye)
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            if (Headset.Mode == StereoMode.None)
                throw new InvalidOperationException("There is no headset; set HostOptions.Stereo");
            if (eye is not (0 or 1))
                throw new ArgumentOutOfRangeException(nameof(eye), eye, "0 is the left eye, 1 the right one");
        }

        static float[] DepthOf(RenderTexture target, int slice)
        {
            var bytes = Gpu.Context.Readbacks.ReadNow(target.DepthNative, 0, new TexelBox(0, 0, slice, target.width, target.height, 1));
            return System.Runtime.InteropServices.MemoryMarshal.Cast<byte, float>(bytes).ToArray();
        }

        static void Put(HostHeadset headset, HostStereo stereo)
        {
            Headset.Mode = (StereoMode)stereo;
            (Headset.EyeWidth, Headset.EyeHeight, Headset.Separation) = (headset.EyeWidth, headset.EyeHeight, headset.Separation);
            (Headset.Left, Headset.Right) = (headset.LeftEye, headset.RightEye);
        }

        static string FindPackageRoot(string from)
        {
            for (var folder = new DirectoryInfo(from); folder != null; folder = folder.Parent)
                if (File.Exists(Path.Combine(folder.FullName, "package.json")))
                    return folder.FullName;
            throw new DirectoryNotFoundException($"There is no package.json in {from} or above it; set HostOptions.PackageRoot");
        }

        void OnLog(LogType type, string message, string stackTrace)
        {
            if (type is LogType.Error or LogType.Assert or LogType.Exception)
                Interlocked.Increment(ref m_Errors);
            if (message.StartsWith(ValidationPrefix, StringComparison.Ordinal))
                Interlocked.Increment(ref m_ValidationMessages);
            m_Log(type, message, stackTrace);
        }

        static void ToStandardError(LogType type, string message, string stackTrace)
        {
            if (type == LogType.Log)
                return;
            Console.Error.WriteLine($"[{type}] {message}");
            if (type == LogType.Exception)
                Console.Error.WriteLine(stackTrace);
        }
    }
}
