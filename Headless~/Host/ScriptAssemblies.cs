using System;
using System.Collections.Generic;
using System.IO;
using System.Reflection;

namespace AnatomyCarve.Headless
{
    /// <summary>The assemblies that Unity would make of a project's assembly definitions.</summary>
    static class ScriptAssemblies
    {
        /// <summary>
        /// Loads those that this program was built with, so that their scripts, importers and menu entries are found though nobody calls them.
        /// </summary>
        /// <param name="files">Files of the project.</param>
        internal static void Load(IEnumerable<string> files)
        {
            foreach (var file in files)
                if (Path.GetExtension(file) == ".asmdef")
                    TryLoad(Path.GetFileNameWithoutExtension(file));
        }

        static void TryLoad(string name)
        {
            if (!File.Exists(Path.Combine(AppContext.BaseDirectory, name + ".dll")))
                return;
            try
            {
                Assembly.Load(new AssemblyName(name));
            }
            catch (FileNotFoundException)
            {
                // It lies there for another program of the same folder; this one was built without it.
            }
        }
    }
}
