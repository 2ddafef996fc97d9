using System;
using System.IO;
using System.Security.Cryptography;
using System.Text;
using UnityEngine.Vulkan;

namespace UnityEngine.Shaders
{
    /// <summary>What compilers made, kept on disk between runs under a key of everything that went in.</summary>
    static class CompiledFiles
    {
        // No file that a compiler writes is as short as a module's header.
        const int ShortestContent = 20;

        /// <summary>A file's name without extension: the entry point and a hash of the rest.</summary>
        internal static string Key(string entry, params string[] inputs)
        {
            using var sha = SHA256.Create();
            var hash = sha.ComputeHash(Encoding.UTF8.GetBytes(entry + "\n" + string.Join("\n", inputs)));
            return entry + "-" + BitConverter.ToString(hash, 0, 16).Replace("-", "").ToLowerInvariant();
        }

        internal static bool TryRead(string key, string extension, out byte[] content)
        {
            content = null;
            try
            {
                var path = PathOf(key, extension);
                if (!File.Exists(path))
                    return false;
                content = File.ReadAllBytes(path);
                return content.Length > ShortestContent;
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                return false;
            }
        }

        /// <summary>Writes it, or leaves it where that is not allowed.</summary>
        internal static void Write(string key, string extension, byte[] content) => AtomicFile.TryWrite(PathOf(key, extension), content);

        static string PathOf(string key, string extension) => Path.Combine(GpuOptions.EffectiveCacheFolder, "kernels", key + extension);
    }
}
