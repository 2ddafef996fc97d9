using System;

namespace Unity.Profiling
{
    /// <summary>A named stretch of work. Headless nothing measures it unless a <see cref="ProfilerSamples"/> listener does.</summary>
    public struct ProfilerMarker
    {
        readonly string m_Name;

        public ProfilerMarker(string name) => m_Name = name;

        public ProfilerMarker(ProfilerCategory category, string name) => m_Name = name;

        public void Begin() => ProfilerSamples.Begin(m_Name);

        public void Begin(UnityEngine.Object contextUnityObject) => ProfilerSamples.Begin(m_Name);

        public void End() => ProfilerSamples.End(m_Name);

        /// <summary>Begins now and ends when the scope is disposed of.</summary>
        public AutoScope Auto() => new(m_Name);

        /// <summary>The stretch between a marker's Auto and the end of its using block.</summary>
        public struct AutoScope : IDisposable
        {
            readonly string m_Name;

            internal AutoScope(string name)
            {
                m_Name = name;
                ProfilerSamples.Begin(name);
            }

            public void Dispose() => ProfilerSamples.End(m_Name);
        }
    }

    /// <summary>Who listens to markers.</summary>
    static class ProfilerSamples
    {
        internal static Action<string, bool> Listener { get; set; }

        internal static void Begin(string name) => Listener?.Invoke(name, true);

        internal static void End(string name) => Listener?.Invoke(name, false);
    }

    /// <summary>The group that a marker belongs to.</summary>
    public struct ProfilerCategory
    {
        readonly string m_Name;

        public ProfilerCategory(string categoryName) => m_Name = categoryName;

        public static ProfilerCategory Render => new("Render");

        public static ProfilerCategory Scripts => new("Scripts");

        public static ProfilerCategory Loading => new("Loading");

        public string Name => m_Name;

        public override string ToString() => m_Name;
    }
}
