using System;
using System.IO;

namespace UnityEngine.Vulkan
{
    /// <summary>Files of a cache: either whole or not there, whoever writes at the same time.</summary>
    static class AtomicFile
    {
        /// <summary>Writes beside the file and moves it into place. False if the folder cannot be written.</summary>
        internal static bool TryWrite(string path, byte[] content)
        {
            try
            {
                Directory.CreateDirectory(Path.GetDirectoryName(path));
                var temporary = path + "." + Guid.NewGuid().ToString("N") + ".tmp";
                File.WriteAllBytes(temporary, content);
                try
                {
                    if (File.Exists(path))
                        File.Replace(temporary, path, null);
                    else
                        File.Move(temporary, path);
                }
                catch (IOException)
                {
                    // Another process was faster with the same content.
                    File.Delete(temporary);
                }
                return true;
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                return false;
            }
        }
    }
}
