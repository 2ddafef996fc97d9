using System;

namespace UnityEditor.AssetImporters
{
    /// <summary>Base of importers that scripts bring. Their serialised fields are the asset's import settings.</summary>
    public abstract class ScriptedImporter : AssetImporter
    {
        protected ScriptedImporter()
        {
        }

        /// <summary>Makes the asset's objects from the file.</summary>
        public abstract void OnImportAsset(AssetImportContext ctx);

        public virtual bool SupportsRemappedAssetType(Type type) => false;
    }
}
