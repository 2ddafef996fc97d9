using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace AnatomyCarve.Headless.Cli
{
    /// <summary>What readers, carvings and the engine found odd during a command: one line each, kept until no progress bar is in the way.</summary>
    sealed class Warnings
    {
        readonly List<string> lines = [];

        /// <summary>All of them so far.</summary>
        public IReadOnlyList<string> Lines
        {
            get
            {
                lock (lines) return lines.ToArray();
            }
        }

        /// <summary>Keeps a warning, from any thread; the same words are kept once.</summary>
        public void Add(string warning)
        {
            var line = Failure.OneLine(warning);
            lock (lines)
            {
                if (!lines.Contains(line)) lines.Add(line);
            }
        }

        /// <summary>Writes all of them.</summary>
        public void WriteTo(TextWriter error)
        {
            foreach (var line in Lines) error.WriteLine($"warning: {line}");
        }
    }
}
