using System;
using System.IO;
using System.Linq;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Core.Tests.Volumes
{
    public class TransferFunctionPresetsTests
    {
        [Test]
        public void Names_AreDifferent_AndEachNamesAFunction()
        {
            Assert.That(TransferFunctionPresets.Names, Is.Unique.And.Contains("CT-Bone").And.Contains("MR-Default"));
            foreach (string name in TransferFunctionPresets.Names)
                Assert.That(TransferFunctionPresets.Named(name).Points.Max(p => p.Opacity), Is.GreaterThan(0), name);
        }

        [Test]
        public void Named_InAnyCase_IsTheSame() =>
            Assert.That(TransferFunctionPresets.Named("ct-bone").ToString(), Is.EqualTo(TransferFunctionPresets.Named("CT-Bone").ToString()));

        [Test]
        public void Named_Unknown_IsRefusedWithTheKnownNames() =>
            Assert.That(() => TransferFunctionPresets.Named("CT-Teeth"), Throws.ArgumentException.With.Message.Contains("CT-Teeth").And.Message.Contains("CT-Bone"));

        [Test]
        public void Bone_IsTransparentInSoftTissueAndOpaqueInBone()
        {
            OpacityTransferFunction bone = TransferFunctionPresets.Named("CT-Bone");
            Assert.That(bone.OpacityAt(-100), Is.EqualTo(0).Within(1e-6));
            Assert.That(bone.OpacityAt(700), Is.EqualTo(0.7155).Within(1e-3));
        }

        [Test]
        public void Points_AreThoseOf3DSlicer()
        {
            string path = SharedData.PathOf("tables/slicer_presets.json");
            JToken[] presets = JArray.Parse(File.ReadAllText(path)).ToArray();
            int compared = 0;
            foreach (string name in TransferFunctionPresets.Names)
            {
                JToken theirs = presets.SingleOrDefault(p => string.Equals((string)p["name"], name, StringComparison.Ordinal));
                if (theirs == null)
                    continue;
                compared++;
                double[] values = theirs["scalar_opacity"].SelectMany(p => new[] { (double)p[0], (double)p[1] }).ToArray();
                double[] ours = TransferFunctionPresets.Named(name).Points.SelectMany(p => new[] { p.Value, p.Opacity }).ToArray();
                Assert.That(ours, Is.EqualTo(values).Within(1e-6), name);
            }
            Assert.That(compared, Is.GreaterThanOrEqualTo(8));
        }
    }
}
