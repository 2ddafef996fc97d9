using System;

namespace UnityEngine.Rendering
{
    public partial class CommandBuffer
    {
        public void SetComputeFloatParam(ComputeShader computeShader, string name, float val) =>
            SetComputeFloatParam(computeShader, Shader.PropertyToID(name), val);

        public void SetComputeFloatParam(ComputeShader computeShader, int nameID, float val) => Record(computeShader, s => s.SetFloat(nameID, val));

        public void SetComputeIntParam(ComputeShader computeShader, string name, int val) => SetComputeIntParam(computeShader, Shader.PropertyToID(name), val);

        public void SetComputeIntParam(ComputeShader computeShader, int nameID, int val) => Record(computeShader, s => s.SetInt(nameID, val));

        public void SetComputeVectorParam(ComputeShader computeShader, string name, Vector4 val) =>
            SetComputeVectorParam(computeShader, Shader.PropertyToID(name), val);

        public void SetComputeVectorParam(ComputeShader computeShader, int nameID, Vector4 val) => Record(computeShader, s => s.SetVector(nameID, val));

        public void SetComputeVectorArrayParam(ComputeShader computeShader, string name, Vector4[] values) =>
            SetComputeVectorArrayParam(computeShader, Shader.PropertyToID(name), values);

        public void SetComputeVectorArrayParam(ComputeShader computeShader, int nameID, Vector4[] values)
        {
            var copy = Copy(values);
            Record(computeShader, s => s.SetVectorArray(nameID, copy));
        }

        public void SetComputeMatrixParam(ComputeShader computeShader, string name, Matrix4x4 val) =>
            SetComputeMatrixParam(computeShader, Shader.PropertyToID(name), val);

        public void SetComputeMatrixParam(ComputeShader computeShader, int nameID, Matrix4x4 val) => Record(computeShader, s => s.SetMatrix(nameID, val));

        public void SetComputeMatrixArrayParam(ComputeShader computeShader, string name, Matrix4x4[] values) =>
            SetComputeMatrixArrayParam(computeShader, Shader.PropertyToID(name), values);

        public void SetComputeMatrixArrayParam(ComputeShader computeShader, int nameID, Matrix4x4[] values)
        {
            var copy = Copy(values);
            Record(computeShader, s => s.SetMatrixArray(nameID, copy));
        }

        public void SetComputeFloatParams(ComputeShader computeShader, string name, params float[] values) =>
            SetComputeFloatParams(computeShader, Shader.PropertyToID(name), values);

        public void SetComputeFloatParams(ComputeShader computeShader, int nameID, params float[] values)
        {
            var copy = Copy(values);
            Record(computeShader, s => s.SetFloats(nameID, copy));
        }

        public void SetComputeIntParams(ComputeShader computeShader, string name, params int[] values) =>
            SetComputeIntParams(computeShader, Shader.PropertyToID(name), values);

        public void SetComputeIntParams(ComputeShader computeShader, int nameID, params int[] values)
        {
            var copy = Copy(values);
            Record(computeShader, s => s.SetInts(nameID, copy));
        }

        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, string name, RenderTargetIdentifier rt) =>
            SetComputeTextureParam(computeShader, kernelIndex, Shader.PropertyToID(name), rt, 0);

        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt) =>
            SetComputeTextureParam(computeShader, kernelIndex, nameID, rt, 0);

        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, string name, RenderTargetIdentifier rt, int mipLevel) =>
            SetComputeTextureParam(computeShader, kernelIndex, Shader.PropertyToID(name), rt, mipLevel);

        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt, int mipLevel) =>
            Record(computeShader, s => s.SetTexture(kernelIndex, nameID, Existing(rt), mipLevel));

        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, string name, GraphicsBuffer buffer) =>
            SetComputeBufferParam(computeShader, kernelIndex, Shader.PropertyToID(name), buffer);

        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID, GraphicsBuffer buffer) =>
            Record(computeShader, s => s.SetBuffer(kernelIndex, nameID, buffer));

        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, string name, ComputeBuffer buffer) =>
            SetComputeBufferParam(computeShader, kernelIndex, Shader.PropertyToID(name), buffer);

        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID, ComputeBuffer buffer) =>
            Record(computeShader, s => s.SetBuffer(kernelIndex, nameID, buffer));

        public void SetComputeConstantBufferParam(ComputeShader computeShader, string name, GraphicsBuffer buffer, int offset, int size) =>
            SetComputeConstantBufferParam(computeShader, Shader.PropertyToID(name), buffer, offset, size);

        public void SetComputeConstantBufferParam(ComputeShader computeShader, int nameID, GraphicsBuffer buffer, int offset, int size) =>
            Record(computeShader, s => s.SetConstantBuffer(nameID, buffer, offset, size));

        public void EnableKeyword(ComputeShader computeShader, in LocalKeyword keyword) => SetKeyword(computeShader, keyword, true);

        public void DisableKeyword(ComputeShader computeShader, in LocalKeyword keyword) => SetKeyword(computeShader, keyword, false);

        public void SetKeyword(ComputeShader computeShader, in LocalKeyword keyword, bool value)
        {
            var copy = keyword;
            Record(computeShader, s => s.SetKeyword(copy, value));
        }

        /// <summary>Records a dispatch; it is checked when it runs.</summary>
        public void DispatchCompute(ComputeShader computeShader, int kernelIndex, int threadGroupsX, int threadGroupsY, int threadGroupsZ) =>
            Record(computeShader, s => s.Dispatch(kernelIndex, threadGroupsX, threadGroupsY, threadGroupsZ));

        public void DispatchCompute(ComputeShader computeShader, int kernelIndex, GraphicsBuffer indirectBuffer, uint argsOffset) =>
            Record(computeShader, s => s.DispatchIndirect(kernelIndex, indirectBuffer, argsOffset));

        public void DispatchCompute(ComputeShader computeShader, int kernelIndex, ComputeBuffer indirectBuffer, uint argsOffset) =>
            Record(computeShader, s => s.DispatchIndirect(kernelIndex, indirectBuffer, argsOffset));

        static T[] Copy<T>(T[] values) => (T[])(values ?? throw new ArgumentNullException(nameof(values))).Clone();

        void Record(ComputeShader shader, Action<ComputeShader> command)
        {
            if (shader == null)
                throw new ArgumentNullException(nameof(shader));
            Record(() => command(shader));
        }
    }
}
