using System;
using System.IO;
using System.Linq;

namespace UnityEngine.InputSystem
{
    /// <summary>Imports .inputactions files: the asset, and a reference per action.</summary>
    static class InputActionsImporter
    {
        /// <summary>The asset's identifier; the actions' are their ids, exactly as the file writes them.</summary>
        const string Root = "<root>";

        internal static void Import(string path, AssetObjects objects)
        {
            var asset = Load(path);
            objects.Main = asset;
            AssetLibrary.Enter(objects, ImportedFileIds.Of(asset, Root), asset, Path.GetFileNameWithoutExtension(path));
            foreach (var action in asset)
            {
                var reference = InputActionReference.Create(action);
                AssetLibrary.Enter(objects, ImportedFileIds.Of(reference, action.m_Id), reference, InputActionReference.DisplayName(action));
            }
        }

        static InputActionAsset Load(string path)
        {
            InputActionAsset asset;
            try
            {
                asset = InputActionAsset.FromJson(File.ReadAllText(path));
            }
            catch (ArgumentException e)
            {
                throw new AssetFormatException(path, e.Message, e);
            }

            var unnamed = asset.Where(a => string.IsNullOrEmpty(a.m_Id)).Select(a => a.name).ToList();
            if (unnamed.Count == 0)
                return asset;
            Object.DestroyImmediate(asset);
            throw new AssetFormatException(path, $"has actions without an id: {string.Join(", ", unnamed)}");
        }
    }
}
