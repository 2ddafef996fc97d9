namespace AnatomyCarve.Headless
{
    /// <summary>Through which compilers kernels go to the device.</summary>
    public enum KernelCompiler
    {
        /// <summary>glslang's HLSL front end.</summary>
        Glslang = 0,

        /// <summary>
        /// Microsoft's FXC, which Unity's kernels go through first on every platform; vkd3d-compiler says its bytecode in SPIR-V. Both must be set up, which
        /// Headless~/check-d3d does; otherwise kernels do not compile, with a message that says so.
        /// </summary>
        Fxc = 1,
    }
}
