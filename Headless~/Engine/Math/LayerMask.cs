using System;

namespace UnityEngine
{
    /// <summary>A set of the 32 layers.</summary>
    [Serializable]
    public struct LayerMask
    {
        static readonly string[] s_Names = { "Default", "TransparentFX", "Ignore Raycast", "", "Water", "UI" };

        int m_Mask;

        public int value { get => m_Mask; set => m_Mask = value; }

        /// <summary>The layer's name; empty if it has none.</summary>
        public static string LayerToName(int layer) => layer >= 0 && layer < s_Names.Length ? s_Names[layer] : "";

        /// <summary>The layer of that name; -1 if there is none.</summary>
        public static int NameToLayer(string layerName) => string.IsNullOrEmpty(layerName) ? -1 : Array.IndexOf(s_Names, layerName);

        public static int GetMask(params string[] layerNames)
        {
            if (layerNames == null)
                throw new ArgumentNullException(nameof(layerNames));
            var mask = 0;
            foreach (var name in layerNames)
                if (NameToLayer(name) is var layer and >= 0)
                    mask |= 1 << layer;
            return mask;
        }

        public static implicit operator int(LayerMask mask) => mask.m_Mask;

        public static implicit operator LayerMask(int intVal) => new() { m_Mask = intVal };
    }
}
