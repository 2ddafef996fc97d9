using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace UnityEngine
{
    /// <summary>Runs the static methods that ask to be called at start.</summary>
    static class StartupMethods
    {
        static readonly RuntimeInitializeLoadType[] s_Order =
        {
            RuntimeInitializeLoadType.SubsystemRegistration, RuntimeInitializeLoadType.AfterAssembliesLoaded, RuntimeInitializeLoadType.BeforeSplashScreen,
            RuntimeInitializeLoadType.BeforeSceneLoad, RuntimeInitializeLoadType.AfterSceneLoad,
        };

        internal static void Run()
        {
            var methods = new List<(RuntimeInitializeLoadType When, MethodInfo Method)>();
            foreach (var type in ScriptTypes.Assemblies().SelectMany(ScriptTypes.Types))
                foreach (var method in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
                    if (method.GetCustomAttribute<RuntimeInitializeOnLoadMethodAttribute>() is { } attribute && method.GetParameters().Length == 0)
                        methods.Add((attribute.loadType, method));
            foreach (var when in s_Order)
                foreach (var (_, method) in methods.Where(m => m.When == when))
                    LogRouter.Guard(() => method.Invoke(null, BindingFlags.DoNotWrapExceptions, null, null, null));
        }
    }
}
