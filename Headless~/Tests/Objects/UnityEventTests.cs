using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace AnatomyCarve.Headless.Tests.Objects
{
    public sealed class UnityEventTests : SceneTests
    {
        sealed class Listener : MonoBehaviour
        {
            internal int Calls;

            public void Hear(int value) => Calls += value;
        }

        [Test]
        public void Invoke_CallsListenersInOrder()
        {
            var log = new List<int>();
            var e = new UnityEvent();
            e.AddListener(() => log.Add(1));
            e.AddListener(() => log.Add(2));
            e.Invoke();
            Assert.That(log, Is.EqualTo(new[] { 1, 2 }));
        }

        [Test]
        public void Listener_OfDestroyedObject_IsPassedOver()
        {
            var listener = Make<Listener>("a");
            var e = new UnityEvent<int>();
            e.AddListener(listener.Hear);
            e.Invoke(1);
            Object.DestroyImmediate(listener.gameObject);
            e.Invoke(1);
            Assert.That(listener.Calls, Is.EqualTo(1));
        }

        [Test]
        public void Listener_RemovedDuringInvoke_StillFires()
        {
            var calls = 0;
            var e = new UnityEvent();
            void Second() => calls++;
            e.AddListener(() => e.RemoveListener(Second));
            e.AddListener(Second);
            e.Invoke();
            e.Invoke();
            Assert.That(calls, Is.EqualTo(1));
        }

        [Test]
        public void Exception_InListener_ReachesTheCaller()
        {
            var e = new UnityEvent();
            e.AddListener(() => throw new System.InvalidOperationException("no"));
            Assert.That(e.Invoke, Throws.InvalidOperationException);
        }
    }
}
