using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;
using AnatomyCarve.Headless.Tests.Objects;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>Scenes that scripts load.</summary>
    public sealed class SceneManagerTests : ProjectTests
    {
        readonly List<string> m_Log = new();
        readonly List<string> m_Messages = new();

        void StartWithTwoScenes()
        {
            m_Log.Clear();
            m_Messages.Clear();
            string Scene(string name) =>
                new Yaml().GameObject(10, name, components: [12]).Script(12, 10, Project.Script<Recorder>()).Roots(11).ToString();
            var first = Project.Write("First.unity", Scene("a"));
            var second = Project.Write("Second.unity", Scene("b"));
            Start(o => (o.ExtraRoots, o.Scenes, o.Log) = ([Project.Root], [first, second], (type, text, _) => m_Messages.Add($"{type}: {text}")));
        }

        [Test]
        public void LoadScene_TakesEffectWithTheNextFrame()
        {
            StartWithTwoScenes();
            SceneManager.sceneLoaded += (scene, mode) => m_Log.Add($"{scene.name} {mode} {Recorder.Log.Count}");
            SceneManager.LoadScene("Second");
            Assert.That(SceneManager.GetActiveScene().name, Is.Empty);
            Host.Step();
            Assert.That(m_Log, Is.EqualTo(new[] { "Second Single 2" }), "after Awake and OnEnable, before Start");
            Assert.That((SceneManager.GetActiveScene().buildIndex, Recorder.Log[2]), Is.EqualTo((1, "b.Start")));
        }

        [Test]
        public void LoadScene_ByPathOrIndex_IsTheSame()
        {
            StartWithTwoScenes();
            SceneManager.LoadScene(0);
            Host.Step();
            var path = SceneManager.GetActiveScene().path;
            Assert.That(path, Is.EqualTo($"Assets/{System.IO.Path.GetFileName(Project.Root)}/First.unity"));
            SceneManager.LoadScene(path.Replace("First.unity", "Second"));
            Host.Step();
            Assert.That(SceneManager.GetActiveScene().name, Is.EqualTo("Second"));
        }

        [Test]
        public void LoadScene_Additive_KeepsTheFirst()
        {
            StartWithTwoScenes();
            SceneManager.LoadScene(0);
            Host.Step();
            SceneManager.LoadScene("Second", LoadSceneMode.Additive);
            Host.Step();
            Assert.That((SceneManager.sceneCount, SceneManager.GetActiveScene().name, Find("b").scene.name), Is.EqualTo((2, "First", "Second")));
            SceneManager.UnloadSceneAsync("Second");
            Host.Step();
            Assert.That((SceneManager.sceneCount, Find("a") != null, Find("b") == null), Is.EqualTo((1, true, true)));
        }

        [Test]
        public void DontDestroyOnLoad_OutlivesTheScene()
        {
            StartWithTwoScenes();
            var kept = new GameObject("kept");
            Object.DontDestroyOnLoad(kept);
            SceneManager.LoadScene("First");
            Host.Step();
            Assert.That((kept != null, kept.scene.name, SceneManager.sceneCount), Is.EqualTo((true, "DontDestroyOnLoad", 1)));
        }

        [Test]
        public void LoadSceneAsync_IsAwaitedByACoroutine()
        {
            StartWithTwoScenes();
            var runner = new GameObject("runner").AddComponent<Recorder>();
            Object.DontDestroyOnLoad(runner.gameObject);
            runner.StartCoroutine(Wait());
            Host.Step();
            Assert.That(m_Log, Is.EqualTo(new[] { "Second" }));

            IEnumerator Wait()
            {
                yield return SceneManager.LoadSceneAsync("Second");
                m_Log.Add(SceneManager.GetActiveScene().name);
            }
        }

        [Test]
        public void LoadScene_NotInTheBuild_IsAnError()
        {
            StartWithTwoScenes();
            SceneManager.LoadScene("Third");
            Assert.That(m_Messages, Has.Exactly(1).StartsWith("Error: Scene 'Third' couldn't be loaded"));
        }

        [Test]
        public void CreateScene_TakesObjects()
        {
            StartWithTwoScenes();
            var scene = SceneManager.CreateScene("made");
            var thing = new GameObject("thing");
            SceneManager.MoveGameObjectToScene(thing, scene);
            var child = new GameObject("child");
            child.transform.SetParent(thing.transform);
            Assert.That((scene.rootCount, child.scene == scene, SceneManager.GetActiveScene().rootCount), Is.EqualTo((1, true, 0)));
        }
    }
}
