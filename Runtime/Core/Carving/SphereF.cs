namespace AnatomyCarve.Carving
{
    /// <summary>A clip sphere's place as the kernels hold it: centred millimetres (LPS minus the volume's centre) in float.</summary>
    public readonly struct SphereF
    {
        /// <summary>Makes a sphere of its four numbers, in millimetres.</summary>
        public SphereF(float x, float y, float z, float radius)
        {
            X = x;
            Y = y;
            Z = z;
            Radius = radius;
        }

        /// <summary>Centre, L component, centred millimetres.</summary>
        public float X { get; }

        /// <summary>Centre, P component, centred millimetres.</summary>
        public float Y { get; }

        /// <summary>Centre, S component, centred millimetres.</summary>
        public float Z { get; }

        /// <summary>Radius in millimetres; a sphere of radius 0 contains nothing.</summary>
        public float Radius { get; }
    }
}
