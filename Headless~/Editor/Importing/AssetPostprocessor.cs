using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace UnityEditor
{
    /// <summary>Base of what hears of imports: a static OnPostprocessAllAssets is told of each batch.</summary>
    public class AssetPostprocessor
    {
        public AssetPostprocessor()
        {
        }

        public string assetPath { get; set; } = "";

        public AssetImportContext context { get; internal set; }

        public AssetImporter assetImporter => AssetImporter.GetAtPath(assetPath);

        /// <summary>Lower ones come first.</summary>
        public virtual int GetPostprocessOrder() => 0;

        public virtual uint GetVersion() => 0;
    }

    /// <summary>Tells postprocessors of files that came, changed or went.</summary>
    static class Postprocessors
    {
        const BindingFlags AnyStatic = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

        internal static void Send(IEnumerable<string> imported, IEnumerable<string> deleted)
        {
            var none = Array.Empty<string>();
            object[] arguments = { imported.ToArray(), deleted.ToArray(), none, none };
            var types = ScriptTypes.Assemblies().SelectMany(ScriptTypes.Types).Where(t => typeof(AssetPostprocessor).IsAssignableFrom(t) && !t.IsAbstract);
            foreach (var type in types.OrderBy(t => ((AssetPostprocessor)Activator.CreateInstance(t, true)).GetPostprocessOrder()))
                if (type.GetMethod("OnPostprocessAllAssets", AnyStatic) is { } method)
                    LogRouter.Guard(() => method.Invoke(null, BindingFlags.DoNotWrapExceptions, null, Fitting(method, arguments), null));
        }

        /// <summary>A newer form of the method is also told whether scripts were reloaded.</summary>
        static object[] Fitting(MethodInfo method, object[] arguments) =>
            method.GetParameters().Length == arguments.Length + 1 ? arguments.Append(false).ToArray() : arguments;
    }
}
