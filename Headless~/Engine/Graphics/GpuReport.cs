using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>What was still alive on the device when it ended.</summary>
    sealed class GpuReport
    {
        internal GpuReport(IReadOnlyList<string> leaks = null) => Leaks = leaks ?? new List<string>();

        /// <summary>One line per texture or buffer that nobody released: kind, name, size.</summary>
        internal IReadOnlyList<string> Leaks { get; }

        public override string ToString() =>
            Leaks.Count == 0 ? "no GPU resources leaked" : $"{Leaks.Count} GPU resources leaked:\n  " + string.Join("\n  ", Leaks.Take(50));
    }
}
