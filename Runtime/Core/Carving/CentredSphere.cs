namespace AnatomyCarve.Carving
{
    /// <summary>A clip sphere's place in a volume's centred millimetres, and its mask.</summary>
    readonly struct CentredSphere
    {
        /// <summary>What one holds in memory.</summary>
        public const int Bytes = 24;

        public CentredSphere(SphereF place, SegmentMask mask)
        {
            Place = place;
            Mask = mask;
        }

        public SphereF Place { get; }

        public SegmentMask Mask { get; }
    }
}
