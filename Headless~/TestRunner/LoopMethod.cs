using System;
using System.Collections;
using System.Linq;
using System.Reflection;
using System.Threading.Tasks;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace UnityEngine.TestTools
{
    /// <summary>A test method that takes frames: what NUnit calls returns when the player loop has run it to its end.</summary>
    sealed class LoopMethod : IMethodInfo
    {
        /// <summary>The result that NUnit is told to expect of an IEnumerator test; in Unity, too, their cases are written with Returns(null).</summary>
        internal const object Completed = null;

        const int DefaultTimeoutMs = 180000;

        readonly IMethodInfo m_Method;
        readonly int m_TimeoutMs;

        LoopMethod(IMethodInfo method, int timeoutMs)
        {
            m_Method = method;
            m_TimeoutMs = timeoutMs;
        }

        public ITypeInfo TypeInfo => m_Method.TypeInfo;

        public MethodInfo MethodInfo => m_Method.MethodInfo;

        public string Name => m_Method.Name;

        public bool IsAbstract => m_Method.IsAbstract;

        public bool IsPublic => m_Method.IsPublic;

        public bool IsStatic => m_Method.MethodInfo.IsStatic;

        public bool ContainsGenericParameters => m_Method.ContainsGenericParameters;

        public bool IsGenericMethod => m_Method.IsGenericMethod;

        public bool IsGenericMethodDefinition => m_Method.IsGenericMethodDefinition;

        public ITypeInfo ReturnType => m_Method.ReturnType;

        /// <summary>Makes a test run on the loop, if its method is an IEnumerator or a Task.</summary>
        internal static void Install(Test test)
        {
            if (test.Method == null || test.Method is LoopMethod)
                return;
            var result = test.Method.ReturnType.Type;
            if (result != typeof(IEnumerator) && !typeof(Task).IsAssignableFrom(result))
                return;
            var timeout = test.Properties.ContainsKey(PropertyNames.Timeout) ? (int)test.Properties.Get(PropertyNames.Timeout) : DefaultTimeoutMs;
            test.Method = new LoopMethod(test.Method, timeout);
        }

        public object Invoke(object fixture, params object[] args)
        {
            var result = m_Method.Invoke(fixture, args);
            switch (result)
            {
                case IEnumerator routine:
                    TestLoop.Run(routine, m_TimeoutMs);
                    return Completed;
                case Task task:
                    TestLoop.Run(Await(task), m_TimeoutMs);
                    return task;
                default:
                    return result;
            }
        }

        public T[] GetCustomAttributes<T>(bool inherit) where T : class =>
            m_Method.GetCustomAttributes<T>(inherit).Where(a => a is not TimeoutAttribute).ToArray();

        bool IReflectionInfo.IsDefined<T>(bool inherit) => m_Method.IsDefined<T>(inherit);

        public Type[] GetGenericArguments() => m_Method.GetGenericArguments();

        public IParameterInfo[] GetParameters() => m_Method.GetParameters();

        public IMethodInfo MakeGenericMethod(params Type[] typeArguments) => m_Method.MakeGenericMethod(typeArguments);

        static IEnumerator Await(Task task)
        {
            while (!task.IsCompleted)
                yield return null;
        }
    }
}
