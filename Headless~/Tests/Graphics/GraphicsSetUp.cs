using NUnit.Framework;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>One host under Vulkan's validation layer for the tests of this folder; nothing may be left on the device at the end.</summary>
    [SetUpFixture]
    public sealed class GraphicsSetUp
    {
        internal static UnityHost Host { get; private set; }

        /// <summary>Messages that a test provoked.</summary>
        internal static int ExpectedMessages { get; set; }

        [OneTimeSetUp]
        public void StartHost() => Host = UnityHost.Start(new HostOptions { Validation = true, Log = (_, _, _) => { } });

        [OneTimeTearDown]
        public void EndHost()
        {
            Host.Dispose();
            var report = Host.Report;
            HostEnds.Note("Tests/Graphics", report.LeakCount == 0 && report.ErrorsAtEnd == 0 && report.ValidationMessages == ExpectedMessages, report);
        }
    }
}
