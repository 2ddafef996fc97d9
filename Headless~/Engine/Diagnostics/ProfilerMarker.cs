using System;

namespace Unity.Profiling
{
    /// <summary>A named stretch of work, which Unity's Profiler shows. Headless nothing measures it.</summary>
    public struct ProfilerMarker
    {
        public ProfilerMarker(string name)
        {
        }

        public ProfilerMarker(ProfilerCategory category, string name)
        {
        }

        public void Begin()
        {
        }

        public void Begin(UnityEngine.Object contextUnityObject)
        {
        }

        public void End()
        {
        }

        /// <summary>Begins now and ends when the scope is disposed of.</summary>
        public AutoScope Auto() => default;

        /// <summary>The stretch between a marker's Auto and the end of its using block.</summary>
        public struct AutoScope : IDisposable
        {
            public void Dispose()
            {
            }
        }
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
