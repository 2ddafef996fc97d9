using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>What lies in textures on the GPU.</summary>
    static class Texels
    {
        /// <summary>All texels, slice by slice.</summary>
        public static T[] Read<T>(Texture texture) where T : struct
        {
            var request = AsyncGPUReadback.Request(texture, 0);
            request.WaitForCompletion();
            if (request.hasError) throw new CommandException($"the device cannot read the texture {texture.name} back.");
            var all = new List<T>();
            for (var layer = 0; layer < request.layerCount; layer++) all.AddRange(request.GetData<T>(layer).ToArray());
            return [.. all];
        }

        /// <summary>The bytes of one of the package's own textures in the compact layout; null where it is another.</summary>
        /// <param name="name">its name: "AnatomyCarve normals", "AnatomyCarve anti-aliased opacity" or "AnatomyCarve opacity"</param>
        public static byte[] ReadPackageTexture(string name)
        {
            var texture = Resources.FindObjectsOfTypeAll<RenderTexture>().Single(candidate => candidate.name == name);
            return texture.graphicsFormat is GraphicsFormat.R8_UNorm or GraphicsFormat.R8G8_UNorm ? Read<byte>(texture) : null;
        }
    }
}
