using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace UnityEngine.Shaders.Direct3D
{
    /// <summary>Gives the resources of vkd3d's SPIR-V, which bear the names of registers, the source's names, strides and members.</summary>
    static class RegisterNames
    {
        // cb0_0 is constant buffer 0 (of space 0); u0_counter the counter of the append, consume or counter buffer u0.
        static readonly Regex s_Register = new(@"^(?<register>(cb|s|t|u)\d+)(_\d+)?(?<counter>_counter)?$", RegexOptions.Compiled);

        /// <exception cref="NotSupportedException">The kernel has a resource of a kind that this host does not have.</exception>
        internal static KernelLayout Resolve(KernelLayout registers, IReadOnlyList<DxbcResource> resources)
        {
            foreach (var resource in resources)
                Check(resource);
            var byRegister = resources.ToDictionary(r => r.RegisterName);
            foreach (var binding in registers.Bindings)
            {
                var match = s_Register.Match(binding.Variable);
                if (!match.Success || !byRegister.TryGetValue(match.Groups["register"].Value, out var resource))
                    throw new NotSupportedException($"vkd3d made a resource '{binding.Variable}' that FXC's table does not have.");
                Name(binding, resource, match.Groups["counter"].Success);
            }
            return registers;
        }

        static void Check(DxbcResource resource)
        {
            // Of an array that is not indexed by a variable, FXC makes resources "name[0]" and so on.
            if (resource.Count != 1 || resource.Name.Contains('['))
                throw new NotSupportedException($"'{resource.Name}' is an array of resources, which kernels cannot have here.");
            if (resource.Kind == DxbcKind.TextureBuffer)
                throw new NotSupportedException($"'{resource.Name}' is a tbuffer; use a cbuffer or a StructuredBuffer.");
            if (resource.IsTypedBuffer)
                throw new NotSupportedException(SpirvReflection.TypedBuffer(resource.Name));
        }

        static void Name(KernelBinding binding, DxbcResource resource, bool isCounter)
        {
            binding.Name = resource.Name;
            binding.NameId = Shader.PropertyToID(resource.Name);
            binding.IsCounter = isCounter;
            binding.Stride = isCounter ? 4 : resource.Stride;
            binding.Size = resource.Size;
            binding.Members = resource.Members;
        }
    }
}
