using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using Unity.Profiling;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// One volume on the GPU, whose opacity, anti-aliased opacity, normals and skip structure are kept in step with the carving. It remembers what they were
    /// computed from: an edit of the carving recomputes the bricks that it can change, everything else recomputes the stages behind it where anything is
    /// visible, and where nothing changed nothing is dispatched.
    /// </summary>
    sealed class CarvePipeline : IDisposable
    {
        static readonly ProfilerMarker UploadMarker = new ProfilerMarker("AnatomyCarve.Upload");
        const double KeptShare = 0.75;

        static readonly ClipSphere[] NoSpheres = Array.Empty<ClipSphere>();

        readonly BrickGrid bricks;
        readonly SphereIndex index;
        readonly DirtyBrickSet dirty;
        readonly VolumeConstants constants;
        readonly VolumeKernels kernels;
        readonly SkipStructure skip;
        readonly LiveBricks live;
        readonly RenderStatistics statistics;
        VolumeTextures textures;
        FieldTextures field; // null until something is shown
        LookupTextures lookups;
        SphereBuffers spheres;

        VisibleContents contents;
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
            bricks = new BrickGrid(volume.Geometry);
            constants = new VolumeConstants(volume, bricks);
            index = new SphereIndex(bricks, constants.Grid);
            dirty = new DirtyBrickSet(bricks, constants.Grid) { Index = index };
            kernels = new VolumeKernels(bricks, index, constants, shaders, layout, statistics);
            skip = new SkipStructure(bricks, shaders);
            live = new LiveBricks(bricks);
            MakeResources();
        }

        public SegmentedVolume Volume { get; }

        /// <summary>Compact or portable.</summary>
        public TextureLayout Layout { get; }

        /// <summary>Tells this pipeline from others, for those who must not hold its volume.</summary>
        public object Identity { get; } = new object();

        /// <summary>The voxels of which opacities and normals are stored; null before the first update.</summary>
        public VoxelBox? StoredVoxels => field?.Box;

        /// <summary>Rises with every change of what a picture would show.</summary>
        public int Version { get; private set; }

        /// <summary>Brings the volume's textures up to date with what a picture depends on.</summary>
        public void Update(
            CarvingSnapshot carving, OpacityTransferFunction transferFunction, SegmentTable segments, CutMode cut, AntiAliasSettings antiAliasing)
        {
            RestoreLost();
            long tests = index.Tests, gathered = index.Gathered;
            IReadOnlyList<ClipSphere> wanted = carving ?? (IReadOnlyList<ClipSphere>)NoSpheres;
            bool shown = !filled || transferFunction != usedTransferFunction || OpacitiesDiffer(segments, usedSegments);
            bool all = shown || cut != usedCut;
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
            {
                index.Update(wanted);
                spheres.Upload();
            }
            constants.Set(transferFunction, spheres, index.Count, cut, antiAliasing);
            if (shown)
                Show(segments);
            if (all)
                kernels.ClipVoxels(live.Visible, null, contents, cut);
            else if (carved)
                kernels.ClipVoxels(Dirty(wanted, cut, 0), dirty.Parts, contents, cut);
            bool changed = smoothing || recolored;
            if (smoothing)
                SmoothAll();
            else if (carved)
                changed |= SmoothDirty(wanted, cut);
            statistics.SphereBrickTests += index.Tests - tests;
            statistics.SpheresInBricks += index.Gathered - gathered;

            usedSpheres = wanted;
            usedTransferFunction = transferFunction;
            usedSegments = segments;
            usedCut = cut;
            usedAntiAlias = antiAliasing;
            filled = true;
            if (changed)
                Version++;
        }

        /// <summary>Gives all that rays read to a kernel or a material.</summary>
        public void BindForRays<T>(T target) where T : IShaderValues
        {
            constants.Bind(target);
            target.SetTexture(ShaderIds.Labels, textures.Labels);
            target.SetTexture(ShaderIds.SegmentColors, lookups.SegmentColors);
            target.SetTexture(ShaderIds.Opacity, field.Opacity);
            target.SetTexture(ShaderIds.OpacityAA, field.OpacityAA);
            target.SetTexture(ShaderIds.Normals, field.Normals);
            target.SetTexture(ShaderIds.SkipMap, skip.Map);
        }

        public void AddSizes(List<ResourceSize> sizes)
        {
            textures.AddSizes(sizes);
            field?.AddSizes(sizes);
            lookups.AddSizes(sizes);
            spheres.AddSizes(sizes);
            skip.AddSizes(sizes);
            kernels.AddSizes(sizes);
        }

        public void Dispose()
        {
            textures?.Dispose();
            field?.Dispose();
            field = null;
            lookups?.Dispose();
            spheres?.Dispose();
            skip.Dispose();
            kernels.Dispose();
        }

        void MakeResources()
        {
            using (UploadMarker.Auto())
            {
                try
                {
                    kernels.Textures = textures = new VolumeTextures(Volume);
                    kernels.Lookups = lookups = new LookupTextures(Volume.Segments.Count);
                    kernels.Spheres = spheres = new SphereBuffers(index, Volume.Segments.Count);
                    kernels.Skip = skip;
                    skip.Make();
                    kernels.MakeLists();
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
            if (!textures.Exist || (field != null && !field.Exist) || !lookups.Exist || !skip.Exists || !kernels.AreListsThere)
            {
                Dispose();
                MakeResources();
            }
            if ((field != null && field.Restore()) | skip.Restore() || (filled && !spheres.IsValid))
                filled = false;
        }

        /// <summary>Finds what is visible before carving, and empties what was and is no more; at first all that is not.</summary>
        void Show(SegmentTable segments)
        {
            contents = VisibleContents.Of(Volume, constants.Lookup, OpacitiesOf(segments));
            dirty.Contents = contents;
            live.Take(contents);
            bool isNew = Hold(live.Box);
            kernels.ClearBricks(live.Emptied(isNew || !filled));
        }

        /// <summary>
        /// Sees to it that a box is stored. One that is smaller by less than a quarter leaves the textures as they are, so that not every change of a setting makes them
        /// anew.
        /// </summary>
        /// <returns>Whether textures are new, and empty.</returns>
        bool Hold(VoxelBox box)
        {
            if (field != null && field.Box.Contains(box) && box.VoxelCount > KeptShare * field.Box.VoxelCount)
                return false;
            field?.DisposeAtOnce(); // so that never both take memory
            kernels.Field = field = null;
            kernels.Field = field = new FieldTextures(box, Layout);
            constants.SetStored(box);
            return true;
        }

        void SmoothAll()
        {
            kernels.AntiAlias(live.NearMatter, null);
            kernels.SobelNormals(live.NearMatter, null, contents);
            skip.Update(null, constants, ref statistics.skipCells);
        }

        /// <returns>Whether a picture can look different.</returns>
        bool SmoothDirty(IReadOnlyList<ClipSphere> wanted, CutMode cut)
        {
            IReadOnlyList<int> list = Dirty(wanted, cut, CarvingReach.AntiAliasVoxels);
            bool changed = list.Count > 0;
            if (changed)
            {
                kernels.AntiAlias(list, dirty.Parts);
                skip.Update(list, constants, ref statistics.skipCells);
            }
            dirty.ComputeNormals(usedSpheres, wanted, cut);
            kernels.SobelNormals(dirty.Indices, dirty.Parts, contents);
            return changed || dirty.Count > 0;
        }

        IReadOnlyList<int> Dirty(IReadOnlyList<ClipSphere> wanted, CutMode cut, int haloVoxels)
        {
            dirty.Compute(usedSpheres, wanted, cut, haloVoxels);
            return dirty.Indices;
        }

        static float[] OpacitiesOf(SegmentTable segments)
        {
            var opacities = new float[segments.Count];
            for (int s = 0; s < opacities.Length; s++)
                opacities[s] = segments[s].Opacity;
            return opacities;
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
