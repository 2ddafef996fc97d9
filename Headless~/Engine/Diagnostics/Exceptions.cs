using System;
using System.Runtime.Serialization;

namespace UnityEngine
{
    /// <summary>A wrong use of the engine's API.</summary>
    [Serializable]
    public class UnityException : SystemException
    {
        public UnityException() : base("A Unity Runtime error occurred!")
        {
        }

        public UnityException(string message) : base(message)
        {
        }

        public UnityException(string message, Exception innerException) : base(message, innerException)
        {
        }

        protected UnityException(SerializationInfo info, StreamingContext context) : base(info, context)
        {
        }
    }

    /// <summary>A destroyed object was used.</summary>
    [Serializable]
    public class MissingReferenceException : SystemException
    {
        public MissingReferenceException() : base("A Unity Runtime error occurred!")
        {
        }

        public MissingReferenceException(string message) : base(message)
        {
        }

        public MissingReferenceException(string message, Exception innerException) : base(message, innerException)
        {
        }

        protected MissingReferenceException(SerializationInfo info, StreamingContext context) : base(info, context)
        {
        }
    }
}
