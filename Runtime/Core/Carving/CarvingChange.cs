namespace AnatomyCarve.Carving
{
    /// <summary>What an edit of a carving does.</summary>
    public enum CarvingChangeKind
    {
        /// <summary>The active sphere appeared, moved or changed its radius.</summary>
        ActiveSet,

        /// <summary>The active sphere was taken away; its mask stays for the next one.</summary>
        ActiveRemoved,

        /// <summary>The active sphere became the last fixed one, and a smaller active one took its place.</summary>
        ActiveFixed,

        /// <summary>The last fixed sphere was removed.</summary>
        LastRemoved,

        /// <summary>A sphere's mask changed.</summary>
        MaskChanged,

        /// <summary>All spheres were removed.</summary>
        Cleared,

        /// <summary>Another carving took the place of the whole.</summary>
        Replaced,
    }

    /// <summary>Why a change came about.</summary>
    public enum CarvingCause
    {
        /// <summary>The edit was made.</summary>
        Done,

        /// <summary>The edit was taken back.</summary>
        Undone,

        /// <summary>The edit was made again.</summary>
        Redone,
    }

    /// <summary>
    /// One change of a carving as a value: what happened, and the carving before and after it. What follows from a change (which bricks
    /// can look different) is computed from <see cref="BeforeState"/> and <see cref="AfterState"/> alone: see <see cref="DirtyBrickSet"/>.
    /// </summary>
    public readonly struct CarvingChange
    {
        internal CarvingChange(CarvingChangeKind kind, CarvingCause cause, int sphereIndex, CarvingSnapshot before, CarvingSnapshot after, int version)
        {
            Kind = kind;
            Cause = cause;
            SphereIndex = sphereIndex;
            BeforeState = before;
            AfterState = after;
            Version = version;
        }

        /// <summary>The kind of the edit that was done, undone or redone.</summary>
        public CarvingChangeKind Kind { get; }

        /// <summary>Whether the edit was done, undone or redone.</summary>
        public CarvingCause Cause { get; }

        /// <summary>
        /// Index of the edited sphere among the fixed spheres followed by the active one; for <see cref="CarvingChangeKind.ActiveFixed"/> that of the
        /// newly fixed sphere. -1 where the change concerns the whole carving, or a mask that no sphere has yet.
        /// </summary>
        public int SphereIndex { get; }

        /// <summary>The whole carving before the change.</summary>
        public CarvingSnapshot BeforeState { get; }

        /// <summary>The whole carving after the change.</summary>
        public CarvingSnapshot AfterState { get; }

        /// <summary>The stack's version after the change.</summary>
        public int Version { get; }

        /// <summary>The sphere at <see cref="SphereIndex"/> before the change; null where there was none.</summary>
        public ClipSphere Before => SphereOf(BeforeState);

        /// <summary>The sphere at <see cref="SphereIndex"/> after the change; null where there is none.</summary>
        public ClipSphere After => SphereOf(AfterState);

        ClipSphere SphereOf(CarvingSnapshot state) =>
            state != null && SphereIndex >= 0 && SphereIndex < state.Count ? state[SphereIndex] : null;
    }
}
