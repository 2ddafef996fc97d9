using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace UnityEngine.Shaders
{
    /// <summary>
    /// Makes a stage ready for its pipeline: semantics vanish (they are an extension), variables get the locations that fit the neighbour,
    /// resources go to the stage's own descriptor set, and SV_ViewID becomes Vulkan's view index, which glslang's HLSL does not know.
    /// </summary>
    static class StageRewriter
    {
        internal const string ViewSemantic = "SV_VIEWID0";

        const uint DecorationBuiltIn = 11;
        const uint DecorationLocation = 30;
        const uint DecorationDescriptorSet = 34;
        const uint BuiltInViewIndex = 4440;
        const uint CapabilityMultiView = 4439;
        const string SemanticExtension = "SPV_GOOGLE_hlsl_functionality1";
        const string MultiviewExtension = "SPV_KHR_multiview";

        /// <param name="module">As the compiler made it.</param>
        /// <param name="set">The descriptor set.</param>
        /// <param name="locations">Locations by variable.</param>
        /// <param name="view">The variable with the view's index; 0 for none.</param>
        internal static byte[] Rewrite(SpirvModule module, uint set, IReadOnlyDictionary<uint, uint> locations, uint view)
        {
            var output = new List<uint>(module.Words.Length + 16);
            output.AddRange(module.Words.Take(SpirvModule.HeaderLength));
            var first = true;
            foreach (var i in module.Instructions())
            {
                if (first && view != 0)
                    output.AddRange(new[] { (2u << 16) | (uint)SpirvOp.Capability, CapabilityMultiView });
                first = false;
                if (i.Op is SpirvOp.DecorateString or SpirvOp.MemberDecorateString)
                    continue;
                if (i.Op == SpirvOp.Extension && i.Text(1) == SemanticExtension)
                {
                    // In its place, because that is where extensions belong.
                    if (view != 0)
                        output.AddRange(Extension(MultiviewExtension));
                    continue;
                }
                var start = output.Count;
                output.AddRange(new ArraySegment<uint>(module.Words, i.Position, i.Length));
                if (i.Op != SpirvOp.Decorate)
                    continue;
                if (i[2] == DecorationDescriptorSet)
                    output[start + 3] = set;
                else if (i[2] == DecorationLocation && i[1] == view && view != 0)
                    (output[start + 2], output[start + 3]) = (DecorationBuiltIn, BuiltInViewIndex);
                else if (i[2] == DecorationLocation && locations.TryGetValue(i[1], out var location))
                    output[start + 3] = location;
            }
            var bytes = new byte[output.Count * 4];
            Buffer.BlockCopy(output.ToArray(), 0, bytes, 0, bytes.Length);
            return bytes;
        }

        static IEnumerable<uint> Extension(string name)
        {
            var bytes = new byte[(name.Length / 4 + 1) * 4];
            Encoding.ASCII.GetBytes(name, 0, name.Length, bytes, 0);
            var words = new uint[bytes.Length / 4 + 1];
            words[0] = ((uint)words.Length << 16) | (uint)SpirvOp.Extension;
            Buffer.BlockCopy(bytes, 0, words, 4, bytes.Length);
            return words;
        }
    }
}
