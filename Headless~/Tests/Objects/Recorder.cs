using System;
using System.Collections.Generic;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Objects
{
    /// <summary>A script that writes down its messages as "name.Message".</summary>
    public class Recorder : MonoBehaviour
    {
        internal static List<string> Log { get; } = new();

        /// <summary>What a message does besides being recorded: by message name.</summary>
        internal static Dictionary<string, Action<Recorder>> Reactions { get; } = new();

        internal static void Clear()
        {
            Log.Clear();
            Reactions.Clear();
        }

        protected void Record(string message)
        {
            Log.Add(name + "." + message);
            if (Reactions.TryGetValue(message, out var reaction))
                reaction(this);
        }

        void Awake() => Record("Awake");

        void OnEnable() => Record("OnEnable");

        void Start() => Record("Start");

        void OnDisable() => Record("OnDisable");

        void OnDestroy() => Record("OnDestroy");
    }

    /// <summary>A recorder with per-frame messages.</summary>
    public class FrameRecorder : Recorder
    {
        void FixedUpdate() => Record("FixedUpdate");

        void Update() => Record("Update");

        void LateUpdate() => Record("LateUpdate");
    }

    [DefaultExecutionOrder(-100)]
    public sealed class EarlyRecorder : FrameRecorder
    {
    }

    /// <summary>The ground of the tests here: an empty record before, no objects left after.</summary>
    public abstract class SceneTests
    {
        [NUnit.Framework.SetUp]
        public void ClearRecord() => Recorder.Clear();

        [NUnit.Framework.TearDown]
        public void DestroyAll()
        {
            Recorder.Clear();
            foreach (var g in UnityEngine.Object.FindObjectsByType<GameObject>(FindObjectsInactive.Include, FindObjectsSortMode.None))
                if (g != null && g.transform.parent == null && g.name != "Code-based tests runner")
                    UnityEngine.Object.DestroyImmediate(g);
        }

        private protected static void Frame(float seconds = 0.02f) => ObjectsSetUp.Host.Step(seconds);

        private protected static T Make<T>(string name) where T : Component => new GameObject(name).AddComponent<T>();
    }
}
