using System;
using System.IO;
using System.Threading;
using Unity.Collections;
using UnityEngine;

namespace AnatomyCarve.Headless
{
    /// <summary>A running engine: what Unity's player executable is to a game. One at a time per process; the thread that starts it is the main
    /// thread.</summary>
    public sealed class UnityHost : IDisposable
    {
        /// <summary>One frame of a headset, in seconds.</summary>
        public const float DefaultFrameSeconds = 1f / 72f;

        /// <summary>The fileID by which YAML refers to the ComputeShader in a .compute file.</summary>
        const long ComputeShaderFileId = 7200000;

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
            EngineLoop.Start(new EnginePaths(options.DataFolder ?? Path.Combine(Path.GetTempPath(), "anatomycarve-host")));
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

        /// <summary>Ends everything, the device too, and fills <see cref="Report"/>.</summary>
        public void Dispose()
        {
            if (m_Disposed)
                return;
            m_Disposed = true;
            m_Errors = 0;
            var objects = EngineLoop.Stop();
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
            GpuOptions.Validation = options.Validation;
            GpuOptions.PackageRoot = PackageRoot;
            GpuOptions.CacheFolder = options.CacheFolder;
            GpuOptions.DeniedFormats.Clear();
            GpuOptions.DeniedFormats.UnionWith(options.DeniedFormats);
            EngineLoop.EarlyUpdate += Gpu.BeginFrame;
            EngineLoop.FrameEnd += Gpu.EndFrame;
            AssetImporters.Register(".compute", ComputeShaderFileId, ComputeShader.Load);
            AssetLibrary.AddRoot(PackageRoot);
            foreach (var root in options.ExtraRoots)
                AssetLibrary.AddRoot(root);
            StartupMethods.Run();
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
