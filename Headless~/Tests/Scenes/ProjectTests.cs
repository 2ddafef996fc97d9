using System;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>The ground of tests with files: a project folder and a host that knows it.</summary>
    public abstract class ProjectTests
    {
        UnityHost m_Host;

        internal Project Project { get; private set; }

        internal UnityHost Host => m_Host ??= Start();

        [SetUp]
        public void MakeProject()
        {
            Project = new Project();
            Objects.Recorder.Clear();
        }

        [TearDown]
        public void RemoveProject()
        {
            m_Host?.Dispose();
            var report = m_Host?.Report;
            m_Host = null;
            Project.Dispose();
            Objects.Recorder.Clear();
            if (report != null)
                Assert.That(report.LeakedObjects, Is.Empty);
        }

        /// <summary>Starts the host, which then knows all files written so far.</summary>
        internal UnityHost Start(Action<HostOptions> set = null)
        {
            var options = new HostOptions { Log = (_, _, _) => { } };
            set?.Invoke(options);
            m_Host = UnityHost.Start(options);
            Project.Open();
            return m_Host;
        }

        /// <summary>Writes a scene and loads it.</summary>
        internal void Load(Yaml scene)
        {
            var path = Project.Write("Test.unity", scene.ToString());
            Host.LoadScene(path);
        }

        internal static GameObject Find(string name) => GameObject.Find(name);
    }
}
