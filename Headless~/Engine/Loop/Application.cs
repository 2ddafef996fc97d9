using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Threading;
using UnityEngine.Events;

namespace UnityEngine
{
    /// <summary>The running player.</summary>
    public partial class Application
    {
        static readonly List<UnityAction> s_BeforeRender = new();
        static CancellationTokenSource s_Exit = new();
        static EnginePaths s_Paths = new(Path.GetTempPath());

        /// <summary>Raised after LateUpdate, before rendering, sorted by <see cref="BeforeRenderOrderAttribute"/>.</summary>
        public static event UnityAction onBeforeRender
        {
            add { if (value != null) s_BeforeRender.Add(value); }
            remove => s_BeforeRender.Remove(value);
        }

        /// <summary>Raised when the player ends.</summary>
        public static event Action quitting;

        /// <summary>Asked before the player quits; false refuses.</summary>
        public static event Func<bool> wantsToQuit;

        /// <summary>False in the host's edit mode.</summary>
        public static bool isPlaying => !InEditMode;

        /// <summary>The host plays the part of a player, or of the Editor in edit mode.</summary>
        public static bool isEditor => InEditMode;

        public static bool isBatchMode => true;

        public static bool isFocused => true;

        public static bool isMobilePlatform => false;

        public static bool isConsolePlatform => false;

        public static bool runInBackground { get; set; } = true;

        public static int targetFrameRate { get; set; } = -1;

        public static string unityVersion => "6000.0.78f1";

        public static string version => "1.0";

        public static string productName => "AnatomyCarve";

        public static string companyName => "AnatomyCarve";

        public static string identifier => "com.anatomycarve.headless";

        public static RuntimePlatform platform => InEditMode ? RuntimePlatform.LinuxEditor : RuntimePlatform.LinuxPlayer;

        public static string dataPath => s_Paths.Data;

        public static string streamingAssetsPath => s_Paths.StreamingAssets;

        public static string persistentDataPath
        {
            get { MainThread.Check("get_persistentDataPath"); return Existing(s_Paths.PersistentData); }
        }

        public static string temporaryCachePath
        {
            get { MainThread.Check("get_temporaryCachePath"); return Existing(s_Paths.TemporaryCache); }
        }

        /// <summary>Cancelled when the player ends; in edit mode that of the Play before, which has ended.</summary>
        public static CancellationToken exitCancellationToken => s_Exit.Token;

        /// <summary>Whether this is the Editor, not playing.</summary>
        internal static bool InEditMode { get; private set; }

        internal static bool QuitRequested { get; private set; }

        internal static int ExitCode { get; private set; }

        /// <summary>True for what lives in the playing world: not for assets and prefabs, and for nothing in edit mode.</summary>
        public static bool IsPlaying(Object obj)
        {
            if (obj is null)
                throw new NullReferenceException();
            return isPlaying && !obj.IsAsset;
        }

        public static void Quit() => Quit(0);

        /// <summary>Asks the host to end after this frame.</summary>
        public static void Quit(int exitCode)
        {
            MainThread.Check("Quit");
            foreach (var question in wantsToQuit?.GetInvocationList() ?? Array.Empty<Delegate>())
            {
                var agreed = true;
                LogRouter.Guard(() => agreed = ((Func<bool>)question)());
                if (!agreed)
                    return;
            }

            QuitRequested = true;
            ExitCode = exitCode;
        }

        internal static void Begin(EnginePaths paths, bool inEditMode)
        {
            s_Paths = paths;
            InEditMode = inEditMode;
            s_Exit = new CancellationTokenSource();
            if (inEditMode)
                s_Exit.Cancel();
            QuitRequested = false;
            ExitCode = 0;
        }

        /// <summary>One round of onBeforeRender; as in Unity a callback that throws stops the later ones for this frame.</summary>
        internal static void RaiseBeforeRender()
        {
            var ordered = s_BeforeRender.OrderBy(c => c.Method.GetCustomAttribute<BeforeRenderOrderAttribute>(true)?.order ?? 0).ToList();
            LogRouter.Guard(() => ordered.ForEach(c => c()));
        }

        internal static void RaiseQuitting()
        {
            foreach (var callback in quitting?.GetInvocationList() ?? Array.Empty<Delegate>())
                LogRouter.Guard((Action)callback);
            LogRouter.Guard(s_Exit.Cancel);
        }

        internal static void ForgetSubscribers()
        {
            s_BeforeRender.Clear();
            quitting = null;
            wantsToQuit = null;
            ForgetLogSubscribers();
        }

        static string Existing(string folder)
        {
            Directory.CreateDirectory(folder);
            return folder;
        }
    }
}
