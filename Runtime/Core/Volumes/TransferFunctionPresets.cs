using System;
using System.Collections.Generic;
using System.Linq;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// Transfer functions for common scans by name. Names and points are those of 3D Slicer's volume rendering presets
    /// (Modules/Loadable/VolumeRendering/Resources/presets.xml); CT values are Hounsfield units, MR values depend on the scanner and serve as a start.
    /// </summary>
    public static class TransferFunctionPresets
    {
        static readonly (string name, string points)[] Presets =
        {
            ("CT-AAA", "-3024:0,143.556:0,166.222:0.686275,214.389:0.696078,419.736:0.833333,3071:0.803922"),
            ("CT-Bone", "-3024:0,-16.4458:0,641.385:0.715686,3071:0.705882"),
            ("CT-Chest-Contrast-Enhanced", "-3024:0,67.0106:0,251.105:0.446429,439.291:0.625,3071:0.616071"),
            ("CT-Lung", "-1000:0,-600:0,-599:0.15,-400:0.15,-399:0,2952:0"),
            ("CT-Muscle", "-3024:0,-155.407:0,217.641:0.676471,419.736:0.833333,3071:0.803922"),
            ("CT-Soft-Tissue", "-2048:0,-167.01:0,-160:1,240:1,3661:1"),
            ("CT-Fat", "-1000:0,-100:0,-99:0.15,-60:0.15,-59:0,101.2:0,952:0"),
            ("MR-Default", "0:0,20:0,40:0.15,120:0.3,220:0.375,1024:0.5"),
            ("MR-Angio", "-2048:0,151.354:0,158.279:0.4375,190.112:0.580357,200.873:0.732143,3661:0.741071"),
            ("MR-T2-Brain", "0:0,36.05:0,218.302:0.171429,412.406:1,641:1"),
        };

        /// <summary>The names, in the order of a menu.</summary>
        public static IReadOnlyList<string> Names { get; } = Array.AsReadOnly(Presets.Select(preset => preset.name).ToArray());

        /// <summary>A preset by its name; upper and lower case are the same.</summary>
        /// <exception cref="ArgumentException">No preset has this name.</exception>
        public static OpacityTransferFunction Named(string name)
        {
            foreach ((string known, string points) in Presets)
                if (string.Equals(known, name, StringComparison.OrdinalIgnoreCase))
                    return OpacityTransferFunction.Parse(points);
            throw new ArgumentException($"There is no transfer function '{name}'; the presets are {string.Join(", ", Names)}.", nameof(name));
        }
    }
}
