using System;

namespace AnatomyCarve.Editor
{
    /// <summary>Why a renderer shows nothing, or not all, as far as its Inspector can tell.</summary>
    struct RendererFacts
    {
        /// <summary>What the device or the pipeline refuses; null = nothing.</summary>
        public string Problem;

        /// <summary>Whether there is a loader, wired or on the same GameObject.</summary>
        public bool HasLoader;

        /// <summary>Whether the loader is told what to load.</summary>
        public bool NamesVolume;

        public bool IsLoading;

        /// <summary>0 to 1.</summary>
        public float Progress;

        public bool HasVolume;

        /// <summary>Whether component and GameObject are enabled.</summary>
        public bool IsEnabled;

        /// <summary>Whether it lies in a prefab or another asset instead of a scene.</summary>
        public bool IsAsset;

        /// <summary>The most important thing to say.</summary>
        public Notice Notice()
        {
            if (!string.IsNullOrEmpty(Problem))
                return new Notice(NoticeKind.Error, Problem);
            if (!HasLoader)
                return new Notice(NoticeKind.Warning, "There is no Volume Loader: add one to this GameObject, or set one below.");
            if (IsAsset)
                return default;
            if (IsLoading && !HasVolume)
                return new Notice(NoticeKind.Info, FormattableString.Invariant($"The volume is being loaded: {100f * Progress:0} %."));
            if (!HasVolume && !NamesVolume)
                return new Notice(NoticeKind.Info, "The Volume Loader has neither an asset nor a file, so there is nothing to show.");
            if (!HasVolume)
                return new Notice(NoticeKind.Info, "No volume is loaded. Press \"Load now\" in the Volume Loader; if that fails, it and the Console say why.");
            if (!IsEnabled)
                return new Notice(NoticeKind.Info, "It is disabled: nothing is drawn, and no GPU memory is held.");
            return default;
        }
    }
}
