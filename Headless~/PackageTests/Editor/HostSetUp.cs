using AnatomyCarve.Headless;
using NUnit.Framework;
using UnityEngine.TestTools;

[assembly: UnityTestScope]

/// <summary>Runs the tests of the package's Editor code in edit mode, as Unity runs them.</summary>
[SetUpFixture]
public sealed class HostSetUp
{
    UnityHost m_Host;

    [OneTimeSetUp]
    public void StartHost() => m_Host = UnityHost.Start(new HostOptions { PlayMode = false });

    [OneTimeTearDown]
    public void EndHost()
    {
        m_Host.Dispose();
        HostEnds.Note("the tests of the package's Editor code", m_Host.Report.IsClean, m_Host.Report);
        HostEnds.Conclude();
    }
}
