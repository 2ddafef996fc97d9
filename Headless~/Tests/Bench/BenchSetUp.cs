using AnatomyCarve.Headless.Cli;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Commands;
using NUnit.Framework;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Bench
{
    /// <summary>One engine for the measures of this folder, as a benchmark has it.</summary>
    [SetUpFixture]
    public sealed class BenchSetUp
    {
        internal static BenchStage Stage { get; private set; }

        [OneTimeSetUp]
        public void Start() => Stage = new BenchStage(new RenderProject(), new Warnings());

        [OneTimeTearDown]
        public void End()
        {
            var host = Stage.Host;
            Stage.Dispose();
            HostEnds.Note("Tests/Bench", host.Report.LeakCount == 0 && host.Report.ValidationMessages == 0, host.Report);
        }
    }
}
