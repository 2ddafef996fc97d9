using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace UnityEngine.TestTools
{
    /// <summary>Put on an assembly, it runs its tests as Unity's runner does: UnitySetUp and UnityTearDown, IEnumerator and Task tests on the
    /// player loop, unexpected errors in the log as failures. Tests that run while there is no engine are left alone.</summary>
    [AttributeUsage(AttributeTargets.Assembly)]
    sealed class UnityTestScopeAttribute : Attribute, ITestAction
    {
        const int SetUpTimeoutMs = 180000;

        LogScope m_Scope;

        public ActionTargets Targets => ActionTargets.Test;

        public void BeforeTest(ITest test)
        {
            if (!EngineLoop.IsRunning || test.IsSuite)
                return;
            EngineLoop.InstallContext();
            m_Scope?.Dispose();
            m_Scope = new LogScope();
            LoopMethod.Install((Test)test);
            foreach (var method in Methods<UnitySetUpAttribute>(test))
                Run(method);
            m_Scope.Evaluate(false);
        }

        public void AfterTest(ITest test)
        {
            if (m_Scope == null || test.IsSuite)
                return;
            try
            {
                foreach (var method in Methods<UnityTearDownAttribute>(test).Reverse())
                    Run(method);
                EngineLoop.Flush();
                if (MustExpectAllLogs(test))
                    m_Scope.FailOnAnyUnexpected();
                m_Scope.Evaluate(true);
            }
            finally
            {
                m_Scope.Dispose();
                m_Scope = null;
            }
        }

        static void Run(MethodInfo method)
        {
            var fixture = TestExecutionContext.CurrentContext.TestObject;
            TestLoop.Run((IEnumerator)method.Invoke(fixture, BindingFlags.DoNotWrapExceptions, null, null, null), SetUpTimeoutMs);
        }

        /// <summary>Base classes first.</summary>
        static IEnumerable<MethodInfo> Methods<TAttribute>(ITest test) where TAttribute : Attribute
        {
            var types = new Stack<Type>();
            for (var type = TestExecutionContext.CurrentContext.TestObject?.GetType(); type != null; type = type.BaseType)
                types.Push(type);
            return types.SelectMany(t => t.GetMethods(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
                .Where(m => m.IsDefined(typeof(TAttribute), false));
        }

        static bool MustExpectAllLogs(ITest test)
        {
            var method = test.Method?.MethodInfo;
            var attribute = method?.GetCustomAttribute<TestMustExpectAllLogsAttribute>() ??
                method?.DeclaringType?.GetCustomAttribute<TestMustExpectAllLogsAttribute>() ??
                method?.DeclaringType?.Assembly.GetCustomAttribute<TestMustExpectAllLogsAttribute>();
            return attribute is { MustExpect: true };
        }
    }
}
