using AnatomyCarve.Volumes;

namespace AnatomyCarve
{
    /// <summary>A volume that the device cannot hold was refused; the message says what it needs, what there is, and what would help.</summary>
    public class VolumeTooLargeException : AnatomyCarveException
    {
        /// <summary>Makes an exception with a message.</summary>
        public VolumeTooLargeException(string message)
            : base(message)
        {
        }

        /// <summary>Makes an exception with a message and its cause.</summary>
        public VolumeTooLargeException(string message, System.Exception innerException)
            : base(message, innerException)
        {
        }
    }
}
