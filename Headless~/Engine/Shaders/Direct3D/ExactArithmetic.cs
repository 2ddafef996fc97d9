using System.Collections.Generic;

namespace UnityEngine.Shaders.Direct3D
{
    /// <summary>
    /// Forbids the driver to contract products and sums. FXC has already contracted what the source allows (mad); what bytecode marks as precise must be
    /// rounded as it stands, and vkd3d loses that mark.
    /// </summary>
    static class ExactArithmetic
    {
        const uint NoContraction = 42;

        internal static SpirvModule Of(SpirvModule module)
        {
            var decorations = new List<uint>();
            var types = -1;
            foreach (var i in module.Instructions())
            {
                if (types < 0 && i.Op is SpirvOp.Decorate or (>= SpirvOp.TypeVoid and <= SpirvOp.TypePointer))
                    types = i.Position;
                if (i.Op is SpirvOp.FAdd or SpirvOp.FSub or SpirvOp.FMul)
                    decorations.AddRange(new[] { (3u << 16) | (uint)SpirvOp.Decorate, i[2], NoContraction });
            }
            var words = new List<uint>(module.Words);
            words.InsertRange(types, decorations);
            return new SpirvModule(words.ToArray());
        }
    }
}
