using NUnit.Framework;
using UnityEngine;

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
            var messages = Gpu.Context.Messages;
            Host.Dispose();
            Assert.That(messages.Count, Is.EqualTo(ExpectedMessages), "messages of the validation layer");
            Assert.That(Host.Report.LeakCount, Is.Zero, Host.Report.ToString());
        }
    }
}
