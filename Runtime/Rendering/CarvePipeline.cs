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
        readonly BrickBuffer allBricks, dirtyBricks;
        readonly uint[] allPacked, dirtyPacked;
        readonly DirtyBrickSet dirty;
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
        public CarvePipeline(SegmentedVolume volume, AnatomyCarveShaders shaders, TextureLayout layout, RenderStatistics statistics)
        {
            Volume = volume;
            Layout = layout;
            this.statistics = statistics;
            clipVoxels = new ComputeKernel(shaders.ClipVoxels, nameof(shaders.ClipVoxels), layout);
            antiAlias = new ComputeKernel(shaders.AntiAlias, nameof(shaders.AntiAlias), layout);
            sobelNormals = new ComputeKernel(shaders.SobelNormals, nameof(shaders.SobelNormals), layout);
            var bricks = new BrickGrid(volume.Geometry);
            constants = new VolumeConstants(volume, bricks);
            dirty = new DirtyBrickSet(bricks, constants.Grid);
            allBricks = new BrickBuffer("AnatomyCarve all bricks", bricks);
            dirtyBricks = new BrickBuffer("AnatomyCarve dirty bricks", bricks);
            allPacked = bricks.PackAll();
            dirtyPacked = new uint[allPacked.Length];
            MakeResources();
        }

        public SegmentedVolume Volume { get; }

        /// <summary>Compact or portable.</summary>
        public TextureLayout Layout { get; }

        /// <summary>Tells this pipeline from others, for those who must not hold its volume.</summary>
        public object Identity { get; } = new object();

        /// <summary>Rises with every change of what a picture would show.</summary>
        public int Version { get; private set; }

        /// <summary>Brings the volume's textures up to date with what a picture depends on.</summary>
        public void Update(
            CarvingSnapshot carving, OpacityTransferFunction transferFunction, SegmentTable segments, CutMode cut, AntiAliasSettings antiAliasing)
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

        /// <summary>Gives all that rays read to a kernel or a material.</summary>
        public void BindForRays<T>(T target) where T : IShaderValues
        {
            constants.Bind(target);
            target.SetTexture(ShaderIds.Labels, textures.Labels);
            target.SetTexture(ShaderIds.SegmentColors, lookups.SegmentColors);
            target.SetTexture(ShaderIds.Opacity, textures.Opacity);
            target.SetTexture(ShaderIds.OpacityAA, textures.OpacityAA);
            target.SetTexture(ShaderIds.Normals, textures.Normals);
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
                    textures = new VolumeTextures(Volume, Layout);
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
                ClipVoxels(allBricks);
            AntiAlias(allBricks);
            SobelNormals(allBricks);
        }

        void DispatchDirty(IReadOnlyList<ClipSphere> wanted, CutMode cut, bool smoothAll)
        {
            if (UploadDirty(wanted, cut, 0))
                ClipVoxels(dirtyBricks);
            if (smoothAll)
            {
                DispatchAll(false);
                return;
            }
            if (UploadDirty(wanted, cut, CarvingReach.AntiAliasVoxels))
                AntiAlias(dirtyBricks);
            if (UploadDirty(wanted, cut, CarvingReach.NormalsVoxels))
                SobelNormals(dirtyBricks);
        }

        bool UploadDirty(IReadOnlyList<ClipSphere> wanted, CutMode cut, int haloVoxels)
        {
            dirty.Compute(usedSpheres, wanted, cut, haloVoxels);
            if (dirty.IsNone)
                return false;
            dirty.PackInto(dirtyPacked);
            dirtyBricks.Upload(dirtyPacked, dirty.Count);
            return true;
        }

        void ClipVoxels(BrickBuffer list)
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
                Dispatch(clipVoxels, list, ref statistics.clipVoxels);
            }
        }

        void AntiAlias(BrickBuffer list)
        {
            using (AntiAliasMarker.Auto())
            {
                antiAlias.SetTexture(ShaderIds.Opacity, textures.Opacity);
                antiAlias.SetTexture(ShaderIds.OpacityAAOut, textures.OpacityAA);
                Dispatch(antiAlias, list, ref statistics.antiAlias);
            }
        }

        void SobelNormals(BrickBuffer list)
        {
            using (NormalsMarker.Auto())
            {
                sobelNormals.SetTexture(ShaderIds.OpacityAA, textures.OpacityAA);
                sobelNormals.SetTexture(ShaderIds.NormalsOut, textures.Normals);
                Dispatch(sobelNormals, list, ref statistics.sobelNormals);
            }
        }

        void Dispatch(in ComputeKernel kernel, BrickBuffer list, ref StageStatistics stage)
        {
            (int perRow, int rows) = ComputeKernel.SplitGroups(list.Count);
            constants.Bind(kernel, list.Count, perRow);
            kernel.SetBuffer(ShaderIds.Bricks, list.Buffer);
            kernel.Dispatch(perRow, rows);
            stage.Add(1, list.Count, list.Voxels);
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
