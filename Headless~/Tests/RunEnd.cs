using NUnit.Framework;
using UnityEngine.TestTools;

/// <summary>The last word of the run, after the hosts of all folders have ended. Outside of any namespace, so that it spans them all.</summary>
[SetUpFixture]
public sealed class RunEnd
{
    [OneTimeTearDown]
    public void Conclude() => HostEnds.Conclude();
}
