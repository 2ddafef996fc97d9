using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Editor
{
    /// <summary>What a transfer function is called in menus: a preset's name if it is one, also after a scene saved it.</summary>
    static class TransferFunctionNames
    {
        public const string Automatic = "Automatic";
        public const string Custom = "Custom";

        /// <param name="function">The function that the user chose or drew; null = chosen from the intensities.</param>
        public static string Of(OpacityTransferFunction function)
        {
            if (function == null)
                return Automatic;
            foreach (string name in TransferFunctionPresets.Names)
                if (Same(TransferFunctionPresets.Named(name).Points, function.Points))
                    return name;
            return Custom;
        }

        /// <summary>Scenes hold floats.</summary>
        static bool Same(IReadOnlyList<TransferPoint> a, IReadOnlyList<TransferPoint> b)
        {
            if (a.Count != b.Count)
                return false;
            for (int p = 0; p < a.Count; p++)
                if ((float)a[p].Value != (float)b[p].Value || (float)a[p].Opacity != (float)b[p].Opacity)
                    return false;
            return true;
        }
    }
}
