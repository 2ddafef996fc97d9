using System;
using UnityEngine;

namespace UnityEditor
{
    /// <summary>The Editor. The host steps it: <see cref="update"/> is called with every tick.</summary>
    public sealed class EditorApplication
    {
        public static CallbackFunction update;
        public static CallbackFunction delayCall;

        public EditorApplication()
        {
        }

        public delegate void CallbackFunction();

        /// <summary>Raised when something in the hierarchy changed; headless, after a scene was loaded.</summary>
        public static event Action hierarchyChanged;

        /// <summary>Raised when files came, changed or went.</summary>
        public static event Action projectChanged;

        public static bool isPlaying => Application.isPlaying;

        public static bool isPlayingOrWillChangePlaymode => Application.isPlaying;

        /// <summary>Whether Play stands still; the host goes on all the same, it only says so.</summary>
        public static bool isPaused { get; set; }

        public static bool isCompiling => false;

        public static bool isUpdating => false;

        public static double timeSinceStartup => Time.realtimeSinceStartupAsDouble;

        /// <summary>Whether the next tick runs a frame in edit mode.</summary>
        internal static bool IsPlayerLoopQueued { get; private set; }

        /// <summary>Asks for a frame in edit mode: Update and the like of scripts that run there.</summary>
        public static void QueuePlayerLoopUpdate()
        {
            MainThread.Check("QueuePlayerLoopUpdate");
            IsPlayerLoopQueued = true;
        }

        /// <summary>Chooses a menu entry, on the selected object.</summary>
        /// <returns>False if there is none, or if it cannot be chosen now.</returns>
        public static bool ExecuteMenuItem(string menuItemPath)
        {
            MainThread.Check("ExecuteMenuItem");
            return Menus.Execute(menuItemPath, Selection.activeObject);
        }

        /// <summary>What happens between frames.</summary>
        internal static void Tick()
        {
            var delayed = delayCall;
            delayCall = null;
            Raise(delayed);
            Raise(update);
        }

        internal static bool TakeQueuedPlayerLoop()
        {
            var queued = IsPlayerLoopQueued;
            IsPlayerLoopQueued = false;
            return queued;
        }

        internal static void RaiseHierarchyChanged() => LogRouter.Guard(() => hierarchyChanged?.Invoke());

        internal static void RaiseProjectChanged() => LogRouter.Guard(() => projectChanged?.Invoke());

        internal static void Forget()
        {
            update = delayCall = null;
            hierarchyChanged = projectChanged = null;
            IsPlayerLoopQueued = false;
        }

        static void Raise(CallbackFunction callbacks)
        {
            foreach (var callback in callbacks?.GetInvocationList() ?? Array.Empty<Delegate>())
                LogRouter.Guard(() => ((CallbackFunction)callback)());
        }
    }
}
