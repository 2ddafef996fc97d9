using System.Threading;

namespace UnityEngine
{
    /// <summary>The thread that started the engine: most of the API belongs to it alone.</summary>
    static class MainThread
    {
        static Thread s_Thread;

        /// <summary>True on the main thread, and everywhere while no engine runs.</summary>
        internal static bool IsCurrent
        {
            get
            {
                var main = s_Thread;
                return main == null || main == Thread.CurrentThread;
            }
        }

        internal static void Bind() => s_Thread = Thread.CurrentThread;

        internal static void Unbind() => s_Thread = null;

        /// <summary>Throws Unity's exception if this is not the main thread.</summary>
        /// <exception cref="UnityException">Called from another thread.</exception>
        internal static void Check(string api)
        {
            if (IsCurrent)
                return;
            throw new UnityException(api + " can only be called from the main thread.\n" +
                "Constructors and field initializers will be executed from the loading thread when loading a scene.\n" +
                "Don't use this function in the constructor or field initializers, instead move initialization code to the Awake or Start function.");
        }
    }
}
