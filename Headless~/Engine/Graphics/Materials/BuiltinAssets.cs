using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>
    /// The resources that Unity carries itself and that YAML refers to by two GUIDs of their own: meshes, materials, shaders. Made when they are
    /// first asked for; nobody destroys them.
    /// </summary>
    static class BuiltinAssets
    {
        /// <summary>"Library/unity default resources".</summary>
        internal const string DefaultResources = "0000000000000000e000000000000000";

        /// <summary>"Resources/unity_builtin_extra".</summary>
        internal const string BuiltinExtra = "0000000000000000f000000000000000";

        internal const long Cube = 10202, Cylinder = 10206, Sphere = 10207, Capsule = 10208, Plane = 10209, Quad = 10210;

        internal const long DefaultMaterial = 10303, DefaultLine = 10306, SpritesDefault = 10754;

        static readonly Dictionary<long, Func<Mesh>> s_Meshes = new()
        {
            [Cube] = MeshPrimitives.Cube,
            [Cylinder] = MeshPrimitives.Cylinder,
            [Sphere] = MeshPrimitives.Sphere,
            [Capsule] = MeshPrimitives.Capsule,
            [Plane] = MeshPrimitives.Plane,
            [Quad] = MeshPrimitives.Quad,
        };

        static readonly Dictionary<long, (string Name, string Shader)> s_Materials = new()
        {
            [DefaultMaterial] = ("Default-Material", "Standard"),
            [DefaultLine] = ("Default-Line", "Sprites/Default"),
            [SpritesDefault] = ("Sprites-Default", "Sprites/Default"),
        };

        static readonly Dictionary<long, string> s_Shaders = new()
        {
            [46] = "Standard",
            [10753] = "Sprites/Default",
            [10755] = "Unlit/Color",
            [10752] = "Unlit/Texture",
        };

        static readonly Dictionary<(string Guid, long FileId), Object> s_Loaded = new();

        /// <summary>The resource; null if the host has none of that GUID and ID.</summary>
        internal static Object Load(string guid, long fileId)
        {
            MainThread.Check("BuiltinAssets.Load");
            if (s_Loaded.TryGetValue((guid, fileId), out var known) && known != null)
                return known;
            var made = Create(guid, fileId);
            if (made is null or Shader)
                return made;
            made.IsAsset = true;
            ObjectRegistry.Remove(made);
            s_Loaded[(guid, fileId)] = made;
            return made;
        }

        internal static Mesh Mesh(long fileId) => (Mesh)Load(DefaultResources, fileId);

        internal static Material Material(long fileId) => (Material)Load(BuiltinExtra, fileId);

        internal static void Clear()
        {
            foreach (var asset in s_Loaded.Values)
                asset.Kill();
            s_Loaded.Clear();
        }

        static Object Create(string guid, long fileId)
        {
            if (guid == DefaultResources)
                return s_Meshes.TryGetValue(fileId, out var mesh) ? mesh() : null;
            if (guid != BuiltinExtra)
                return null;
            if (s_Shaders.TryGetValue(fileId, out var shader))
                return Shader.Find(shader);
            return s_Materials.TryGetValue(fileId, out var material) ? new Material(Shader.Find(material.Shader)) { name = material.Name } : null;
        }
    }
}
