using System.Collections.Generic;
using AnatomyCarve.Carving;

namespace AnatomyCarve
{
    /// <summary>The work of one stage of the pipeline since the statistics were last reset.</summary>
    public struct StageStatistics
    {
        /// <summary>How often the kernel was dispatched.</summary>
        public int Dispatches { get; internal set; }

        /// <summary>Bricks of 8 x 8 x 8 voxels that the kernel worked on; 0 for <c>Raymarch</c>.</summary>
        public long Bricks { get; internal set; }

        /// <summary>Voxels (pixels for <c>Raymarch</c>) that the kernel wrote.</summary>
        public long Elements { get; internal set; }

        internal void Add(int dispatches, long bricks, long elements)
        {
            Dispatches += dispatches;
            Bricks += bricks;
            Elements += elements;
        }
    }

    /// <summary>A GPU resource and its size.</summary>
    public readonly struct ResourceSize
    {
        internal ResourceSize(string name, long bytes)
        {
            Name = name;
            Bytes = bytes;
        }

        /// <summary>The resource's name, as frame debuggers show it.</summary>
        public string Name { get; }

        /// <summary>Its size in bytes, without the driver's padding.</summary>
        public long Bytes { get; }
    }

    /// <summary>What a <see cref="CarvedVolumeRenderer"/> has done: dispatches, bricks and elements by stage, samples, and what it holds on the GPU.</summary>
    public sealed class RenderStatistics
    {
        internal StageStatistics clipVoxels;
        internal StageStatistics antiAlias;
        internal StageStatistics sobelNormals;
        internal StageStatistics clearBricks;
        internal StageStatistics skipCells;
        internal StageStatistics raymarch;
        readonly List<ResourceSize> resources = new List<ResourceSize>();

        internal RenderStatistics()
        {
        }

        /// <summary>Work of the kernel <c>ClipVoxels</c>.</summary>
        public StageStatistics ClipVoxels => clipVoxels;

        /// <summary>Work of the kernel <c>AntiAlias</c>.</summary>
        public StageStatistics AntiAlias => antiAlias;

        /// <summary>Work of the kernel <c>SobelNormals</c>.</summary>
        public StageStatistics SobelNormals => sobelNormals;

        /// <summary>Work of the kernel <c>ClearBricks</c>, which empties bricks in which nothing is visible.</summary>
        public StageStatistics ClearBricks => clearBricks;

        /// <summary>Work of the kernels that keep up the skip structure, three dispatches an edit; elements are cells of 4 x 4 x 4 voxels.</summary>
        public StageStatistics SkipCells => skipCells;

        /// <summary>How often a clip sphere was tested against a brick, on the CPU.</summary>
        public long SphereBrickTests { get; internal set; }

        /// <summary>How many clip spheres were given to bricks, one by one: each is then tested against the voxels of its brick, on the GPU.</summary>
        public long SpheresInBricks { get; internal set; }

        /// <summary>Work of the kernel <c>Raymarch</c>.</summary>
        public StageStatistics Raymarch => raymarch;

        /// <summary>Volume kernels dispatched (all but <c>Raymarch</c>). It stands still while nothing changes.</summary>
        public int VolumeDispatches =>
            clipVoxels.Dispatches + antiAlias.Dispatches + sobelNormals.Dispatches + clearBricks.Dispatches + skipCells.Dispatches;

        /// <summary>How the volume lies in textures; <see cref="TextureLayout.Automatic"/> while none is on the GPU.</summary>
        public TextureLayout Layout => Source == null ? TextureLayout.Automatic : Source.Layout;

        /// <summary>
        /// The voxels of which opacities and normals are stored: the box around all in which anything can be visible, whatever the carving. Null while no volume is on the
        /// GPU.
        /// </summary>
        public VoxelBox? StoredVoxels => Source?.StoredVoxels;

        /// <summary>What the renderer holds on the GPU now, resource by resource. Each call lists anew, so do not ask every frame.</summary>
        public IReadOnlyList<ResourceSize> Resources
        {
            get
            {
                resources.Clear();
                Source?.AddSizes(resources);
                return resources;
            }
        }

        /// <summary>Sum of <see cref="Resources"/> in bytes.</summary>
        public long BytesResident => Sum(Resources);

        /// <summary>The part of <see cref="BytesResident"/> that is the volume's, without pictures: at most what <see cref="MemoryForecast.GpuBytes"/> foretold.</summary>
        public long VolumeBytesResident
        {
            get
            {
                resources.Clear();
                Source?.AddVolumeSizes(resources);
                return Sum(resources);
            }
        }

        /// <summary>Whose resources are listed; null = there are none.</summary>
        internal VolumeGpu Source { get; set; }

        /// <summary>A buffer of four counts that AntiAlias adds to, for tests and benchmarks; null = it does not count.</summary>
        internal UnityEngine.GraphicsBuffer WorkCounts { get; set; }

        /// <summary>Sets all counts to zero.</summary>
        public void Reset()
        {
            clipVoxels = default;
            antiAlias = default;
            sobelNormals = default;
            clearBricks = default;
            skipCells = default;
            raymarch = default;
            SphereBrickTests = 0;
            SpheresInBricks = 0;
        }

        static long Sum(IReadOnlyList<ResourceSize> sizes)
        {
            long sum = 0;
            foreach (ResourceSize size in sizes)
                sum += size.Bytes;
            return sum;
        }
    }
}
