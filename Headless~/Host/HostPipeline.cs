namespace AnatomyCarve.Headless
{
    /// <summary>The render pipeline of the project that the host pretends to be.</summary>
    public enum HostPipeline
    {
        /// <summary>The Built-in pipeline; no package is installed.</summary>
        BuiltIn = 0,

        /// <summary>URP 17, as far as this host knows it.</summary>
        Universal = 1,

        /// <summary>HDRP by its tag: it raises its events and draws nothing of the scene.</summary>
        HighDefinition = 2,

        /// <summary>A pipeline of somebody else's, with a tag that nobody knows.</summary>
        Other = 3,
    }
}
