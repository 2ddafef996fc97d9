using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using Unity.Profiling;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// One volume on the GPU, and the three kernels that keep its opacity, anti-aliased opacity and normals in step with the carving. It
    /// remembers what they were computed from: an edit of the carving recomputes the bricks that it can change, everything else recomputes the
    /// stages behind it, and where nothing changed nothing is dispatched.
    /// </summary>
    sealed class CarvePipeline : IDisposable
    {
        static readonly ProfilerMarker UploadMarker = new ProfilerMarker("AnatomyCarve.Upload");
        static readonly ProfilerMarker ClipMarker = new ProfilerMarker("AnatomyCarve.ClipVoxels");
        static readonly ProfilerMarker AntiAliasMarker = new ProfilerMarker("AnatomyCarve.AntiAlias");
        static readonly ProfilerMarker NormalsMarker = new ProfilerMarker("AnatomyCarve.SobelNormals");
        static readonly ClipSphere[] NoSpheres = Array.Empty<ClipSphere>();

        readonly ComputeKernel clipVoxels, antiAlias, sobelNormals;
        readonly BrickBuffer allBricks = new BrickBuffer("AnatomyCarve all bricks");
        readonly BrickBuffer dirtyBricks = new BrickBuffer("AnatomyCarve dirty bricks");
        readonly uint[] allPacked, dirtyPacked;
        readonly BrickGrid bricks;
        readonly VolumeConstants constants;
        readonly RenderStatistics statistics;
        VolumeTextures textures;
        LookupTextures lookups;
        SphereBuffers spheres;

        IReadOnlyList<ClipSphere> usedSpheres = NoSpheres;
        OpacityTransferFunction usedTransferFunction;
        SegmentTable usedSegments;
        CutMode usedCut;
        AntiAliasSettings usedAntiAlias;
        bool filled;

        /// <summary>Uploads a volume. Nothing is computed before the first <see cref="Update"/>.</summary>
        /// <exception cref="AnatomyCarveException">A kernel or a texture could not be made.</exception>
        public CarvePipeline(SegmentedVolume volume, AnatomyCarveShaders shaders, RenderStatistics statistics)
        {
            Volume = volume;
            this.statistics = statistics;
            clipVoxels = new ComputeKernel(shaders.ClipVoxels, nameof(shaders.ClipVoxels));
            antiAlias = new ComputeKernel(shaders.AntiAlias, nameof(shaders.AntiAlias));
            sobelNormals = new ComputeKernel(shaders.SobelNormals, nameof(shaders.SobelNormals));
            bricks = new BrickGrid(volume.Geometry);
            constants = new VolumeConstants(volume, bricks);
            allPacked = bricks.PackAll();
            dirtyPacked = new uint[allPacked.Length];
            MakeResources();
        }

        public SegmentedVolume Volume { get; }

        public VolumeConstants Constants => constants;

        public VolumeTextures Textures => textures;

        public Texture SegmentColors => lookups.SegmentColors;

        /// <summary>Rises with every change of what a picture would show.</summary>
        public int Version { get; private set; }

        /// <summary>Brings the volume's textures up to date with what a picture depends on.</summary>
        public void Update(CarvingSnapshot carving, OpacityTransferFunction transferFunction, SegmentTable segments, CutMode cut, AntiAliasSettings antiAliasing)
        {
            RestoreLost();
            IReadOnlyList<ClipSphere> wanted = carving ?? (IReadOnlyList<ClipSphere>)NoSpheres;
            bool all = !filled || cut != usedCut || transferFunction != usedTransferFunction || OpacitiesDiffer(segments, usedSegments);
            bool smoothing = all || !antiAliasing.Equals(usedAntiAlias);
            bool carved = !ReferenceEquals(wanted, usedSpheres);
            bool recolored = segments != usedSegments;
            if (!smoothing && !carved && !recolored)
                return;

            if (transferFunction != usedTransferFunction || !filled)
                lookups.Upload(transferFunction);
            if (recolored || !filled)
                lookups.Upload(segments);
            if (carved || !filled)
                spheres.Upload(wanted);
            constants.Set(transferFunction, spheres, cut, antiAliasing);
            if (all)
                DispatchAll(true);
            else if (smoothing && !carved)
                DispatchAll(false);
            else if (carved)
                DispatchDirty(wanted, cut, smoothing);

            usedSpheres = wanted;
            usedTransferFunction = transferFunction;
            usedSegments = segments;
            usedCut = cut;
            usedAntiAlias = antiAliasing;
            filled = true;
            Version++;
        }

        public void AddSizes(List<ResourceSize> sizes)
        {
            textures.AddSizes(sizes);
            lookups.AddSizes(sizes);
            spheres.AddSizes(sizes);
            sizes.Add(new ResourceSize("AnatomyCarve bricks", allBricks.Bytes + dirtyBricks.Bytes));
        }

        public void Dispose()
        {
            textures?.Dispose();
            lookups?.Dispose();
            spheres?.Dispose();
            allBricks.Dispose();
            dirtyBricks.Dispose();
        }

        void MakeResources()
        {
            using (UploadMarker.Auto())
            {
                try
                {
                    textures = new VolumeTextures(Volume);
                    lookups = new LookupTextures(Volume.Segments.Count);
                    spheres = new SphereBuffers(new CentredGrid(Volume.Geometry), Volume.Segments.Count);
                    allBricks.Upload(allPacked, allPacked.Length);
                    dirtyBricks.Upload(dirtyPacked, 1);
                }
                catch
                {
                    Dispose();
                    throw;
                }
            }
            filled = false;
        }

        /// <summary>A lost device empties render textures; scripts and scene changes may destroy objects.</summary>
        void RestoreLost()
        {
            if (!textures.Exist || !lookups.Exist || !allBricks.IsValid || !dirtyBricks.IsValid)
            {
                Dispose();
                MakeResources();
            }
            if (textures.Restore() || (filled && !spheres.IsValid))
                filled = false;
        }

        void DispatchAll(bool withOpacity)
        {
            if (withOpacity)
                ClipVoxels(allBricks, bricks.Count);
            AntiAlias(allBricks, bricks.Count);
            SobelNormals(allBricks, bricks.Count);
        }

        void DispatchDirty(IReadOnlyList<ClipSphere> wanted, CutMode cut, bool smoothAll)
        {
            int clipped = UploadDirty(wanted, cut, 0);
            if (clipped > 0)
                ClipVoxels(dirtyBricks, clipped);
            if (smoothAll)
            {
                DispatchAll(false);
                return;
            }
            int smoothed = UploadDirty(wanted, cut, CarvingReach.AntiAliasVoxels);
            if (smoothed > 0)
                AntiAlias(dirtyBricks, smoothed);
            int normals = UploadDirty(wanted, cut, CarvingReach.NormalsVoxels);
            if (normals > 0)
                SobelNormals(dirtyBricks, normals);
        }

        int UploadDirty(IReadOnlyList<ClipSphere> wanted, CutMode cut, int haloVoxels)
        {
            DirtyBricks dirty = DirtyBricks.Between(usedSpheres, wanted, bricks, constants.Grid, cut, haloVoxels);
            if (dirty.IsNone)
                return 0;
            dirty.PackInto(dirtyPacked);
            dirtyBricks.Upload(dirtyPacked, dirty.Count);
            return dirty.Count;
        }

        void ClipVoxels(BrickBuffer list, int count)
        {
            using (ClipMarker.Auto())
            {
                clipVoxels.SetTexture(ShaderIds.Intensity, textures.Intensity);
                clipVoxels.SetTexture(ShaderIds.Labels, textures.Labels);
                clipVoxels.SetTexture(ShaderIds.TransferFunction, lookups.TransferFunction);
                clipVoxels.SetTexture(ShaderIds.SegmentColors, lookups.SegmentColors);
                clipVoxels.SetBuffer(ShaderIds.Spheres, spheres.Spheres);
                clipVoxels.SetBuffer(ShaderIds.MaskWords, spheres.MaskWords);
                clipVoxels.SetTexture(ShaderIds.OpacityOut, textures.Opacity);
                Dispatch(clipVoxels, list, count, ref statistics.clipVoxels);
            }
        }

        void AntiAlias(BrickBuffer list, int count)
        {
            using (AntiAliasMarker.Auto())
            {
                antiAlias.SetTexture(ShaderIds.Opacity, textures.Opacity);
                antiAlias.SetTexture(ShaderIds.OpacityAAOut, textures.OpacityAA);
                Dispatch(antiAlias, list, count, ref statistics.antiAlias);
            }
        }

        void SobelNormals(BrickBuffer list, int count)
        {
            using (NormalsMarker.Auto())
            {
                sobelNormals.SetTexture(ShaderIds.OpacityAA, textures.OpacityAA);
                sobelNormals.SetTexture(ShaderIds.NormalsOut, textures.Normals);
                Dispatch(sobelNormals, list, count, ref statistics.sobelNormals);
            }
        }

        void Dispatch(in ComputeKernel kernel, BrickBuffer list, int count, ref StageStatistics stage)
        {
            (int perRow, int rows) = ComputeKernel.SplitGroups(count);
            constants.Bind(kernel.Shader, count, perRow);
            kernel.SetBuffer(ShaderIds.Bricks, list.Buffer);
            kernel.Dispatch(perRow, rows);
            stage.Add(1, count, (long)count * BrickGrid.VoxelsPerBrick);
        }

        static bool OpacitiesDiffer(SegmentTable a, SegmentTable b)
        {
            if (ReferenceEquals(a, b))
                return false;
            if (a == null || b == null || a.Count != b.Count)
                return true;
            for (int s = 0; s < a.Count; s++)
                if (a[s].Opacity != b[s].Opacity)
                    return true;
            return false;
        }
    }
}
