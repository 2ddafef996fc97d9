using System;

namespace UnityEngine
{
    /// <summary>An asset that Unity would load with a missing script, reference or field; here that is an error.</summary>
    sealed class AssetFormatException : Exception
    {
        internal AssetFormatException(string path, string problem, Exception inner = null) : base($"{path}: {problem}", inner) => Path = path;

        internal string Path { get; }
    }
}
