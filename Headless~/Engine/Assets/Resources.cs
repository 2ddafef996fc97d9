using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>Assets in folders named Resources, by path without extension.</summary>
    public sealed class Resources
    {
        public static Object Load(string path) => Load(path, typeof(Object));

        /// <summary>Null if there is none of that type.</summary>
        public static T Load<T>(string path) where T : Object => (T)Load(path, typeof(T));

        public static Object Load(string path, Type systemTypeInstance) => LoadAll(path, systemTypeInstance).FirstOrDefault();

        public static T[] LoadAll<T>(string path) where T : Object => LoadAll(path, typeof(T)).Cast<T>().ToArray();

        /// <summary>All objects of the files at that path.</summary>
        public static Object[] LoadAll(string path, Type systemTypeInstance)
        {
            MainThread.Check("Load");
            if (path == null)
                throw new ArgumentNullException(nameof(path));
            var found = new List<Object>();
            foreach (var file in AssetLibrary.Resources(path))
                found.AddRange(AssetLibrary.LoadFile(file).Values.Where(systemTypeInstance.IsInstanceOfType));
            return found.ToArray();
        }

        /// <summary>All living objects of a type, assets too.</summary>
        public static T[] FindObjectsOfTypeAll<T>() where T : Object
        {
            MainThread.Check("FindObjectsOfTypeAll");
            return ObjectRegistry.Snapshot().OfType<T>().ToArray();
        }

        public static Object[] FindObjectsOfTypeAll(Type type)
        {
            MainThread.Check("FindObjectsOfTypeAll");
            return ObjectRegistry.Snapshot().Where(type.IsInstanceOfType).ToArray();
        }

        /// <summary>Lets go of an asset; the next Load reads it again.</summary>
        public static void UnloadAsset(Object assetToUnload)
        {
            MainThread.Check("UnloadAsset");
            if (!Object.IsAlive(assetToUnload))
                return;
            if (assetToUnload is GameObject or Component)
                Debug.LogError("UnloadAsset may only be used on individual assets and can not be used on GameObject's / Components / AssetBundles or "
                    + "GameManagers");
            else if (assetToUnload.IsAsset)
                Destruction.Now(assetToUnload);
        }
    }
}
