using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>Makes the objects of .unity files.</summary>
    static class SceneFile
    {
        /// <summary>All objects of the scene, asleep.</summary>
        /// <param name="path">The file.</param>
        /// <param name="applySettings">Puts the scene's own settings into force.</param>
        /// <returns>Its root objects, in order.</returns>
        /// <exception cref="AssetFormatException">Something in the file is unknown, contradicts itself or leads nowhere.</exception>
        internal static List<GameObject> Load(string path, out Action applySettings)
        {
            var objects = new Dictionary<long, Object>();
            try
            {
                var graph = PrefabExpansion.Read(path);
                foreach (var item in graph.Items)
                    if (item.Class.Id == NativeClass.Material || (item.Class.Id == NativeClass.MonoBehaviour && ObjectGraph.Owner(item) == 0))
                        throw item.Document.Error(item.Document.Body, $"a {item.Class.Name} inside a scene is not supported; give it a file of its own");
                var builder = new GraphBuilder(graph, objects);
                builder.Construct();
                applySettings = builder.ApplySettings;
                return builder.Fill();
            }
            catch
            {
                foreach (var half in objects.Values)
                    half.Kill();
                throw;
            }
        }
    }
}
