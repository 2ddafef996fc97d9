using System;

namespace UnityEngine
{
    public sealed partial class GraphicsBuffer
    {
        /// <summary>What a buffer is used for.</summary>
        [Flags]
        public enum Target
        {
            Vertex = 1,
            Index = 2,
            CopySource = 4,
            CopyDestination = 8,
            Structured = 16,
            Raw = 32,
            Append = 64,
            Counter = 128,
            IndirectArguments = 256,
            Constant = 512,
        }

        /// <summary>How the CPU writes a buffer.</summary>
        [Flags]
        public enum UsageFlags
        {
            None = 0,
            LockBufferForWrite = 1,
        }
    }
}
