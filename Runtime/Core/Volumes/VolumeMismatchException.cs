namespace AnatomyCarve.Volumes
{
    /// <summary>Two volumes that do not lie on the same grid were put together.</summary>
    public class VolumeMismatchException : AnatomyCarveException
    {
        /// <summary>Makes an exception that says what differs.</summary>
        public VolumeMismatchException(string message)
            : base(message)
        {
        }
    }
}
