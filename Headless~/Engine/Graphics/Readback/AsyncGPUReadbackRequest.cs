using System;
using Unity.Collections;

namespace UnityEngine.Rendering
{
    /// <summary>A read-back that was asked for. Its data can be read in the frame in which it is done, and no later.</summary>
    public struct AsyncGPUReadbackRequest
    {
        readonly ReadbackOperation m_Operation;

        internal AsyncGPUReadbackRequest(ReadbackOperation operation)
        {
            m_Operation = operation;
            forcePlayerLoopUpdate = false;
        }

        /// <summary>True when the data is there, and on errors too.</summary>
        public bool done => m_Operation is not { State: ReadbackState.Pending };

        /// <summary>True after a failure, and once the data's frame is over.</summary>
        public bool hasError => m_Operation is null or { State: ReadbackState.Failed or ReadbackState.Expired };

        /// <summary>Slices of a volume, pictures of an array; 1 otherwise.</summary>
        public int layerCount => m_Operation?.Layers ?? 0;

        /// <summary>Bytes of a layer, without padding.</summary>
        public int layerDataSize => checked((int)(m_Operation?.LayerBytes ?? 0));

        public int width => m_Operation?.Width ?? 0;

        public int height => m_Operation?.Height ?? 0;

        public int depth => m_Operation?.Layers ?? 0;

        /// <summary>Only the Editor heeds it.</summary>
        public bool forcePlayerLoopUpdate { get; set; }

        /// <summary>Checks whether the data is there; results appear at the start of frames anyway.</summary>
        public void Update()
        {
        }

        /// <summary>Waits until the data is there.</summary>
        public void WaitForCompletion()
        {
            MainThread.Check("WaitForCompletion");
            if (m_Operation is { State: ReadbackState.Pending })
                Gpu.Context.Readbacks.Complete(m_Operation);
        }

        /// <summary>A layer's data: a view that ends with the frame.</summary>
        /// <exception cref="InvalidOperationException">Not done, failed, or the frame is over.</exception>
        /// <exception cref="ArgumentException">There is no such layer.</exception>
        public NativeArray<T> GetData<T>(int layer = 0) where T : struct
        {
            if (!done || hasError)
                throw new InvalidOperationException("Cannot access the data as it is not available");
            if (layer < 0 || layer >= layerCount)
                throw new ArgumentException($"Layer index is out of range {layer} / {layerCount}");
            return m_Operation.Data<T>(layer);
        }
    }
}
