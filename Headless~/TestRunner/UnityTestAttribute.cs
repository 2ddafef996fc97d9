using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;

namespace UnityEngine.TestTools
{
    /// <summary>A test that is an IEnumerator and runs over frames, as a coroutine. Parameters come from [Values] and [ValueSource].</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class UnityTestAttribute : CombiningStrategyAttribute, ISimpleTestBuilder, IImplyFixture, IApplyToTest
    {
        readonly NUnitTestCaseBuilder m_Builder = new();

        public UnityTestAttribute() : base(new EnumeratorCombinations(), new ParameterDataSourceProvider())
        {
        }

        TestMethod ISimpleTestBuilder.BuildFrom(IMethodInfo method, Test suite) => m_Builder.BuildTestMethod(method, suite, EnumeratorCombinations.Plain());

        public new void ApplyToTest(Test test)
        {
            base.ApplyToTest(test);
            if (test.Method != null && test.Method.ReturnType.Type != typeof(IEnumerator))
                test.MakeInvalidBecause("UnityTest methods must return IEnumerator");
        }
    }

    /// <summary>All combinations of the parameters' values. NUnit refuses tests with a result unless one is expected, so one is.</summary>
    sealed class EnumeratorCombinations : ICombiningStrategy
    {
        public IEnumerable<ITestCaseData> GetTestCases(IEnumerable[] sources)
        {
            foreach (var data in new CombinatorialStrategy().GetTestCases(sources))
                yield return sources.Length == 0 ? Plain() : new TestCaseParameters(data.Arguments) { ExpectedResult = LoopMethod.Completed };
        }

        /// <summary>A test without parameters, which is named without parentheses.</summary>
        internal static TestCaseParameters Plain() => new() { ExpectedResult = LoopMethod.Completed };
    }

    static class TestExtensions
    {
        internal static void MakeInvalidBecause(this Test test, string reason)
        {
            test.RunState = RunState.NotRunnable;
            test.Properties.Set(PropertyNames.SkipReason, reason);
        }
    }
}
