using System;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Objects
{
    /// <summary>AnimationCurve and Gradient.</summary>
    public sealed class CurveTests
    {
        [Test]
        public void Curve_PassesItsKeys_AndStaysBeyondThem()
        {
            var curve = new AnimationCurve(new Keyframe(1, 5), new Keyframe(0, 2), new Keyframe(3, 1));
            Assert.That(curve.Evaluate(0), Is.EqualTo(2));
            Assert.That(curve.Evaluate(1), Is.EqualTo(5));
            Assert.That(curve.Evaluate(-1), Is.EqualTo(2));
            Assert.That(curve.Evaluate(9), Is.EqualTo(1));
            Assert.That(curve[1].time, Is.EqualTo(1), "in order");
            Assert.That(new AnimationCurve().Evaluate(1), Is.Zero);
        }

        [TestCase(0.25f)]
        [TestCase(0.5f)]
        [TestCase(0.9f)]
        public void Linear_IsALine_AndEaseInOutASmoothStep(float t)
        {
            Assert.That(AnimationCurve.Linear(0, 1, 2, 5).Evaluate(2 * t), Is.EqualTo(1 + 4 * t).Within(1e-5));
            Assert.That(AnimationCurve.EaseInOut(0, 0, 1, 1).Evaluate(t), Is.EqualTo(t * t * (3 - 2 * t)).Within(1e-5));
        }

        [Test]
        public void InfiniteTangent_MakesAStep()
        {
            var curve = new AnimationCurve(new Keyframe(0, 1, 0, float.PositiveInfinity), new Keyframe(1, 2));
            Assert.That(curve.Evaluate(0.99f), Is.EqualTo(1));
            Assert.That(curve.Evaluate(1), Is.EqualTo(2));
        }

        [Test]
        public void Weights_OfAThird_ChangeNothing_OthersDo()
        {
            var plain = new AnimationCurve(new Keyframe(0, 0, 0, 2), new Keyframe(1, 1, 0, 0));
            var third = new AnimationCurve(new Keyframe(0, 0, 0, 2, 0, 1 / 3f), new Keyframe(1, 1, 0, 0, 1 / 3f, 0));
            var heavy = new AnimationCurve(new Keyframe(0, 0, 0, 2, 0, 0.9f), new Keyframe(1, 1, 0, 0, 0.1f, 0));
            Assert.That(third.Evaluate(0.3f), Is.EqualTo(plain.Evaluate(0.3f)).Within(1e-5));
            Assert.That(heavy.Evaluate(0.3f), Is.Not.EqualTo(plain.Evaluate(0.3f)).Within(1e-2));
        }

        [Test]
        public void WrapModes_RepeatTheCurve()
        {
            var curve = AnimationCurve.Linear(0, 0, 1, 1);
            (curve.preWrapMode, curve.postWrapMode) = (WrapMode.Loop, WrapMode.PingPong);
            Assert.That(curve.Evaluate(1.25f), Is.EqualTo(0.75f).Within(1e-5));
            Assert.That(curve.Evaluate(-0.25f), Is.EqualTo(0.75f).Within(1e-5));
        }

        [Test]
        public void Keys_ComeGoAndMove()
        {
            var curve = AnimationCurve.Linear(0, 0, 1, 1);
            Assert.That(curve.AddKey(0.5f, 0.5f), Is.EqualTo(1));
            Assert.That(curve[1].outTangent, Is.EqualTo(1).Within(1e-5), "smooth");
            Assert.That(curve.AddKey(0.5f, 3), Is.EqualTo(-1), "there is one");
            Assert.That(curve.MoveKey(1, new Keyframe(2, 7)), Is.EqualTo(2));
            Assert.That(curve.Evaluate(2), Is.EqualTo(7));
            curve.RemoveKey(0);
            Assert.That(curve.length, Is.EqualTo(2));
            var copy = new AnimationCurve();
            copy.CopyFrom(curve);
            Assert.That(copy, Is.EqualTo(curve));
            curve.ClearKeys();
            Assert.That(copy, Is.Not.EqualTo(curve));
        }

        [Test]
        public void Gradient_BlendsBetweenKeys()
        {
            var gradient = new Gradient();
            Assert.That(gradient.Evaluate(0.3f), Is.EqualTo(Color.white));
            gradient.SetKeys(new[] { new GradientColorKey(Color.blue, 1), new GradientColorKey(Color.red, 0.5f) },
                new[] { new GradientAlphaKey(0, 0), new GradientAlphaKey(1, 1) });
            Assert.That(gradient.Evaluate(0.25f), Is.EqualTo(new Color(1, 0, 0, 0.25f)));
            Assert.That(gradient.Evaluate(0.75f), Is.EqualTo(new Color(0.5f, 0, 0.5f, 0.75f)));
            gradient.mode = GradientMode.Fixed;
            Assert.That(gradient.Evaluate(0.6f), Is.EqualTo(new Color(0, 0, 1, 1)), "the next key's");
        }

        [Test]
        public void PerceptualBlend_KeepsGreys_AndBothEnds()
        {
            var gradient = new Gradient { mode = GradientMode.PerceptualBlend };
            gradient.SetKeys(new[] { new GradientColorKey(Color.black, 0), new GradientColorKey(Color.white, 1) }, new[] { new GradientAlphaKey(1, 0) });
            var middle = gradient.Evaluate(0.5f);
            Assert.That(middle.r, Is.EqualTo(middle.g).Within(1e-3));
            Assert.That(middle.r, Is.EqualTo(Mathf.LinearToGammaSpace(0.125f)).Within(1e-2), "half of the cube root");
            Assert.That(gradient.Evaluate(1).b, Is.EqualTo(1).Within(1e-3));
        }

        [Test]
        public void Gradient_RefusesMoreThanEightKeys() =>
            Assert.That(() => new Gradient { alphaKeys = new GradientAlphaKey[9] }, Throws.TypeOf<ArgumentException>().With.Message.Contains("at most 8"));
    }
}
