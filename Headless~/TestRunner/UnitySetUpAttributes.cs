using System;
using NUnit.Framework;

namespace UnityEngine.TestTools
{
    /// <summary>An IEnumerator method that runs over frames before each test, before [SetUp].</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class UnitySetUpAttribute : NUnitAttribute
    {
    }

    /// <summary>An IEnumerator method that runs over frames after each test, after [TearDown].</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class UnityTearDownAttribute : NUnitAttribute
    {
    }

    /// <summary>Every log of a test must be expected, info and warnings too.</summary>
    [AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Method)]
    public class TestMustExpectAllLogsAttribute : Attribute
    {
        public TestMustExpectAllLogsAttribute(bool mustExpect = true) => MustExpect = mustExpect;

        public bool MustExpect { get; }
    }
}
