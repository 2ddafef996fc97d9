using System;

namespace UnityEngine
{
    /// <summary>The rules of SetConstantBuffer.</summary>
    static class ConstantBuffers
    {
        const int Row = 16;

        internal static ConstantBufferValue Checked(GpuBuffer buffer, int offset, int size)
        {
            if (buffer == null)
                throw new ArgumentNullException(nameof(buffer));
            if ((buffer.Target & GraphicsBuffer.Target.Constant) == 0)
                throw new ArgumentException("The buffer was not made with the target Constant", nameof(buffer));
            if (offset < 0 || offset % SystemInfo.constantBufferOffsetAlignment != 0)
                throw new ArgumentException($"The offset {offset} is not a multiple of {SystemInfo.constantBufferOffsetAlignment} bytes", nameof(offset));
            if (size <= 0 || size % Row != 0 || offset + (long)size > buffer.Size || size > SystemInfo.maxConstantBufferSize)
                throw new ArgumentException($"The size {size} is not a multiple of {Row} bytes inside the buffer", nameof(size));
            return new ConstantBufferValue(buffer, offset, size);
        }
    }
}
