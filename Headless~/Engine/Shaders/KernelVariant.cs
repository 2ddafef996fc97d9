using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.Shaders
{
    /// <summary>One kernel with one choice of keywords, compiled when it is first asked for.</summary>
    sealed class KernelVariant
    {
        /// <summary>Direct3D 11's limit, which Unity's cs_5_0 has on every platform.</summary>
        internal const int MaxRandomWriteResources = 8;

        const int MaxGroupThreads = 1024;
        const int MaxGroupZ = 64;

        readonly ComputeSource m_Source;
        readonly KernelPragma m_Kernel;
        readonly IReadOnlyList<string> m_Keywords;
        KernelCode m_Code;
        KernelProgram m_Program;
        bool m_Compiled;

        internal KernelVariant(ComputeSource source, KernelPragma kernel, IReadOnlyList<string> keywords)
        {
            m_Source = source;
            m_Kernel = kernel;
            m_Keywords = keywords;
        }

        /// <summary>Why the variant cannot run; null if it can.</summary>
        internal string Error { get; private set; }

        /// <summary>Null if it does not compile.</summary>
        internal KernelLayout Layout => m_Code?.Layout;

        /// <summary>Whether it was compiled, without an error.</summary>
        internal bool Runs => m_Compiled && Error == null;

        /// <summary>Compiles if need be; logs the error the first time.</summary>
        internal bool Compile()
        {
            if (m_Compiled)
                return Error == null;
            m_Compiled = true;
            try
            {
                var defines = m_Kernel.Defines.Concat(m_Keywords.Select(k => k + "=1")).ToList();
                m_Code = KernelCode.Compile(m_Source, m_Kernel.Name, defines);
                Error = CheckLimits();
            }
            catch (Exception e) when (e is ShaderCompileException or FormatException or NotSupportedException)
            {
                Error = e is ShaderCompileException ? e.Message : $"Shader error in '{m_Source.Path}', kernel {m_Kernel.Name}: {e.Message}";
            }
            if (Error != null)
                Debug.LogError(Error);
            return Error == null;
        }

        /// <summary>The pipeline on the present device.</summary>
        internal KernelProgram Program(GpuContext context)
        {
            if (m_Program == null || m_Program.Context != context)
            {
                m_Program = new KernelProgram(context, m_Code);
                context.Own(m_Program);
            }
            return m_Program;
        }

        string CheckLimits()
        {
            var start = $"Shader error in '{m_Source.Path}', kernel {m_Kernel.Name}: ";
            var threads = (long)Layout.GroupX * Layout.GroupY * Layout.GroupZ;
            if (threads > MaxGroupThreads || Layout.GroupZ > MaxGroupZ)
                return start + $"numthreads({Layout.GroupX},{Layout.GroupY},{Layout.GroupZ}) is more than {MaxGroupThreads} threads or {MaxGroupZ} along z";
            var writes = Layout.Bindings.Count(b => !b.IsCounter && b.Kind is (BindingKind.RandomWriteTexture or BindingKind.RandomWriteBuffer));
            if (writes > MaxRandomWriteResources)
                return start + $"{writes} random-write resources; Direct3D 11 has {MaxRandomWriteResources}";
            foreach (var b in Layout.Bindings)
            {
                // SPIR-V image formats: R32f 3, R32i 24, R32ui 33. Direct3D 11 loads from no other typed UAV (error X3676).
                if (b.Kind == BindingKind.RandomWriteTexture && b.Reads && b.ImageFormat is not (3 or 24 or 33))
                    return start + $"'{b.Name}' is read and written; only a texture of one 32-bit channel can be (error X3676)";
            }
            return null;
        }
    }
}
