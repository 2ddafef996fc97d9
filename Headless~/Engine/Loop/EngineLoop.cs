using System;
using System.Linq;
using System.Threading;
using UnityEngine.SceneManagement;

namespace UnityEngine
{
    /// <summary>The player loop: what a frame consists of, and start and end of the engine.</summary>
    static class EngineLoop
    {
        static UnitySynchronizationContext s_Context;
        static SynchronizationContext s_Previous;

        /// <summary>The start of a frame, before FixedUpdate: what completed since the last one is handed out.</summary>
        internal static event Action EarlyUpdate;

        /// <summary>After FixedUpdate, before Update: input comes in.</summary>
        internal static event Action PreUpdate;

        /// <summary>After the cameras: the frame's work goes to the device.</summary>
        internal static event Action FrameEnd;

        /// <summary>True between <see cref="Start"/> and <see cref="Stop"/>.</summary>
        internal static bool IsRunning { get; private set; }

        internal static void Start(EnginePaths paths, bool inEditMode = false)
        {
            if (IsRunning)
                throw new InvalidOperationException("The engine runs already in this process; dispose of the other host first");
            MainThread.Bind();
            s_Previous = SynchronizationContext.Current;
            s_Context = new UnitySynchronizationContext(Thread.CurrentThread);
            SynchronizationContext.SetSynchronizationContext(s_Context);
            Application.Begin(paths, inEditMode);
            Time.Reset();
            IsRunning = true;
        }

        /// <summary>Puts the engine's SynchronizationContext on the main thread again, which a test runner may have taken off.</summary>
        internal static void InstallContext()
        {
            MainThread.Check("InstallContext");
            SynchronizationContext.SetSynchronizationContext(s_Context);
        }

        /// <summary>What the Editor does between frames: continuations of async methods go on.</summary>
        internal static void Idle()
        {
            InstallContext();
            s_Context.Run();
        }

        /// <summary>Hands the frame's work to the device without ending the frame, so that its complaints are heard.</summary>
        internal static void Flush() => Raise(FrameEnd);

        /// <summary>One frame of <paramref name="seconds"/>.</summary>
        internal static void Step(float seconds)
        {
            InstallContext();
            Time.BeginFrame(seconds);
            SceneLoading.RunPending();
            Raise(EarlyUpdate);
            AsyncOperations.RunCompletions();
            ScriptLoop.RunStarts();
            while (!Application.InEditMode && Time.EnterFixedStep())
            {
                ScriptLoop.RunStarts();
                ScriptLoop.Send(m => m.FixedUpdate);
                Coroutines.Resume(ResumePoint.FixedUpdate);
            }

            Raise(PreUpdate);
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
            if (!Application.InEditMode)
                ScriptLoop.SendToAll(m => m.OnApplicationQuit);
            Application.RaiseQuitting();
            foreach (var root in LoadedScenes.Roots)
                if (Object.IsAlive(root))
                    Destruction.Now(root.Owner);
            while (Destruction.RunScheduled())
            {
                // What OnDisable and OnDestroy asked for, and what these asked for in turn.
            }

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
            LoadedScenes.Forget();
            SceneLoading.Forget();
            AsyncOperations.Forget();
            ObjectRegistry.Clear();
            ScriptLoop.Forget();
            Coroutines.Forget();
            Destruction.Forget();
            Cameras.Forget();
            EarlyUpdate = null;
            PreUpdate = null;
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
