using System;
using System.IO;
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
        if (m_Host.Report.IsClean)
            return;
        // A failing OneTimeTearDown does not fail `dotnet test`; ending the process does.
        // NUnit keeps Console.Error to itself; the stream beneath reaches the runner.
        using (var error = new StreamWriter(Console.OpenStandardError()))
            error.WriteLine("The host ended with " + m_Host.Report);
        Environment.Exit(1);
    }
}
