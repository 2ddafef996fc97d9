namespace AnatomyCarve.Headless.Cli.Bench.Error.Reference
{
    /// <summary>A linear colour, premultiplied by alpha.</summary>
    readonly record struct Rgba(double R, double G, double B, double A);

    /// <summary>A picture in double precision; row 0 is the bottom row.</summary>
    /// <param name="DepthsMm">of the first visible segment, along the ray from its origin; infinite where there is none</param>
    /// <param name="Segments">65535 = none</param>
    sealed record ReferencePicture(int Width, int Height, Rgba[] Colors, double[] DepthsMm, ushort[] Segments);
}
