using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>
    /// What Unity itself brings: the meshes, materials and shaders that the host has too, and names of others: a font, pictures of the user
    /// interface, the sky.
    /// </summary>
    static class BuiltinResources
    {
        const string Default = BuiltinAssets.DefaultResources, Extra = BuiltinAssets.BuiltinExtra;

        static readonly Dictionary<(string, long), string> s_Names = new()
        {
            [(Default, 10001)] = "Soft",
            [(Default, 10102)] = "LegacyRuntime",
            [(Extra, 10304)] = "Default-Skybox",
            [(Extra, 10308)] = "Default-ParticleSystem",
            [(Extra, 10750)] = "Unlit/Transparent",
            [(Extra, 10751)] = "Unlit/Transparent Cutout",
            [(Extra, 10901)] = "Checkmark",
            [(Extra, 10905)] = "UISprite",
            [(Extra, 10907)] = "Background",
            [(Extra, 10911)] = "InputFieldBackground",
            [(Extra, 10913)] = "Knob",
            [(Extra, 10915)] = "DropdownArrow",
            [(Extra, 10917)] = "UIMask",
            [(Extra, 20201)] = "Default-LightingData",
        };

        internal static bool IsBuiltin(string guid) => guid is Default or Extra;

        /// <summary>The resource; null if nothing of that number is known.</summary>
        internal static Object Find(string guid, long fileId) =>
            BuiltinAssets.Load(guid, fileId) ?? (Object)Named(guid, fileId);

        static DataAsset Named(string guid, long fileId) =>
            s_Names.TryGetValue((guid, fileId), out var name) ? DataAsset.Of(name, fileId) : null;
    }
}
