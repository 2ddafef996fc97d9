using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Objects
{
    public sealed class FakeNullTests : SceneTests
    {
        [Test]
        public void Object_AfterDestroyImmediate_EqualsNull()
        {
            var g = new GameObject("a");
            Object.DestroyImmediate(g);
            Assert.That(g == null, Is.True);
        }

        [Test]
        public void Object_AfterDestroyImmediate_IsNoRealNull()
        {
            var g = new GameObject("a");
            Object.DestroyImmediate(g);
            Assert.That(g is null, Is.False);
        }

        [Test]
        public void Object_AfterDestroyImmediate_ConvertsToFalse()
        {
            var g = new GameObject("a");
            Object.DestroyImmediate(g);
            Assert.That((bool)g, Is.False);
        }

        [Test]
        public void DestroyedObject_ComparedWithItself_IsEqual()
        {
            var g = new GameObject("a");
            var same = g;
            Object.DestroyImmediate(g);
            Assert.That(g == same, Is.True);
        }

        [Test]
        public void DestroyedObject_EqualsOfNull_IsTrue()
        {
            var g = new GameObject("a");
            Object.DestroyImmediate(g);
            Assert.That(g.Equals(null), Is.True);
        }

        [Test]
        public void HashCode_AfterDestruction_StaysTheInstanceId()
        {
            var g = new GameObject("a");
            var id = g.GetInstanceID();
            Object.DestroyImmediate(g);
            Assert.That((g.GetHashCode(), g.GetInstanceID()), Is.EqualTo((id, id)));
        }

        [Test]
        public void DestroyedObject_Used_Throws()
        {
            var g = new GameObject("a");
            var t = g.transform;
            Object.DestroyImmediate(g);
            Assert.That(() => t.position, Throws.InstanceOf<System.NullReferenceException>());
        }

        [Test]
        public void GetComponent_OfMissingOne_IsRealNull()
        {
            object found = new GameObject("a").GetComponent<Camera>();
            Assert.That(found, Is.Null);
        }

        [Test]
        public void MonoBehaviour_MadeWithNew_IsDeadAndWarns()
        {
            UnityEngine.TestTools.LogAssert.Expect(LogType.Warning, new System.Text.RegularExpressions.Regex("using the 'new' keyword"));
            Assert.That(new Recorder() == null, Is.True);
        }

        [Test]
        public void Component_OfDestroyedGameObject_IsDead()
        {
            var script = Make<Recorder>("a");
            Object.DestroyImmediate(script.gameObject);
            Assert.That(script == null, Is.True);
        }
    }
}
