using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>A carving file that cannot be read or written: which file, which field, what stands there and what was expected.</summary>
    public sealed class CarvingFileException : AnatomyCarveException
    {
        /// <summary>Makes the exception; its message is one sentence of the four parts.</summary>
        /// <param name="file">The file's path, or what stands for it.</param>
        /// <param name="field">The field's path, for instance "spheres[2].radiusMm".</param>
        /// <param name="foundValue">What was found.</param>
        /// <param name="expectation">What was expected.</param>
        /// <param name="innerException">The cause; null where there is none.</param>
        public CarvingFileException(string file, string field, string foundValue, string expectation, Exception innerException = null)
            : base($"{file}: {field} is {foundValue}; expected {expectation}.", innerException)
        {
            File = file;
            Field = field;
            FoundValue = foundValue;
            Expectation = expectation;
        }

        /// <summary>The file's path, or what stands for it.</summary>
        public string File { get; }

        /// <summary>The field's path in the file.</summary>
        public string Field { get; }

        /// <summary>What was found.</summary>
        public string FoundValue { get; }

        /// <summary>What was expected.</summary>
        public string Expectation { get; }
    }
}
