using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using Unity.Profiling;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>The kernels that work on bricks of a volume: each call dispatches one of them over a list of bricks.</summary>
    sealed class VolumeKernels : IDisposable
    {
        static readonly ProfilerMarker ClipMarker = new ProfilerMarker("AnatomyCarve.ClipVoxels");
        static readonly ProfilerMarker AntiAliasMarker = new ProfilerMarker("AnatomyCarve.AntiAlias");
        static readonly ProfilerMarker NormalsMarker = new ProfilerMarker("AnatomyCarve.SobelNormals");
        static readonly ProfilerMarker ClearMarker = new ProfilerMarker("AnatomyCarve.ClearBricks");

        readonly ComputeKernel clipVoxels, antiAlias, sobelNormals, clearBricks;
        readonly BrickGrid bricks;
        readonly SphereIndex index;
        readonly VolumeConstants constants;
        readonly RenderStatistics statistics;
        readonly BrickWork work;
        bool hasSpheres; // whether the kernel takes the spheres of each brick

        /// <exception cref="Volumes.AnatomyCarveException">A kernel could not be made.</exception>
        public VolumeKernels(
            BrickGrid bricks, SphereIndex index, VolumeConstants constants, AnatomyCarveShaders shaders, TextureLayout layout, RenderStatistics statistics)
        {
            clipVoxels = new ComputeKernel(shaders.ClipVoxels, nameof(shaders.ClipVoxels), layout);
            antiAlias = new ComputeKernel(shaders.AntiAlias, nameof(shaders.AntiAlias), layout);
            sobelNormals = new ComputeKernel(shaders.SobelNormals, nameof(shaders.SobelNormals), layout);
            clearBricks = new ComputeKernel(shaders.ClearBricks, nameof(shaders.ClearBricks), layout);
            this.bricks = bricks;
            this.index = index;
            this.constants = constants;
            this.statistics = statistics;
            work = new BrickWork(bricks);
        }

        /// <summary>What they read and write; to be set before the first call, and again when it was made anew.</summary>
        public VolumeTextures Textures { get; set; }

        /// <summary>What they write.</summary>
        public FieldTextures Field { get; set; }

        public LookupTextures Lookups { get; set; }

        public SphereBuffers Spheres { get; set; }

        public SkipStructure Skip { get; set; }

        public bool AreListsThere => work.IsValid;

        /// <exception cref="Volumes.AnatomyCarveException">The device could not make the lists.</exception>
        public void MakeLists() => work.Reserve();

        public void AddSizes(List<ResourceSize> sizes) => sizes.Add(new ResourceSize("AnatomyCarve bricks", work.Bytes));

        public void Dispose() => work.Dispose();

        /// <param name="list">The bricks.</param>
        /// <param name="parts">What of each is worked on; null = all. Likewise below.</param>
        public void ClipVoxels(IReadOnlyList<int> list, IReadOnlyList<BrickPart> parts, VisibleContents contents, CutMode cut)
        {
            using (ClipMarker.Auto())
            {
                clipVoxels.SetTexture(ShaderIds.Intensity, Textures.Intensity);
                clipVoxels.SetTexture(ShaderIds.Labels, Textures.Labels);
                clipVoxels.SetTexture(ShaderIds.TransferFunction, Lookups.TransferFunction);
                clipVoxels.SetTexture(ShaderIds.SegmentColors, Lookups.SegmentColors);
                clipVoxels.SetTexture(ShaderIds.OpacityOut, Field.Opacity);
                BindSpheres(clipVoxels);
                Begin(true);
                for (int n = 0; n < list.Count; n++)
                {
                    bricks.BrickAt(list[n], out int x, out int y, out int z);
                    index.Gather(x, y, z, cut, contents[list[n]], work.Spheres);
                    Add(list[n], PartAt(parts, n), clipVoxels, ref statistics.clipVoxels);
                }
                Flush(clipVoxels, ref statistics.clipVoxels);
            }
        }

        public void AntiAlias(IReadOnlyList<int> list, IReadOnlyList<BrickPart> parts)
        {
            using (AntiAliasMarker.Auto())
            {
                antiAlias.SetTexture(ShaderIds.Opacity, Field.Opacity);
                antiAlias.SetTexture(ShaderIds.OpacityAAOut, Field.OpacityAA);
                antiAlias.SetBuffer(ShaderIds.BrickMatter, Skip.BrickMatter);
                antiAlias.Count(statistics.WorkCounts);
                Begin(false);
                for (int n = 0; n < list.Count; n++)
                    Add(list[n], PartAt(parts, n), antiAlias, ref statistics.antiAlias);
                Flush(antiAlias, ref statistics.antiAlias);
            }
        }

        public void SobelNormals(IReadOnlyList<int> list, IReadOnlyList<BrickPart> parts, VisibleContents contents)
        {
            using (NormalsMarker.Auto())
            {
                sobelNormals.SetTexture(ShaderIds.OpacityAA, Field.OpacityAA);
                sobelNormals.SetTexture(ShaderIds.Labels, Textures.Labels);
                sobelNormals.SetTexture(ShaderIds.NormalsOut, Field.Normals);
                BindSpheres(sobelNormals);
                Begin(true);
                for (int n = 0; n < list.Count; n++)
                {
                    bricks.BrickAt(list[n], out int x, out int y, out int z);
                    index.GatherSurfaces(x, y, z, contents[list[n]], work.Spheres);
                    Add(list[n], PartAt(parts, n), sobelNormals, ref statistics.sobelNormals);
                }
                Flush(sobelNormals, ref statistics.sobelNormals);
            }
        }

        public void ClearBricks(IReadOnlyList<int> list)
        {
            using (ClearMarker.Auto())
            {
                clearBricks.SetTexture(ShaderIds.OpacityOut, Field.Opacity);
                clearBricks.SetTexture(ShaderIds.OpacityAAOut, Field.OpacityAA);
                clearBricks.SetTexture(ShaderIds.NormalsOut, Field.Normals);
                clearBricks.SetBuffer(ShaderIds.BrickMatter, Skip.BrickMatter);
                Begin(false);
                for (int n = 0; n < list.Count; n++)
                    Add(list[n], BrickPart.Whole, clearBricks, ref statistics.clearBricks);
                Flush(clearBricks, ref statistics.clearBricks);
            }
        }

        void BindSpheres(in ComputeKernel kernel)
        {
            kernel.SetBuffer(ShaderIds.Spheres, Spheres.Spheres);
            kernel.SetBuffer(ShaderIds.MaskWords, Spheres.MaskWords);
        }

        void Begin(bool withSpheres)
        {
            work.Clear();
            hasSpheres = withSpheres;
        }

        static BrickPart PartAt(IReadOnlyList<BrickPart> parts, int number) => parts == null ? BrickPart.Whole : parts[number];

        void Add(int brick, BrickPart part, in ComputeKernel kernel, ref StageStatistics stage)
        {
            work.Add(brick, part);
            if (work.IsFull)
                Flush(kernel, ref stage);
        }

        void Flush(in ComputeKernel kernel, ref StageStatistics stage)
        {
            if (work.Count == 0)
                return;
            work.Upload(hasSpheres);
            (int perRow, int rows) = ComputeKernel.SplitGroups(work.Count);
            constants.Bind(kernel, work.Count, perRow);
            kernel.SetBuffer(ShaderIds.Bricks, work.Bricks);
            if (hasSpheres)
            {
                kernel.SetBuffer(ShaderIds.BrickSpheres, work.Ranges);
                kernel.SetBuffer(ShaderIds.SphereSlots, work.Slots);
            }
            kernel.Dispatch(perRow, rows);
            stage.Add(1, work.Count, work.Voxels);
            work.Clear();
        }
    }
}
