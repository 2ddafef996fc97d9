using System.Collections.Generic;

namespace AnatomyCarve.Headless
{
    /// <summary>What was left when a host ended.</summary>
    public sealed class HostReport
    {
        internal HostReport(IReadOnlyList<string> objects, IReadOnlyList<string> gpuResources, int nativeArrays, int errors, int validationMessages)
        {
            LeakedObjects = objects;
            LeakedGpuResources = gpuResources;
            LeakedNativeArrays = nativeArrays;
            ErrorsAtEnd = errors;
            ValidationMessages = validationMessages;
        }

        /// <summary>Objects that do not end with the scene and that nobody destroyed, one line each: textures, ScriptableObjects, copies of kernels.</summary>
        public IReadOnlyList<string> LeakedObjects { get; }

        /// <summary>Textures and buffers on the device that nobody released, one line each.</summary>
        public IReadOnlyList<string> LeakedGpuResources { get; }

        /// <summary>NativeArrays (Persistent, TempJob) that nobody disposed of.</summary>
        public int LeakedNativeArrays { get; }

        /// <summary>Errors logged while the host ended, the last words of Vulkan's validation among them.</summary>
        public int ErrorsAtEnd { get; }

        /// <summary>What Vulkan's validation layer said from start to end.</summary>
        public int ValidationMessages { get; }

        /// <summary>No leaks, no errors at the end, no word from the validation layer.</summary>
        public bool IsClean => LeakCount == 0 && ErrorsAtEnd == 0 && ValidationMessages == 0;

        /// <summary>All leaks together.</summary>
        public int LeakCount => LeakedObjects.Count + LeakedGpuResources.Count + LeakedNativeArrays;

        /// <inheritdoc/>
        public override string ToString() => $"{LeakCount} leaks, {ErrorsAtEnd} errors at the end, {ValidationMessages} validation messages" +
            string.Concat(System.Linq.Enumerable.Select(System.Linq.Enumerable.Concat(LeakedObjects, LeakedGpuResources), l => "\n  " + l)) +
            (LeakedNativeArrays > 0 ? $"\n  {LeakedNativeArrays} NativeArrays" : "");
    }
}
