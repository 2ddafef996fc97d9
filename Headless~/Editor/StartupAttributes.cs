using System;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using UnityEngine;

namespace UnityEditor
{
    /// <summary>A class whose static constructor runs when the Editor starts.</summary>
    [AttributeUsage(AttributeTargets.Class)]
    public class InitializeOnLoadAttribute : Attribute
    {
        public InitializeOnLoadAttribute()
        {
        }
    }

    /// <summary>A static method that is called when the Editor starts.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class InitializeOnLoadMethodAttribute : Attribute
    {
        public InitializeOnLoadMethodAttribute()
        {
        }
    }

    /// <summary>What runs when the Editor starts.</summary>
    static class EditorStartup
    {
        const BindingFlags AnyStatic = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

        internal static void Run()
        {
            foreach (var type in ScriptTypes.Assemblies().SelectMany(ScriptTypes.Types).ToList())
            {
                if (type.IsDefined(typeof(InitializeOnLoadAttribute), false))
                    LogRouter.Guard(() => RuntimeHelpers.RunClassConstructor(type.TypeHandle));
                foreach (var method in type.GetMethods(AnyStatic).Where(m => m.IsDefined(typeof(InitializeOnLoadMethodAttribute), false)))
                    LogRouter.Guard(() => method.Invoke(null, BindingFlags.DoNotWrapExceptions, null, null, null));
            }
        }

        /// <summary>To be called when the host ends.</summary>
        internal static void Forget()
        {
            Selection.Forget();
            EditorApplication.Forget();
            EditorUtility.Forget();
            Undo.Forget();
        }
    }
}
