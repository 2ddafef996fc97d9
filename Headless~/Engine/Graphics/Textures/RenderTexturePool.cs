using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>Temporary render textures: reused, and destroyed after some frames without use.</summary>
    static class RenderTexturePool
    {
        const int FramesKept = 15;

        static readonly List<(RenderTexture Texture, int Age)> s_Free = new();
        static readonly HashSet<RenderTexture> s_Lent = new();

        internal static RenderTexture Get(in RenderTextureDescriptor desc)
        {
            MainThread.Check("GetTemporary");
            var wanted = desc;
            var index = s_Free.FindIndex(f => f.Texture.descriptor.Equals(wanted));
            RenderTexture texture;
            if (index >= 0)
            {
                texture = s_Free[index].Texture;
                s_Free.RemoveAt(index);
                ObjectRegistry.Add(texture);
                texture.DiscardContents();
            }
            else
            {
                texture = new RenderTexture(desc) { name = $"TempBuffer {s_Lent.Count + s_Free.Count + 1} {desc.width}x{desc.height}" };
                texture.Create();
            }
            s_Lent.Add(texture);
            return texture;
        }

        internal static void Return(RenderTexture texture)
        {
            if (s_Lent.Remove(texture))
            {
                // The pool's own from here on: no leak of a user's.
                ObjectRegistry.Remove(texture);
                s_Free.Add((texture, 0));
            }
            else
            {
                Debug.LogError($"RenderTexture.ReleaseTemporary: '{texture.name}' is not a temporary texture, or was released before.");
            }
        }

        internal static void EndFrame()
        {
            for (var i = s_Free.Count - 1; i >= 0; i--)
            {
                var (texture, age) = s_Free[i];
                if (age < FramesKept)
                {
                    s_Free[i] = (texture, age + 1);
                    continue;
                }
                s_Free.RemoveAt(i);
                Object.DestroyImmediate(texture, true);
            }
        }

        internal static void Clear()
        {
            foreach (var (texture, _) in s_Free)
                Object.DestroyImmediate(texture, true);
            s_Free.Clear();
            s_Lent.Clear();
        }
    }
}
