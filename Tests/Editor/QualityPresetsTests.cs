using System.Linq;
using System.Reflection;
using AnatomyCarve.Carving;
using AnatomyCarve.Editor;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Which preset a quality's values are.</summary>
    sealed class QualityPresetsTests
    {
        [Test]
        public void Preset_OfEachName_IsRecognised()
        {
            for (int n = 0; n < RenderQuality.Names.Length; n++)
                Assert.That(QualityPresets.IndexOf(RenderQuality.Named(RenderQuality.Names[n])), Is.EqualTo(n), RenderQuality.Names[n]);
        }

        [Test]
        public void Menu_EndsWithCustom() => Assert.That(QualityPresets.Menu, Is.EqualTo(new[] { "Fast", "Balanced", "Best", "Custom" }));

        [Test]
        public void Quality_ThatDiffersInOneValue_IsCustom()
        {
            RenderQuality[] others =
            {
                new RenderQuality { Step = 0.51f }, new RenderQuality { CutMode = CutMode.Smooth }, new RenderQuality { AntiAliasing = 0.9f },
                new RenderQuality { OpaqueAlpha = 0.9f }, new RenderQuality { FirstVisibleAlpha = 0.4f }, new RenderQuality { Filter = OpacityFilter.Hardware },
            };
            Assert.That(others.Select(QualityPresets.IndexOf), Is.All.EqualTo(QualityPresets.Custom));
        }

        /// <summary>A value that is added to the quality belongs to the presets, the comparison and the Inspector.</summary>
        [Test]
        public void Quality_HasTheValuesThatTheInspectorKnows()
        {
            string[] saved = typeof(RenderQuality).GetFields(BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public)
                .Where(f => f.GetCustomAttribute<SerializeField>() != null).Select(f => f.Name).ToArray();
            Assert.That(saved, Is.EquivalentTo(new[] { "step", "cutMode", "antiAliasing", "opaqueAlpha", "firstVisibleAlpha", "filter" }));
        }
    }
}
