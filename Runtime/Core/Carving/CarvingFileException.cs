using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>A carving file that cannot be read or written.</summary>
    public sealed class CarvingFileException : FileFormatException
    {
        /// <inheritdoc/>
        public CarvingFileException(string file, string field, string foundValue, string expectation, Exception innerException = null)
            : base(file, field, foundValue, expectation, innerException)
        {
        }
    }
}
