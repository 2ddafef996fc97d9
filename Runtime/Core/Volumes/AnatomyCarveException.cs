using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>What the package throws when its input can't be used; the message is one clear sentence for the user.</summary>
    public class AnatomyCarveException : Exception
    {
        /// <summary>Makes an exception with a message.</summary>
        public AnatomyCarveException(string message)
            : base(message)
        {
        }

        /// <summary>Makes an exception with a message and its cause.</summary>
        public AnatomyCarveException(string message, Exception innerException)
            : base(message, innerException)
        {
        }
    }
}
