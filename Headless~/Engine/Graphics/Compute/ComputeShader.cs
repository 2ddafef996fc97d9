using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>
    /// The kernels of a .compute file. Values and keywords belong to the shader, textures and buffers to each kernel; all of them stay set,
    /// for every user of the same object.
    /// </summary>
    public sealed partial class ComputeShader : Object
    {
        readonly PropertySheet m_Values = new();
        readonly HashSet<string> m_Keywords = new(StringComparer.Ordinal);
        readonly HashSet<string> m_Warned = new(StringComparer.Ordinal);
        KernelResources[] m_Resources;

        ComputeShader()
        {
        }

        internal ComputeProgram Program { get; private set; }

        /// <summary>Loads a file.</summary>
        /// <exception cref="ShaderCompileException">It cannot be read, or its pragmas make no sense. Kernels are compiled later.</exception>
        internal static ComputeShader Load(string path)
        {
            var shader = Create(new ComputeProgram(ComputeSource.Load(path)));
            shader.NativeName = Path.GetFileNameWithoutExtension(path);
            return shader;
        }

        /// <summary>A copy with values, keywords and bindings of its own.</summary>
        internal ComputeShader Copy()
        {
            var copy = Create(Program);
            copy.NativeName = NativeName;
            m_Values.CopyTo(copy.m_Values);
            copy.m_Keywords.UnionWith(m_Keywords);
            for (var k = 0; k < m_Resources.Length; k++)
                m_Resources[k].CopyTo(copy.m_Resources[k]);
            return copy;
        }

        /// <summary>The number of a kernel.</summary>
        /// <exception cref="ArgumentException">There is no such kernel, or it does not compile.</exception>
        public int FindKernel(string name)
        {
            Use("FindKernel");
            var index = Program.KernelIndex(name);
            if (index < 0 || !Variant(index).Compile())
                throw new ArgumentException($"Kernel '{name}' not found.");
            return index;
        }

        public bool HasKernel(string name)
        {
            Use("HasKernel");
            var index = Program.KernelIndex(name);
            return index >= 0 && Variant(index).Compile();
        }

        /// <summary>Whether the kernel can run here with the keywords as they are.</summary>
        public bool IsSupported(int kernelIndex)
        {
            Use("IsSupported");
            return IsKernel(kernelIndex) && Variant(kernelIndex).Compile();
        }

        /// <exception cref="IndexOutOfRangeException">There is no such kernel, or it does not compile.</exception>
        public void GetKernelThreadGroupSizes(int kernelIndex, out uint x, out uint y, out uint z)
        {
            Use("GetKernelThreadGroupSizes");
            ThrowUnlessValid(kernelIndex);
            var variant = Variant(kernelIndex);
            variant.Compile();
            var layout = variant.Layout
                ?? throw new IndexOutOfRangeException($"Invalid kernelIndex ({kernelIndex}) passed: it does not compile with the present keywords.");
            (x, y, z) = ((uint)layout.GroupX, (uint)layout.GroupY, (uint)layout.GroupZ);
        }

        /// <summary>Runs a kernel on a grid of groups, 1 to 65535 per axis. Errors are logged and nothing runs.</summary>
        public void Dispatch(int kernelIndex, int threadGroupsX, int threadGroupsY, int threadGroupsZ)
        {
            Use("Dispatch");
            if (LogUnless(IsKernel(kernelIndex) && Variant(kernelIndex).Compile(), kernelIndex))
                KernelDispatch.Run(this, kernelIndex, Variant(kernelIndex), threadGroupsX, threadGroupsY, threadGroupsZ);
        }

        public void DispatchIndirect(int kernelIndex, GraphicsBuffer argsBuffer) => DispatchIndirect(kernelIndex, argsBuffer, 0);

        /// <summary>Runs a kernel on a grid whose three sizes the GPU reads from a buffer.</summary>
        /// <exception cref="ArgumentNullException">No buffer.</exception>
        /// <exception cref="ObjectDisposedException">The buffer was released.</exception>
        public void DispatchIndirect(int kernelIndex, GraphicsBuffer argsBuffer, uint argsOffset) =>
            DispatchIndirect(kernelIndex, argsBuffer?.Native, argsOffset);

        public void DispatchIndirect(int kernelIndex, ComputeBuffer argsBuffer) => DispatchIndirect(kernelIndex, argsBuffer, 0);

        public void DispatchIndirect(int kernelIndex, ComputeBuffer argsBuffer, uint argsOffset) =>
            DispatchIndirect(kernelIndex, argsBuffer?.Native, argsOffset);

        internal void DispatchIndirect(int kernelIndex, GpuBuffer argsBuffer, uint argsOffset)
        {
            Use("DispatchIndirect");
            if (argsBuffer == null)
                throw new ArgumentNullException(nameof(argsBuffer));
            if (!argsBuffer.IsAlive)
                throw new ObjectDisposedException(nameof(argsBuffer));
            if (LogUnless(IsKernel(kernelIndex) && Variant(kernelIndex).Compile(), kernelIndex))
                KernelDispatch.RunIndirect(this, kernelIndex, Variant(kernelIndex), argsBuffer, argsOffset);
        }

        internal override Object CloneNative() => Copy();

        internal PropertySheet Values => m_Values;

        internal KernelResources Resources(int kernel) => m_Resources[kernel];

        /// <summary>Logs a warning once per shader, in strict mode only.</summary>
        internal void WarnOnce(string message)
        {
            if (GpuOptions.Strict && m_Warned.Add(message))
                Debug.LogWarning($"Compute shader ({NameForMessages}): {message}");
        }

        static ComputeShader Create(ComputeProgram program)
        {
            var shader = new ComputeShader { Program = program, m_Resources = new KernelResources[program.Source.Kernels.Count] };
            for (var k = 0; k < shader.m_Resources.Length; k++)
                shader.m_Resources[k] = new KernelResources();
            return shader;
        }

        KernelVariant Variant(int kernel) => Program.Variant(kernel, m_Keywords, ShaderGlobals.Keywords);

        bool IsKernel(int index) => index >= 0 && index < m_Resources.Length;

        // A variant is compiled when it runs, not for each choice of keywords on the way there.
        bool IsValid(int kernel) => IsKernel(kernel) && (Program.IsKnownToRun(kernel) || Variant(kernel).Compile());

        void ThrowUnlessValid(int kernelIndex)
        {
            if (!IsValid(kernelIndex))
                throw new IndexOutOfRangeException($"Invalid kernelIndex ({kernelIndex}) passed, must be non-negative less than {m_Resources.Length}.");
        }

        bool LogUnlessValid(int kernelIndex) => LogUnless(IsValid(kernelIndex), kernelIndex);

        bool LogUnless(bool valid, int kernelIndex)
        {
            if (!valid)
                Debug.LogError($"{NameForMessages}.compute: Kernel at index ({kernelIndex}) is invalid");
            return valid;
        }
    }
}
