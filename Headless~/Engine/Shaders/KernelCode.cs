using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Shaders.Direct3D;

namespace UnityEngine.Shaders
{
    /// <summary>Through which compilers kernels go.</summary>
    enum KernelRoute
    {
        /// <summary>glslang's HLSL front end.</summary>
        Glslang = 0,

        /// <summary>Microsoft's FXC, whose bytecode is what Unity begins with on every platform, and vkd3d.</summary>
        Fxc = 1,
    }

    /// <summary>A kernel as the device takes it, whichever way it went.</summary>
    sealed class KernelCode
    {
        internal KernelCode(SpirvModule module, string entry, KernelLayout layout)
        {
            Spirv = module.ToBytes();
            Entry = entry;
            Layout = layout;
        }

        internal byte[] Spirv { get; }

        /// <summary>What the code calls the kernel.</summary>
        internal string Entry { get; }

        /// <summary>Its resources under the source's names.</summary>
        internal KernelLayout Layout { get; }

        /// <summary>Compiles a kernel by the route that the host chose.</summary>
        /// <exception cref="ShaderCompileException">An error in the source; or no compiler.</exception>
        /// <exception cref="NotSupportedException">It uses what this host does not have.</exception>
        internal static KernelCode Compile(ComputeSource source, string kernel, IReadOnlyList<string> defines) =>
            GpuOptions.KernelRoute == KernelRoute.Fxc ? FxcRoute.Compile(source, kernel, defines) : ByGlslang(source, kernel, defines);

        static KernelCode ByGlslang(ComputeSource source, string kernel, IReadOnlyList<string> defines)
        {
            var spirv = HlslCompiler.Compile(HlslJob.OfKernel(source, kernel, "SHADER_API_VULKAN", defines));
            var module = SpirvRewriter.WithoutFormats(SpirvModule.Parse(spirv));
            var layout = SpirvReflection.Reflect(module);
            if (layout.Bindings.FirstOrDefault(b => b.Kind == BindingKind.TexelBuffer) is { } buffer)
                throw new NotSupportedException(SpirvReflection.TypedBuffer(buffer.Name));
            return new KernelCode(module, kernel, layout);
        }
    }
}
