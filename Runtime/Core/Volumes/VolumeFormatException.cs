using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>A volume's file that can't be read.</summary>
    public class VolumeFormatException : FileFormatException
    {
        /// <inheritdoc/>
        public VolumeFormatException(string file, string field, string foundValue, string expectation, Exception innerException = null)
            : base(file, field, foundValue, expectation, innerException)
        {
        }
    }
}
