using System;
using System.Linq;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace UnityEngine.TestTools
{
    /// <summary>Runs a test on some platforms only.</summary>
    [AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Method, AllowMultiple = true)]
    public class UnityPlatformAttribute : NUnitAttribute, IApplyToTest
    {
        public UnityPlatformAttribute() : this(Array.Empty<RuntimePlatform>())
        {
        }

        public UnityPlatformAttribute(params RuntimePlatform[] include)
        {
            this.include = include;
            exclude = Array.Empty<RuntimePlatform>();
        }

        /// <summary>The platforms to run on; none means all.</summary>
        public RuntimePlatform[] include { get; set; }

        /// <summary>The platforms not to run on.</summary>
        public RuntimePlatform[] exclude { get; set; }

        public void ApplyToTest(Test test)
        {
            if (test.RunState is RunState.NotRunnable or RunState.Ignored)
                return;
            var here = Application.platform;
            if ((include.Length == 0 || include.Contains(here)) && !exclude.Contains(here))
                return;
            test.RunState = RunState.Skipped;
            test.Properties.Set(PropertyNames.SkipReason, $"Not for {here}");
        }
    }
}
