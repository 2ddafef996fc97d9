using System;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>Settings that scripts make, as the Inspector bounds them.</summary>
    sealed class ControlSettingsTests : DesktopScene
    {
        [TestCase(nameof(OrbitView.DegreesPerHeight), 10f, 720f)]
        [TestCase(nameof(OrbitView.ZoomPerNotch), 0.01f, 1f)]
        [TestCase(nameof(OrbitView.DegreesPerSecond), 1f, 360f)]
        [TestCase(nameof(OrbitView.SmoothTime), 0f, 1f)]
        public void OrbitView_TakesWhatTheInspectorDoes(string name, float least, float most) => AssertBounds<OrbitView>(name, least, most);

        [TestCase(nameof(MouseSphere.GrowthPerNotch), 0.01f, 1f)]
        [TestCase(nameof(MouseSphere.HeightsPerSecond), 0.05f, 2f)]
        [TestCase(nameof(MouseSphere.GrowthPerSecond), 0.05f, 5f)]
        public void MouseSphere_TakesWhatTheInspectorDoes(string name, float least, float most) => AssertBounds<MouseSphere>(name, least, most);

        void AssertBounds<T>(string name, float least, float most) where T : MonoBehaviour
        {
            GameObject owner = Make("Camera");
            owner.SetActive(false); // it needs no controls
            owner.AddComponent<Camera>();
            var component = owner.AddComponent<T>();
            System.Reflection.PropertyInfo property = typeof(T).GetProperty(name);
            foreach (float value in new[] { least, most })
            {
                property.SetValue(component, value);
                Assert.That(property.GetValue(component), Is.EqualTo(value));
            }
            foreach (float value in new[] { least - 0.1f, most + 0.1f, float.NaN })
                Assert.That(() => property.SetValue(component, value),
                    Throws.InnerException.TypeOf<ArgumentOutOfRangeException>().And.InnerException.Message.Contain(name));
        }
    }
}
