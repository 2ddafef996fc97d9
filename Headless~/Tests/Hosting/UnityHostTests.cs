using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Headless.Tests.Hosting
{
    /// <summary>Start and end of the host. Nothing here touches the device.</summary>
    public sealed class UnityHostTests
    {
        static readonly List<string> s_Log = new();

        readonly List<string> m_Messages = new();

        [SetUp]
        public void ClearLogs()
        {
            s_Log.Clear();
            m_Messages.Clear();
        }

        UnityHost Start() => UnityHost.Start(new HostOptions { Log = (type, message, _) => m_Messages.Add($"{type}: {message}") });

        sealed class Quitter : MonoBehaviour
        {
            void OnApplicationQuit() => s_Log.Add("OnApplicationQuit");

            void OnDisable() => s_Log.Add("OnDisable");

            void OnDestroy() => s_Log.Add("OnDestroy");
        }

        sealed class Data : ScriptableObject
        {
        }

        [Test]
        public void Dispose_QuitsThenDisablesThenDestroys()
        {
            using (Start())
                new GameObject("a").AddComponent<Quitter>();
            Assert.That(s_Log, Is.EqualTo(new[] { "OnApplicationQuit", "OnDisable", "OnDestroy" }));
        }

        [Test]
        public void Dispose_ReportsWhatOutlivesTheScene()
        {
            var host = Start();
            new GameObject("a");
            ScriptableObject.CreateInstance<Data>().name = "forgotten";
            host.Dispose();
            Assert.That(host.Report.LeakedObjects, Is.EqualTo(new[] { "Data 'forgotten'" }));
        }

        [Test]
        public void Dispose_Twice_IsHarmless()
        {
            var host = Start();
            host.Dispose();
            Assert.That(host.Dispose, Throws.Nothing);
        }

        [Test]
        public void Dispose_LeavesNothingAlive()
        {
            GameObject left;
            using (Start())
                left = new GameObject("a");
            Assert.That(left == null, Is.True);
        }

        [Test]
        public void Start_WhileAnotherRuns_Throws()
        {
            using var host = Start();
            Assert.That(Start, Throws.InvalidOperationException);
        }

        [Test]
        public void Start_AfterAnotherEnded_BeginsAnew()
        {
            using (var first = Start())
                first.Step();
            using var second = Start();
            Assert.That(Time.frameCount, Is.Zero);
        }

        [Test]
        public void Start_WithoutPackage_Throws() =>
            Assert.That(() => UnityHost.Start(new HostOptions { PackageRoot = Path.Combine(Path.GetTempPath(), Guid.NewGuid().ToString()) }),
                Throws.InstanceOf<DirectoryNotFoundException>());

        [Test]
        public void Dispose_CancelsTheExitToken()
        {
            CancellationToken token;
            using (Start())
                token = Application.exitCancellationToken;
            Assert.That(token.IsCancellationRequested, Is.True);
        }

        [Test]
        public void Dispose_RestoresTheSynchronizationContext()
        {
            var before = SynchronizationContext.Current;
            Start().Dispose();
            Assert.That(SynchronizationContext.Current, Is.SameAs(before));
        }

        [Test]
        public void RunUntil_WhatNeverHappens_IsFalseAfterAllFrames()
        {
            using var host = Start();
            Assert.That((host.RunUntil(() => false, 5), Time.frameCount), Is.EqualTo((false, 5)));
        }

        [Test]
        public void Step_AfterDispose_Throws()
        {
            var host = Start();
            host.Dispose();
            Assert.That(() => host.Step(), Throws.TypeOf<ObjectDisposedException>());
        }

        [Test]
        public void Quit_IsSeenByTheHost()
        {
            using var host = Start();
            Application.Quit(3);
            Assert.That(host.QuitRequested, Is.True);
        }

        [Test]
        public void Log_ReceivesMessages()
        {
            using (Start())
                Debug.LogWarning("careful");
            Assert.That(m_Messages, Is.EqualTo(new[] { "Warning: careful" }));
        }

        [Test]
        public void ErrorsAtEnd_CountsWhatOnDestroyThrows()
        {
            var host = Start();
            new GameObject("a").AddComponent<Thrower>();
            host.Dispose();
            Assert.That(host.Report.ErrorsAtEnd, Is.EqualTo(1));
        }

        sealed class Thrower : MonoBehaviour
        {
            void OnDestroy() => throw new InvalidOperationException("no");
        }

        [Test]
        public void PersistentDataPath_LiesInTheDataFolder()
        {
            var folder = Path.Combine(TestContext.CurrentContext.WorkDirectory, "data");
            using var host = UnityHost.Start(new HostOptions { DataFolder = folder });
            Assert.That(Application.persistentDataPath, Is.EqualTo(Path.Combine(folder, "PersistentData")).And.Exist);
        }
    }
}
