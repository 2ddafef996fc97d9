using System;

namespace UnityEngine.Shaders
{
    /// <summary>A kernel does not compile; the message names kernel, file and line.</summary>
    sealed class ShaderCompileException : Exception
    {
        internal ShaderCompileException(string message) : base(message)
        {
        }

        internal ShaderCompileException(string message, Exception inner) : base(message, inner)
        {
        }
    }
}
