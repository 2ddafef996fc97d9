using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// A transfer function as the kernels apply it to a volume's stored intensities: a table of <see cref="OpacityTransferFunction.LookupSize"/> opacities,
    /// linear in between, at the place saturate(code * <see cref="Scale"/> + <see cref="Offset"/>) * <see cref="LastEntry"/>. All in float,
    /// each operation rounded by itself.
    /// </summary>
    public sealed class OpacityLookup
    {
        /// <summary>The table's last entry.</summary>
        public const int LastEntry = OpacityTransferFunction.LookupSize - 1;

        readonly float[] table;

        /// <summary>Prepares a transfer function for a volume.</summary>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        public OpacityLookup(OpacityTransferFunction transferFunction, IntensityVolume volume)
        {
            if (transferFunction == null)
                throw new ArgumentNullException(nameof(transferFunction));
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            table = transferFunction.Lookup();
            double range = transferFunction.LookupMax - transferFunction.LookupMin;
            if (range > 0)
            {
                Scale = (float)(volume.CodeScale / range);
                Offset = (float)((volume.CodeOffset - transferFunction.LookupMin) / range);
            }
        }

        /// <summary>The factor for a code of 0 to 65,535; 0 where the function is constant.</summary>
        public float Scale { get; }

        /// <summary>What is added to the scaled code; 0 where the function is constant.</summary>
        public float Offset { get; }

        /// <summary>The opacity, 0 to 1, per reference length, of an intensity code.</summary>
        public float OpacityOf(ushort code)
        {
            float share = (float)((float)(code * Scale) + Offset);
            share = share > 0 ? Math.Min(share, 1f) : 0f;
            float place = (float)(share * LastEntry);
            int entry = Math.Min((int)place, LastEntry - 1);
            float below = table[entry];
            float above = table[entry + 1];
            return (float)(below + (float)((float)(above - below) * (float)(place - entry)));
        }
    }
}
