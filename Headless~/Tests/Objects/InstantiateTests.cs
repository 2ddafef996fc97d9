using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Headless.Tests.Objects
{
    [Serializable]
    public sealed class Inner
    {
        public int number = 7;
        public string text;
    }

    /// <summary>A script with fields of every kind that matters to copying.</summary>
    public sealed class Fields : MonoBehaviour
    {
        public Transform inside;
        public Transform outside;
        public List<Inner> list;
        public int[] array;
        public Inner shared;
        public string text;
        public Dictionary<string, int> dictionary;

        [SerializeField]
        Vector3Int m_Private;

        [NonSerialized]
        public int unserialized;

        [field: SerializeField]
        public float Property { get; set; }

        internal Vector3Int Private { get => m_Private; set => m_Private = value; }

        internal bool WokeWithReference { get; private set; }

        void Awake() => WokeWithReference = inside != null;
    }

    public sealed class InstantiateTests : SceneTests
    {
        static Fields Original()
        {
            var g = new GameObject("original");
            var child = new GameObject("child");
            child.transform.SetParent(g.transform);
            var fields = g.AddComponent<Fields>();
            fields.inside = child.transform;
            return fields;
        }

        [Test]
        public void Copy_IsNamedClone() => Assert.That(Object.Instantiate(Original()).name, Is.EqualTo("original(Clone)"));

        [Test]
        public void Reference_InsideTheHierarchy_PointsIntoTheCopy()
        {
            var copy = Object.Instantiate(Original());
            Assert.That(copy.inside.parent, Is.EqualTo(copy.transform));
        }

        [Test]
        public void Reference_OutOfTheHierarchy_Stays()
        {
            var original = Original();
            original.outside = new GameObject("other").transform;
            Assert.That(Object.Instantiate(original).outside, Is.EqualTo(original.outside));
        }

        [Test]
        public void List_IsCopiedDeeply()
        {
            var original = Original();
            original.list = new List<Inner> { new() { number = 3 } };
            var copy = Object.Instantiate(original);
            original.list[0].number = 4;
            Assert.That(copy.list[0].number, Is.EqualTo(3));
        }

        [Test]
        public void NullFields_ComeBackAsDefaults()
        {
            var copy = Object.Instantiate(Original());
            Assert.That((copy.text, copy.array.Length, copy.shared.number), Is.EqualTo(("", 0, 7)));
        }

        [Test]
        public void UnserializedFields_AreNotCopied()
        {
            var original = Original();
            original.unserialized = 5;
            original.dictionary = new Dictionary<string, int>();
            var copy = Object.Instantiate(original);
            Assert.That((copy.unserialized, copy.dictionary), Is.EqualTo((0, (Dictionary<string, int>)null)));
        }

        [Test]
        public void PrivateSerializedFieldAndAutoProperty_AreCopied()
        {
            var original = Original();
            original.Private = new Vector3Int(1, 2, 3);
            original.Property = 4f;
            var copy = Object.Instantiate(original);
            Assert.That((copy.Private, copy.Property), Is.EqualTo((new Vector3Int(1, 2, 3), 4f)));
        }

        [Test]
        public void Copy_WakesWithItsFieldsInPlace() => Assert.That(Object.Instantiate(Original()).WokeWithReference, Is.True);

        [Test]
        public void Copy_OfInactiveObject_IsInactive()
        {
            var original = Original();
            original.gameObject.SetActive(false);
            var copy = Object.Instantiate(original.gameObject);
            Assert.That((copy.activeSelf, copy.transform.GetChild(0).gameObject.activeSelf), Is.EqualTo((false, true)));
        }

        [Test]
        public void Copy_WithPose_StandsThere()
        {
            var copy = Object.Instantiate(Original(), new Vector3(1f, 2f, 3f), Quaternion.identity);
            Assert.That(copy.transform.position, Is.EqualTo(new Vector3(1f, 2f, 3f)));
        }

        [Test]
        public void Camera_IsCopiedWithItsSettings()
        {
            var camera = Make<Camera>("camera");
            camera.fieldOfView = 33f;
            Assert.That(Object.Instantiate(camera).fieldOfView, Is.EqualTo(33f));
        }

        [Test]
        public void Null_Throws() => Assert.That(() => Object.Instantiate<GameObject>(null),
            Throws.TypeOf<ArgumentException>().With.Message.EqualTo("The Object you want to instantiate is null."));
    }
}
