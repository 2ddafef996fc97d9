using AnatomyCarve.Headless;
using NUnit.Framework;
using UnityEngine.TestTools;

[assembly: UnityTestScope]

/// <summary>Runs the package's tests in one host, as Unity runs them in one player.</summary>
[SetUpFixture]
public sealed class HostSetUp
{
    UnityHost m_Host;

    [OneTimeSetUp]
    public void StartHost() => m_Host = UnityHost.Start();

    [OneTimeTearDown]
    public void EndHost()
    {
        m_Host.Dispose();
        HostEnds.Note("the package's tests", m_Host.Report.IsClean, m_Host.Report);
        HostEnds.Conclude();
    }
}
