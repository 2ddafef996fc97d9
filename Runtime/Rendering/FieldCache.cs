using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve
{
    /// <summary>The carved field on the CPU of the volume that is shown.</summary>
    sealed class FieldCache
    {
        CarvedField field;

        public CarvedField Of(
            SegmentedVolume volume, CarvingSnapshot carving, OpacityTransferFunction transferFunction, SegmentTable segments, CutMode cut,
            AntiAliasSettings antiAliasing)
        {
            if (field == null || field.Volume != volume)
                field = new CarvedField(volume);
            field.Update(carving ?? (IReadOnlyList<ClipSphere>)Array.Empty<ClipSphere>(), transferFunction, segments, cut, antiAliasing);
            return field;
        }

        /// <summary>Lets go of every other volume.</summary>
        public void KeepOnly(SegmentedVolume volume)
        {
            if (field != null && field.Volume != volume)
                field = null;
        }
    }
}
