using System;
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

        /// <summary>The bytes of one of the package's own textures in the compact layout, as if the whole volume were stored; null where the layout is another.</summary>
        /// <param name="renderer">the only one that has a volume on the GPU</param>
        /// <param name="name">its name: "AnatomyCarve normals", "AnatomyCarve anti-aliased opacity" or "AnatomyCarve opacity"</param>
        public static byte[] ReadPackageTexture(CarvedVolumeRenderer renderer, string name)
        {
            var texture = Resources.FindObjectsOfTypeAll<RenderTexture>().Single(candidate => candidate.name == name);
            if (texture.graphicsFormat is not (GraphicsFormat.R8_UNorm or GraphicsFormat.R8G8_UNorm)) return null;
            var (stored, box, geometry) = (Read<byte>(texture), renderer.Statistics.StoredVoxels.Value, renderer.Volume.Geometry);
            var bytes = stored.Length / (int)box.VoxelCount;
            var row = bytes * (box.MaxI - box.MinI + 1);
            var whole = new byte[bytes * geometry.VoxelCount];
            var next = 0;
            for (var k = box.MinK; k <= box.MaxK; k++)
            {
                for (var j = box.MinJ; j <= box.MaxJ; j++, next += row)
                {
                    Array.Copy(stored, next, whole, bytes * (box.MinI + geometry.SizeI * (j + geometry.SizeJ * k)), row);
                }
            }

            return whole;
        }
    }
}
