using System.IO;
using System.Linq;

namespace UnityEngine
{
    /// <summary>Loads .asset, .prefab and .mat files: what is not in a scene, but referred to.</summary>
    static class YamlAsset
    {
        static readonly string[] s_Extensions = { ".asset", ".prefab", ".mat" };

        internal static bool IsOne(string path) => s_Extensions.Contains(Path.GetExtension(path));

        /// <summary>Adds the file's objects by fileID. They are entered before their fields are read, so that files may refer to each other.</summary>
        /// <exception cref="AssetFormatException">Something in the file is unknown, contradicts itself or leads nowhere.</exception>
        internal static void Load(string path, AssetObjects objects)
        {
            var graph = PrefabExpansion.Read(path);
            if (graph.Items.FirstOrDefault(i => i.Class.IsSettings || i.Class.Id == NativeClass.SceneRoots) is { } settings)
                throw settings.Document.Error(settings.Document.Body, $"{settings.Class.Name} belongs into a scene");
            var builder = new GraphBuilder(graph, objects);
            builder.Construct();
            foreach (var made in objects.Values)
                made.IsAsset = true;
            var roots = builder.Fill();
            var isPrefab = Path.GetExtension(path) == ".prefab";
            if (roots.Count != (isPrefab ? 1 : 0))
                throw new AssetFormatException(path, $"has {roots.Count} GameObjects without a parent; a prefab has one, other assets none");
            objects.Main = isPrefab ? roots[0] : objects.Values.FirstOrDefault();
            Validation.SendToAll(roots);
            foreach (var script in objects.Values.OfType<ScriptableObject>())
            {
                script.SendAwake();
                Validation.Send(script);
            }
        }
    }
}
