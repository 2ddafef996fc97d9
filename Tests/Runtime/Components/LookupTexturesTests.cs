using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>Textures that are made together are released together, when one of them cannot be made too.</summary>
    sealed class LookupTexturesTests : PlayModeScene
    {
        [UnityTest]
        public IEnumerator Textures_WhenOneCannotBeMade_LeaveNoOther()
        {
            int before = CountGpuObjects();
            LogAssert.ignoreFailingMessages = true; // engines log what they cannot make, each in its own words
            Assert.That(() => new LookupTextures(LookupTextures.SegmentsPerRow * (SystemInfo.maxTextureSize + 1)), Throws.Exception);
            yield return null;
            Assert.That(CountGpuObjects(), Is.EqualTo(before));
        }
    }
}
