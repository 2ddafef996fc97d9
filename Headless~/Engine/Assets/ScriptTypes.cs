using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;

namespace UnityEngine
{
    /// <summary>Finds the class that a script file holds, and all assemblies that use the engine.</summary>
    static class ScriptTypes
    {
        static readonly Dictionary<string, Type> s_OfScript = new();

        /// <summary>The class named like the file; of several, the one in the namespace that the file declares.</summary>
        /// <exception cref="AssetFormatException">No loaded assembly has it.</exception>
        internal static Type OfScript(string scriptPath, string referrer)
        {
            if (!s_OfScript.TryGetValue(scriptPath, out var type))
                s_OfScript.Add(scriptPath, type = Search(scriptPath, referrer));
            return type;
        }

        /// <summary>The class of that full name in an assembly that uses the engine; null if there is none.</summary>
        internal static Type Find(string fullName) => Assemblies().Select(a => a.GetType(fullName)).FirstOrDefault(t => t != null);

        /// <summary>To be called when other files may be in the scripts' places.</summary>
        internal static void Forget() => s_OfScript.Clear();

        static Type Search(string scriptPath, string referrer)
        {
            var name = Path.GetFileNameWithoutExtension(scriptPath);
            var candidates = Assemblies().SelectMany(Types).Where(t => t.Name == name && typeof(Object).IsAssignableFrom(t)).ToList();
            if (candidates.Count > 1)
            {
                var space = Regex.Match(File.ReadAllText(scriptPath), @"^\s*namespace\s+([\w.]+)", RegexOptions.Multiline).Groups[1].Value;
                candidates = candidates.FindAll(t => (t.Namespace ?? "") == space);
            }

            if (candidates.Count == 0)
                throw new AssetFormatException(referrer,
                    $"its script {scriptPath} holds no MonoBehaviour or ScriptableObject '{name}' that this program knows");
            return candidates[0];
        }

        /// <summary>Every assembly that is loaded or referred to by a loaded one, and itself refers to the engine.</summary>
        internal static List<Assembly> Assemblies()
        {
            var engine = typeof(Object).Assembly.GetName().Name;
            var seen = new Dictionary<string, Assembly>();
            var pending = new Queue<Assembly>(AppDomain.CurrentDomain.GetAssemblies().Where(a => !a.IsDynamic));
            var users = new List<Assembly>();
            while (pending.Count > 0)
            {
                var assembly = pending.Dequeue();
                if (IsFramework(assembly.GetName().Name) || !seen.TryAdd(assembly.GetName().Name, assembly))
                    continue;
                var references = assembly.GetReferencedAssemblies();
                if (references.Any(r => r.Name == engine))
                    users.Add(assembly);
                foreach (var reference in references)
                    if (!IsFramework(reference.Name) && !seen.ContainsKey(reference.Name) && TryLoad(reference) is { } loaded)
                        pending.Enqueue(loaded);
            }

            return users;
        }

        internal static IEnumerable<Type> Types(Assembly assembly)
        {
            try
            {
                return assembly.GetTypes();
            }
            catch (ReflectionTypeLoadException e)
            {
                return e.Types.Where(t => t != null);
            }
        }

        static bool IsFramework(string name) =>
            name.StartsWith("System", StringComparison.Ordinal) || name.StartsWith("Microsoft.", StringComparison.Ordinal)
                || name is "mscorlib" or "netstandard";

        static Assembly TryLoad(AssemblyName name)
        {
            try
            {
                return Assembly.Load(name);
            }
            catch (Exception e) when (e is FileNotFoundException or FileLoadException or BadImageFormatException)
            {
                return null;
            }
        }
    }
}
