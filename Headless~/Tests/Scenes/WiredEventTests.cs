using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>UnityEvents wired in the Inspector.</summary>
    public sealed class WiredEventTests : ProjectTests
    {
        static string Call(string method, int mode, string argument = "m_StringArgument: ", int state = 2, long target = 22) =>
            $"\n    - m_Target: {{fileID: {target}}}\n      m_TargetAssemblyTypeName: {typeof(SceneFields).FullName}, Tests\n"
            + $"      m_MethodName: {method}\n      m_Mode: {mode}\n      m_Arguments:\n        m_ObjectArgument: {{fileID: 0}}\n"
            + $"        {argument}\n      m_CallState: {state}";

        Yaml Scene(string field, string calls) => new Yaml().GameObject(10, "a", components: [12])
            .Script(12, 10, Project.Script<SceneFields>(), $"{field}:\n  m_PersistentCalls:\n    m_Calls:{calls}")
            .GameObject(20, "b", components: [22]).Script(22, 20, Project.Script<SceneFields>()).Roots(11, 21);

        static SceneFields A => Find("a").GetComponent<SceneFields>();

        static SceneFields B => Find("b").GetComponent<SceneFields>();

        [Test]
        public void Invoke_CallsWhatIsWired_ThenWhatWasAdded()
        {
            Load(Scene("happened",
                Call("Note", 1) + Call("NoteText", 5, "m_StringArgument: hello") + Call("NoteNumber", 4, "m_FloatArgument: 2.5")));
            A.happened.AddListener(() => B.Calls.Add("added"));
            A.happened.Invoke();
            Assert.That(B.Calls, Is.EqualTo(new[] { "Note", "hello", "2.5", "added" }));
            Assert.That((A.happened.GetPersistentEventCount(), A.happened.GetPersistentMethodName(1)), Is.EqualTo((3, "NoteText")));
            Assert.That(A.happened.GetPersistentTarget(0), Is.SameAs(B));
        }

        [Test]
        public void Invoke_WithAnArgument_PassesItOn()
        {
            Load(Scene("changed", Call("NoteNumber", 0)));
            A.changed.Invoke(4f);
            Assert.That(B.Calls, Is.EqualTo(new[] { "4" }));
        }

        [Test]
        public void Invoke_OfASwitchedOffCall_DoesNothing()
        {
            Load(Scene("happened", Call("Note", 1, state: 0)));
            A.happened.Invoke();
            A.happened.SetPersistentListenerState(0, UnityEventCallState.RuntimeOnly);
            A.happened.Invoke();
            Assert.That(B.Calls, Is.EqualTo(new[] { "Note" }));
        }

        [Test]
        public void Invoke_AfterTheTargetDied_DoesNothing()
        {
            Load(Scene("happened", Call("Note", 1)));
            var b = B;
            Object.DestroyImmediate(b.gameObject);
            A.happened.Invoke();
            Assert.That(b.Calls, Is.Empty);
        }

        [Test]
        public void Instantiate_KeepsWhatIsWired()
        {
            Load(Scene("happened", Call("Note", 1) + Call("Note", 1, target: 12)));
            var copy = Object.Instantiate(A);
            copy.happened.Invoke();
            Assert.That((B.Calls.Count, A.Calls.Count, copy.Calls.Count), Is.EqualTo((1, 0, 1)), "a target inside is the copy's");
        }

        [Test]
        public void Load_WithoutSuchAMethod_IsRefused()
        {
            var path = Project.Write("Test.unity", Scene("happened", Call("Noet", 1)).ToString());
            Assert.That(() => Host.LoadScene(path), Throws.TypeOf<AssetFormatException>().With.Message.Contains("SceneFields has no method Noet()"));
        }

        [Test]
        public void Load_WithNothingWired_HasNoCalls()
        {
            Load(Scene("happened", " []"));
            Assert.That(A.happened.GetPersistentEventCount(), Is.Zero);
        }
    }
}
