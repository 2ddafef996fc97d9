namespace AnatomyCarve.Carving
{
    /// <summary>A clip sphere with its place in a volume's centred millimetres and how far it can be felt.</summary>
    readonly struct CentredSphere
    {
        /// <summary>What one holds in memory.</summary>
        public const int Bytes = 32;

        public CentredSphere(SphereF place, SegmentMask mask, double reachMm)
        {
            Place = place;
            Mask = mask;
            ReachMm = reachMm;
        }

        public SphereF Place { get; }

        public SegmentMask Mask { get; }

        /// <summary>Voxel centres farther away than this are not touched.</summary>
        public double ReachMm { get; }
    }
}
