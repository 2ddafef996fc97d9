namespace AnatomyCarve.Metrics
{
    /// <summary>The difference of two 8-bit pictures.</summary>
    public readonly struct ImageDifference
    {
        internal ImageDifference(double rmse, double psnrDecibels, int largest)
        {
            Rmse = rmse;
            PsnrDecibels = psnrDecibels;
            Largest = largest;
        }

        /// <summary>Root mean square difference of the components, in codes of 0 to 255.</summary>
        public double Rmse { get; }

        /// <summary>Peak signal-to-noise ratio, 20 log10(255 / RMSE), in decibels; infinite for identical pictures.</summary>
        public double PsnrDecibels { get; }

        /// <summary>The largest difference of a component, in codes of 0 to 255.</summary>
        public int Largest { get; }
    }
}
