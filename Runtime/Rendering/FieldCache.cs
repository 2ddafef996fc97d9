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

        /// <summary>The field as it would be shown now; null where there is no volume.</summary>
        public CarvedField Of(in VolumeInputs inputs)
        {
            KeepOnly(inputs.Volume);
            if (inputs.Volume == null)
                return null;
            field ??= new CarvedField(inputs.Volume);
            field.Update(
                inputs.Carving ?? (IReadOnlyList<ClipSphere>)Array.Empty<ClipSphere>(), inputs.TransferFunction, inputs.Segments,
                inputs.Quality.CutMode, inputs.Quality.AntiAliasSettings);
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
