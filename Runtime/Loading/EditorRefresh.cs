using System;

namespace AnatomyCarve
{
    /// <summary>
    /// Has the Editor draw its views anew outside Play, where no frame follows by itself after a volume was loaded. The run-time assembly does not know
    /// the Editor's, so that one sets what is called here. It is static because the Editor is one and outlives every scene; a domain that was reloaded has
    /// it set again, and where domains are not reloaded the same delegate stays valid. In players it stays null.
    /// </summary>
    static class EditorRefresh
    {
        /// <summary>Draws the Editor's views anew; null in players.</summary>
        internal static Action Requested { get; set; }

        /// <summary>Asks for it; does nothing in players.</summary>
        internal static void Request() => Requested?.Invoke();
    }
}
