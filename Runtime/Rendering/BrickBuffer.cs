using System;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>A list of packed bricks on the GPU, as long as the array that it is filled from, so that edits do not make it anew.</summary>
    sealed class BrickBuffer : IDisposable
    {
        readonly string name;

        public BrickBuffer(string name) => this.name = name;

        /// <summary>The list; null before the first upload.</summary>
        public GraphicsBuffer Buffer { get; private set; }

        public long Bytes => Buffer == null ? 0 : (long)Buffer.count * Buffer.stride;

        /// <summary>Whether the list would be there for a dispatch; a lost device takes it away.</summary>
        public bool IsValid => Buffer != null && Buffer.IsValid();

        public void Upload(uint[] bricks, int count)
        {
            if (Buffer == null || !Buffer.IsValid() || Buffer.count < count)
            {
                Buffer?.Release();
                Buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, Mathf.Max(bricks.Length, 1), sizeof(uint)) { name = name };
            }
            Buffer.SetData(bricks, 0, 0, count);
        }

        public void Dispose()
        {
            Buffer?.Release();
            Buffer = null;
        }
    }
}
