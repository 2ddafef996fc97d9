using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Plays the open scene until its volumes are loaded and some frames have passed, takes pictures, writes the report, and ends the Editor. Entering Play
    /// reloads the domain: what has to survive that stands in SessionState.
    /// </summary>
    sealed class VerificationRun
    {
        const string OutputKey = "AnatomyCarve.Verification.Output", SceneKey = "AnatomyCarve.Verification.Scene";
        const string StartKey = "AnatomyCarve.Verification.Start", ErrorsKey = "AnatomyCarve.Verification.Errors";
        const float PatienceSeconds = 300f;
        const int FramesAfterLoading = 20;
        const string PackageName = "AnatomyCarve";
        const char Separator = '\u001e';

        readonly string output = SessionState.GetString(OutputKey, "");
        readonly HashSet<VolumeLoader> listenedTo = new HashSet<VolumeLoader>();
        string loadFailure;
        int loadedFrame = -1;
        float loadedSeconds;

        static float Seconds => (float)EditorApplication.timeSinceStartup - SessionState.GetFloat(StartKey, 0f);

        /// <summary>Starts with the open scene; it ends by itself.</summary>
        /// <param name="folder">Where pictures and report go; it exists.</param>
        /// <param name="scene">What the report calls the scene.</param>
        public static void Start(string folder, string scene)
        {
            SessionState.SetString(OutputKey, folder);
            SessionState.SetString(SceneKey, scene);
            SessionState.SetString(ErrorsKey, "");
            SessionState.SetFloat(StartKey, (float)EditorApplication.timeSinceStartup);
            new VerificationRun().Attach();
            EditorApplication.EnterPlaymode();
        }

        [InitializeOnLoadMethod]
        static void Resume()
        {
            if (SessionState.GetString(OutputKey, "").Length > 0)
                new VerificationRun().Attach();
        }

        void Attach()
        {
            Application.logMessageReceived += NoteError;
            EditorApplication.update += Step;
        }

        void Step()
        {
            if (Seconds > PatienceSeconds)
                End(new[] { $"The volumes were not loaded within {PatienceSeconds} seconds." });
            else if (EditorApplication.isPlaying)
                StepInPlay();
        }

        void StepInPlay()
        {
            VolumeLoader[] loaders = Object.FindObjectsByType<VolumeLoader>(FindObjectsSortMode.None);
            if (loadedFrame < 0)
            {
                foreach (VolumeLoader loader in loaders)
                    if (listenedTo.Add(loader))
                        loader.Failed += e => loadFailure = $"{loader.name} could not be loaded: {e.Message}";
                if (loadFailure != null)
                    End(new[] { loadFailure });
                else if (loaders.Length == 0 && Time.frameCount > FramesAfterLoading)
                    End(new[] { "The scene has no Volume Loader." });
                else if (loaders.Length > 0 && loaders.All(l => l.Volume != null && !l.IsLoading))
                    NoteLoaded();
            }
            else if (Time.frameCount >= loadedFrame + FramesAfterLoading)
            {
                End(Array.Empty<string>());
            }
        }

        void NoteLoaded()
        {
            loadedFrame = Time.frameCount;
            loadedSeconds = Seconds;
            Debug.Log($"AnatomyCarve verification: loaded after {loadedSeconds:0.0} s, frame {loadedFrame}.");
        }

        void End(IReadOnlyList<string> failures)
        {
            EditorApplication.update -= Step;
            var report = new VerificationReport { scene = SessionState.GetString(SceneKey, ""), frames = Time.frameCount, secondsUntilLoaded = loadedSeconds };
            report.failures.AddRange(failures);
            try
            {
                report.DescribeMachine();
                if (failures.Count == 0)
                    TakePictures(report);
            }
            catch (Exception e)
            {
                report.failures.Add(e.ToString()); // so that whoever reads the report sees it; the exit code says it too
            }
            Application.logMessageReceived -= NoteError;
            SessionState.EraseString(OutputKey); // no run is to be resumed any more
            report.errorsLogged.AddRange(SessionState.GetString(ErrorsKey, "").Split(new[] { Separator }, StringSplitOptions.RemoveEmptyEntries));
            if (report.errorsLogged.Count > 0)
                report.failures.Add($"{report.errorsLogged.Count} errors were logged.");
            Finish(report);
        }

        void TakePictures(VerificationReport report)
        {
            Camera camera = Camera.allCameras.Where(c => c.cameraType == CameraType.Game).OrderByDescending(c => c.CompareTag("MainCamera")).FirstOrDefault();
            CarvedVolumeRenderer renderer = Object.FindObjectsByType<CarvedVolumeRenderer>(FindObjectsSortMode.None)
                .FirstOrDefault(r => r.isActiveAndEnabled && r.Volume != null);
            if (camera == null)
                report.failures.Add("The scene has no enabled camera.");
            if (renderer == null)
                report.failures.Add("The scene has no enabled Carved Volume Renderer with a volume.");
            if (camera == null || renderer == null)
                return;
            VerificationPictures.Take(camera, renderer, output, report);
            report.DescribeVolume(renderer);
            if (report.problem.Length > 0)
                report.failures.Add(report.problem);
        }

        void Finish(VerificationReport report)
        {
            try
            {
                report.Write(output);
            }
            catch (Exception e)
            {
                Debug.LogException(e); // and on to the end: nobody else would stop an Editor in batch mode
                report.passed = false;
            }
            Debug.Log($"AnatomyCarve verification: {(report.passed ? "passed" : "failed")}, see {output}.\n{string.Join("\n", report.failures)}");
            if (Application.isBatchMode)
                EditorApplication.Exit(report.passed ? 0 : 1);
            else
                EditorApplication.ExitPlaymode();
        }

        static void NoteError(string condition, string stackTrace, LogType type)
        {
            bool isError = type == LogType.Error || type == LogType.Exception || type == LogType.Assert;
            bool isOurs = condition.Contains(PackageName) || stackTrace.Contains(PackageName);
            if (isError && isOurs) // a headset that is not there is not this package's failure
                SessionState.SetString(ErrorsKey, SessionState.GetString(ErrorsKey, "") + Separator + condition);
        }
    }
}
