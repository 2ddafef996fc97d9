using NUnit.Framework;
using UnityEngine.TestTools;

[assembly: UnityTestScope]

namespace AnatomyCarve.Headless.Tests.Objects
{
    /// <summary>One host for the tests of this folder.</summary>
    [SetUpFixture]
    public sealed class ObjectsSetUp
    {
        internal static UnityHost Host { get; private set; }

        [OneTimeSetUp]
        public void StartHost() => Host = UnityHost.Start(new HostOptions { Log = (_, _, _) => { } });

        [OneTimeTearDown]
        public void EndHost()
        {
            Host.Dispose();
            HostEnds.Note("Tests/Objects", Host.Report.IsClean, Host.Report);
        }
    }
}
