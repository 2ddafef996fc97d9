using System;
using System.Linq;
using System.Threading;

namespace UnityEngine
{
    /// <summary>The player loop: what a frame consists of, and start and end of the engine.</summary>
    static class EngineLoop
    {
        static UnitySynchronizationContext s_Context;
        static SynchronizationContext s_Previous;

        /// <summary>The start of a frame, before FixedUpdate: what completed since the last one is handed out.</summary>
        internal static event Action EarlyUpdate;

        /// <summary>After the cameras: the frame's work goes to the device.</summary>
        internal static event Action FrameEnd;

        /// <summary>True between <see cref="Start"/> and <see cref="Stop"/>.</summary>
        internal static bool IsRunning { get; private set; }

        internal static void Start(EnginePaths paths)
        {
            if (IsRunning)
                throw new InvalidOperationException("The engine runs already in this process; dispose of the other host first");
            MainThread.Bind();
            s_Previous = SynchronizationContext.Current;
            s_Context = new UnitySynchronizationContext(Thread.CurrentThread);
            SynchronizationContext.SetSynchronizationContext(s_Context);
            Application.Begin(paths);
            Time.Reset();
            IsRunning = true;
        }

        /// <summary>Puts the engine's SynchronizationContext on the main thread again, which a test runner may have taken off.</summary>
        internal static void InstallContext()
        {
            MainThread.Check("InstallContext");
            SynchronizationContext.SetSynchronizationContext(s_Context);
        }

        /// <summary>Hands the frame's work to the device without ending the frame, so that its complaints are heard.</summary>
        internal static void Flush() => Raise(FrameEnd);

        /// <summary>One frame of <paramref name="seconds"/>.</summary>
        internal static void Step(float seconds)
        {
            InstallContext();
            Time.BeginFrame(seconds);
            Raise(EarlyUpdate);
            ScriptLoop.RunStarts();
            while (Time.EnterFixedStep())
            {
                ScriptLoop.RunStarts();
                ScriptLoop.Send(m => m.FixedUpdate);
                Coroutines.Resume(ResumePoint.FixedUpdate);
            }

            ScriptLoop.RunStarts();
            ScriptLoop.Send(m => m.Update);
            Coroutines.Resume(ResumePoint.Update);
            s_Context.Run();
            ScriptLoop.RunStarts();
            ScriptLoop.Send(m => m.LateUpdate);
            Destruction.RunScheduled();
            Application.RaiseBeforeRender();
            Cameras.RenderAll();
            Coroutines.Resume(ResumePoint.EndOfFrame);
            Raise(FrameEnd);
        }

        /// <summary>Quits: OnApplicationQuit, then OnDisable and OnDestroy of everything; assets and textures end too.</summary>
        /// <returns>One line per object that nobody destroyed though nothing else would have: textures, ScriptableObjects and the like.</returns>
        internal static string[] Stop()
        {
            MainThread.Check("Stop");
            ScriptLoop.SendToAll(m => m.OnApplicationQuit);
            Application.RaiseQuitting();
            foreach (var root in SceneRoots.Transforms.ToList())
                if (Object.IsAlive(root))
                    Destruction.Now(root.Owner);
            AssetLibrary.Unload();
            var leaks = ObjectRegistry.Snapshot();
            var report = leaks.Select(o => $"{o.GetType().Name} '{o.NameForMessages}'").ToArray();
            foreach (var o in leaks)
                if (Object.IsAlive(o))
                    Destruction.Now(o);
            Forget();
            return report;
        }

        static void Forget()
        {
            // What OnDestroy made just now has no scene to live in.
            SceneRoots.Transforms.Clear();
            ObjectRegistry.Clear();
            ScriptLoop.Forget();
            Coroutines.Forget();
            Destruction.Forget();
            Cameras.Forget();
            EarlyUpdate = null;
            FrameEnd = null;
            SynchronizationContext.SetSynchronizationContext(s_Previous);
            s_Context = null;
            IsRunning = false;
        }

        static void Raise(Action callbacks)
        {
            foreach (var callback in callbacks?.GetInvocationList() ?? Array.Empty<Delegate>())
                LogRouter.Guard((Action)callback);
        }
    }
}
