using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using UnityEngine.TestTools.Utils;

namespace AnatomyCarve.Headless.Tests.Objects
{
    public sealed class TransformTests : SceneTests
    {
        static Transform Node(string name, Transform parent, Vector3 position, Quaternion rotation, Vector3 scale)
        {
            var t = new GameObject(name).transform;
            t.SetParent(parent, false);
            t.SetLocalPositionAndRotation(position, rotation);
            t.localScale = scale;
            return t;
        }

        /// <summary>A parent at (1,2,3), turned by 90 degrees about y, twice as large.</summary>
        static Transform Parent() => Node("parent", null, new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 90f, 0f), new Vector3(2f, 2f, 2f));

        [Test]
        public void TransformPoint_ScalesThenTurnsThenMoves() =>
            Assert.That(Parent().TransformPoint(0f, 0f, 1f), Is.EqualTo(new Vector3(3f, 2f, 3f)).Using(Vector3EqualityComparer.Instance));

        [Test]
        public void InverseTransformPoint_UndoesTransformPoint() =>
            Assert.That(Parent().InverseTransformPoint(new Vector3(3f, 2f, 3f)), Is.EqualTo(Vector3.forward).Using(Vector3EqualityComparer.Instance));

        [Test]
        public void TransformDirection_KeepsTheLength() =>
            Assert.That(Parent().TransformDirection(Vector3.forward), Is.EqualTo(Vector3.right).Using(Vector3EqualityComparer.Instance));

        [Test]
        public void TransformVector_ScalesButDoesNotMove() =>
            Assert.That(Parent().TransformVector(Vector3.forward), Is.EqualTo(Vector3.right * 2f).Using(Vector3EqualityComparer.Instance));

        [Test]
        public void Position_OfChild_IsInWorldSpace()
        {
            var child = Node("child", Parent(), Vector3.forward, Quaternion.identity, Vector3.one);
            Assert.That(child.position, Is.EqualTo(new Vector3(3f, 2f, 3f)).Using(Vector3EqualityComparer.Instance));
        }

        [Test]
        public void Position_SetOnChild_GivesTheLocalOne()
        {
            var child = Node("child", Parent(), Vector3.zero, Quaternion.identity, Vector3.one);
            child.position = new Vector3(3f, 2f, 3f);
            Assert.That(child.localPosition, Is.EqualTo(Vector3.forward).Using(Vector3EqualityComparer.Instance));
        }

        [Test]
        public void SetParent_KeepingTheWorldPosition_ChangesTheLocalPose()
        {
            var child = Node("child", null, new Vector3(3f, 2f, 3f), Quaternion.Euler(0f, 90f, 0f), Vector3.one);
            child.SetParent(Parent(), true);
            Assert.That(child.localPosition, Is.EqualTo(Vector3.forward).Using(Vector3EqualityComparer.Instance));
            Assert.That(child.localRotation, Is.EqualTo(Quaternion.identity).Using(QuaternionEqualityComparer.Instance));
            Assert.That(child.localScale, Is.EqualTo(Vector3.one * 0.5f).Using(Vector3EqualityComparer.Instance));
        }

        [Test]
        public void SetParent_NotKeepingTheWorldPosition_KeepsTheLocalPose()
        {
            var child = Node("child", null, Vector3.forward, Quaternion.identity, Vector3.one);
            child.SetParent(Parent(), false);
            Assert.That(child.localPosition, Is.EqualTo(Vector3.forward));
        }

        [Test]
        public void SetParent_ToOwnChild_IsRefused()
        {
            var parent = Parent();
            var child = Node("child", parent, Vector3.zero, Quaternion.identity, Vector3.one);
            LogAssert.Expect(LogType.Error, "Cannot set the parent of the GameObject to one of its children or itself.");
            parent.SetParent(child);
            Assert.That(parent.parent == null, Is.True);
        }

        [Test]
        public void SetParent_ToInactiveObject_DeactivatesTheChild()
        {
            var parent = Parent();
            parent.gameObject.SetActive(false);
            var script = Make<Recorder>("a");
            script.transform.SetParent(parent);
            Assert.That((script.gameObject.activeInHierarchy, Recorder.Log[^1]), Is.EqualTo((false, "a.OnDisable")));
        }

        [Test]
        public void LossyScale_OfTurnedChild_IsTheProduct()
        {
            var child = Node("child", Parent(), Vector3.zero, Quaternion.Euler(0f, 90f, 0f), new Vector3(1f, 3f, 1f));
            Assert.That(child.lossyScale, Is.EqualTo(new Vector3(2f, 6f, 2f)).Using(Vector3EqualityComparer.Instance));
        }

        [Test]
        public void Rotation_BelowMirroringParent_AgreesWithTheMatrix()
        {
            var mirror = Node("mirror", null, Vector3.zero, Quaternion.identity, new Vector3(-1f, 1f, 1f));
            var child = Node("child", mirror, Vector3.zero, Quaternion.Euler(0f, 30f, 0f), Vector3.one);
            var axis = child.localToWorldMatrix.MultiplyVector(Vector3.forward);
            Assert.That(child.forward, Is.EqualTo(axis).Using(Vector3EqualityComparer.Instance));
        }

        [Test]
        public void HasChanged_AfterAParentMoved_IsTrue()
        {
            var parent = Parent();
            var child = Node("child", parent, Vector3.zero, Quaternion.identity, Vector3.one);
            child.hasChanged = false;
            parent.position = Vector3.zero;
            Assert.That(child.hasChanged, Is.True);
        }

        [Test]
        public void Children_KeepTheirOrder()
        {
            var parent = Parent();
            var a = Node("a", parent, Vector3.zero, Quaternion.identity, Vector3.one);
            var b = Node("b", parent, Vector3.zero, Quaternion.identity, Vector3.one);
            b.SetAsFirstSibling();
            Assert.That((parent.GetChild(0), parent.GetChild(1), a.GetSiblingIndex()), Is.EqualTo((b, a, 1)));
        }

        [Test]
        public void Find_WithPath_FollowsIt()
        {
            var parent = Parent();
            var child = Node("b", Node("a", parent, Vector3.zero, Quaternion.identity, Vector3.one), Vector3.zero, Quaternion.identity, Vector3.one);
            Assert.That(parent.Find("a/b"), Is.EqualTo(child));
        }

        [Test]
        public void LookAt_PointsForwardAtTheTarget()
        {
            var t = new GameObject("a").transform;
            t.LookAt(new Vector3(0f, 0f, -5f));
            Assert.That(t.forward, Is.EqualTo(Vector3.back).Using(Vector3EqualityComparer.Instance));
        }

        [Test]
        public void Position_NotANumber_IsRefused()
        {
            var t = new GameObject("a").transform;
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("^transform.position assign attempt"));
            t.position = new Vector3(float.NaN, 0f, 0f);
            Assert.That(t.position, Is.EqualTo(Vector3.zero));
        }

        [Test]
        public void GetComponentsInChildren_WithoutInactive_LeavesThemOut()
        {
            var parent = Make<Recorder>("a");
            var child = Make<Recorder>("b");
            child.transform.SetParent(parent.transform);
            child.gameObject.SetActive(false);
            Assert.That((parent.GetComponentsInChildren<Recorder>().Length, parent.GetComponentsInChildren<Recorder>(true).Length), Is.EqualTo((1, 2)));
        }
    }
}
