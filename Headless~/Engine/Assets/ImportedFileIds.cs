using System.Text;

namespace UnityEngine
{
    /// <summary>The fileIDs of what a ScriptedImporter puts into an asset.</summary>
    static class ImportedFileIds
    {
        /// <summary>
        /// The number by which YAML refers to an object: the xxHash64 of its class in Unity and its identifier, such as
        /// "Type:MonoBehaviour->volume0", taken with its sign. The last digit counts objects of the same class and identifier, which are not allowed.
        /// </summary>
        /// <param name="obj">The object; for all scripts the class is MonoBehaviour.</param>
        /// <param name="identifier">What AddObjectToAsset was given.</param>
        internal static long Of(Object obj, string identifier) => Of(ClassName(obj), identifier);

        internal static long Of(string className, string identifier) =>
            unchecked((long)XxHash64.Of(Encoding.UTF8.GetBytes("Type:" + className + "->" + identifier + "0")));

        static string ClassName(Object obj) => obj is ScriptableObject or MonoBehaviour ? "MonoBehaviour" : obj.GetType().Name;
    }
}
