using System;

namespace AnatomyCarve
{
    /// <summary>
    /// What the run-time assembly wants of the Editor. It does not know the Editor's assembly, so that one sets what is called here. It is static because
    /// the Editor is one and outlives every scene; a domain that was reloaded has it set again, and where domains are not reloaded the same delegates
    /// stay valid. In players they stay null.
    /// </summary>
    static class EditorLink
    {
        /// <summary>Draws the Editor's views anew; null in players.</summary>
        internal static Action Refresh { get; set; }

        /// <summary>Whether Play is paused; null in players.</summary>
        internal static Func<bool> Paused { get; set; }

        /// <summary>Rises when the Editor imported assets, which keeps objects but may change what they hold; 0 in players.</summary>
        internal static int Imports { get; set; }

        /// <summary>Has the views drawn anew outside Play, where no frame follows by itself. Does nothing in players.</summary>
        internal static void RequestRefresh() => Refresh?.Invoke();

        /// <summary>Whether Play is paused, so that no frame ends in which Unity would destroy objects.</summary>
        internal static bool IsPaused => Paused != null && Paused();
    }
}
