using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Import
{
    /// <summary>Menu entries, selection and undo on the host.</summary>
    public sealed class EditorTests
    {
        UnityHost m_Host;

        [SetUp]
        public void StartHost() => m_Host = UnityHost.Start(new HostOptions { PlayMode = false, Log = (_, _, _) => { } });

        [TearDown]
        public void EndHost() => m_Host.Dispose();

        static class Entries
        {
            internal static Object Context { get; private set; }

            [MenuItem("Tests/Entry %#e")]
            static void Run(MenuCommand command) => Context = command.context;

            [MenuItem("Tests/Forbidden")]
            static void Forbidden() => Context = null;

            [MenuItem("Tests/Forbidden", true)]
            static bool MayRun() => false;
        }

        sealed class Thing : MonoBehaviour
        {
            [SerializeField]
            internal int number = 1;

            [SerializeField]
            internal string[] words = { "a" };
        }

        [Test]
        public void MenuEntry_GetsTheSelection()
        {
            var thing = new GameObject("thing");
            Selection.activeGameObject = thing;
            Assert.That((EditorApplication.ExecuteMenuItem("Tests/Entry"), Entries.Context), Is.EqualTo((true, thing)));
        }

        [Test]
        public void MenuEntry_ThatMayNotRun_DoesNot() => Assert.That(EditorApplication.ExecuteMenuItem("Tests/Forbidden"), Is.False);

        [Test]
        public void MenuEntry_ThatIsNone_DoesNot() => Assert.That(EditorApplication.ExecuteMenuItem("Tests/Nothing"), Is.False);

        [Test]
        public void MenuEntry_OfThePackage_MakesAVolume()
        {
            var parent = new GameObject("parent") { layer = 5 };
            Selection.activeGameObject = parent;
            Assert.That(EditorApplication.ExecuteMenuItem("GameObject/AnatomyCarve/Carved Volume"), Is.True);
            var made = Selection.activeGameObject;
            Assert.That((made.GetComponent<VolumeLoader>() != null, made.transform.parent, made.layer), Is.EqualTo((true, parent.transform, 5)));
            Undo.PerformUndo();
            Assert.That(made == null, Is.True);
        }

        [Test]
        public void Undo_Recorded_RestoresFields()
        {
            var thing = new GameObject("thing").AddComponent<Thing>();
            Undo.RecordObject(thing, "Change");
            (thing.number, thing.words) = (5, new[] { "b", "c" });
            Undo.PerformUndo();
            Assert.That((thing.number, thing.words), Is.EqualTo((1, new[] { "a" })));
            Undo.PerformRedo();
            Assert.That((thing.number, thing.words), Is.EqualTo((5, new[] { "b", "c" })));
        }

        [Test]
        public void Undo_OfGroups_GoesOneAtATime()
        {
            var thing = new GameObject("thing").AddComponent<Thing>();
            Undo.RecordObject(thing, "First");
            thing.number = 2;
            Undo.IncrementCurrentGroup();
            Undo.RecordObject(thing, "Second");
            thing.number = 3;
            Undo.PerformUndo();
            Assert.That(thing.number, Is.EqualTo(2));
        }

        [Test]
        public void Undo_OfNoChange_IsNoStep()
        {
            var thing = new GameObject("thing").AddComponent<Thing>();
            Undo.RecordObject(thing, "First");
            thing.number = 2;
            Undo.IncrementCurrentGroup();
            Undo.RecordObject(thing, "Nothing");
            Undo.PerformUndo();
            Assert.That(thing.number, Is.EqualTo(1));
        }

        [Test]
        public void UniqueNames_GetNumbers()
        {
            new GameObject("a");
            new GameObject("a (1)");
            Assert.That(GameObjectUtility.GetUniqueNameForSibling(null, "a"), Is.EqualTo("a (2)"));
        }
    }
}
