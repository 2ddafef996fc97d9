using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>Runs menu entries.</summary>
    static class Menus
    {
        const BindingFlags AnyStatic = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

        /// <summary>Chooses an entry, if there is one that can be chosen.</summary>
        /// <param name="path">The entry's path, without short cut.</param>
        /// <param name="context">What it is chosen on; may be null.</param>
        /// <returns>False if there is none, or if it says that it cannot be chosen now.</returns>
        internal static bool Execute(string path, Object context)
        {
            var methods = Find(path).ToList();
            if (methods.Find(m => m.Item.validate).Method is { } validate && !(bool)Call(validate, context))
                return false;
            if (methods.Find(m => !m.Item.validate).Method is not { } method)
                return false;
            return LogRouter.Guard(() => Call(method, context));
        }

        static IEnumerable<(MethodInfo Method, MenuItem Item)> Find(string path) =>
            from type in ScriptTypes.Assemblies().SelectMany(ScriptTypes.Types)
            from method in type.GetMethods(AnyStatic)
            from item in method.GetCustomAttributes<MenuItem>()
            where WithoutShortCut(item.menuItem) == path
            select (method, item);

        static object Call(MethodInfo method, Object context) => method.Invoke(null, BindingFlags.DoNotWrapExceptions, null,
            method.GetParameters().Length == 0 ? null : new object[] { new MenuCommand(context) }, null);

        /// <summary>A short cut is a last word that begins with %, #, &amp; or _.</summary>
        static string WithoutShortCut(string path)
        {
            var space = path.LastIndexOf(' ');
            return space >= 0 && space + 1 < path.Length && "%#&_".IndexOf(path[space + 1]) >= 0 ? path.Substring(0, space) : path;
        }
    }
}
