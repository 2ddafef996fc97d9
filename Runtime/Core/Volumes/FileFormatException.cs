using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>A file that cannot be read or written: which file, which field, what stands there and what was expected.</summary>
    public abstract class FileFormatException : AnatomyCarveException
    {
        /// <summary>Makes an exception; its message is one sentence of the four parts.</summary>
        /// <param name="file">The file (or what the caller names the stream or text).</param>
        /// <param name="field">The field, or the part of the file.</param>
        /// <param name="foundValue">What was found there.</param>
        /// <param name="expectation">What was expected instead.</param>
        /// <param name="innerException">The cause, or null.</param>
        protected FileFormatException(string file, string field, string foundValue, string expectation, Exception innerException)
            : base($"{file}: {field} is {foundValue}; expected {expectation}.", innerException)
        {
            File = file;
            Field = field;
            FoundValue = foundValue;
            Expectation = expectation;
        }

        /// <summary>The file (or what the caller names the stream or text).</summary>
        public string File { get; }

        /// <summary>The field, or the part of the file.</summary>
        public string Field { get; }

        /// <summary>What was found there.</summary>
        public string FoundValue { get; }

        /// <summary>What was expected instead.</summary>
        public string Expectation { get; }
    }
}
