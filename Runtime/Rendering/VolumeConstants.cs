using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>The cbuffer <c>CarvedVolume</c> of <c>Shaders/VolumeLayout.hlsl</c>: a volume's geometry, tables and carving, for every kernel.</summary>
    sealed class VolumeConstants
    {
        readonly SegmentedVolume volume;
        readonly Vector4 dims, brickGrid;
        readonly Vector4 indexToMm0, indexToMm1, indexToMm2;
        readonly Vector4 mmToIndex0, mmToIndex1, mmToIndex2;
        readonly Vector4 centreIndex;
        OpacityTransferFunction lookedUp;
        Vector4 intensityToLookup;
        Vector4 counts;
        Vector4 antiAlias;
        Vector4 storedFirst, storedLast;

        public VolumeConstants(SegmentedVolume volume, BrickGrid bricks)
        {
            this.volume = volume;
            VolumeGeometry geometry = volume.Geometry;
            Grid = new CentredGrid(geometry);
            dims = new Vector4(geometry.SizeI, geometry.SizeJ, geometry.SizeK, 0f);
            brickGrid = new Vector4(bricks.BricksX, bricks.BricksY, bricks.BricksZ, 0f);
            indexToMm0 = new Vector4(Grid[0, 0], Grid[0, 1], Grid[0, 2], 0f);
            indexToMm1 = new Vector4(Grid[1, 0], Grid[1, 1], Grid[1, 2], 0f);
            indexToMm2 = new Vector4(Grid[2, 0], Grid[2, 1], Grid[2, 2], 0f);
            mmToIndex0 = Row(geometry.LpsToIjk, 0);
            mmToIndex1 = Row(geometry.LpsToIjk, 1);
            mmToIndex2 = Row(geometry.LpsToIjk, 2);
            centreIndex = new Vector4(Grid.CentreI, Grid.CentreJ, Grid.CentreK, (float)geometry.ReferenceLengthMm);
        }

        /// <summary>The volume's grid in float, as the kernels see it.</summary>
        public CentredGrid Grid { get; }

        /// <summary>The transfer function as it is applied to intensity codes.</summary>
        public OpacityLookup Lookup { get; private set; }

        public void Set(OpacityTransferFunction transferFunction, SphereBuffers spheres, int sphereCount, CutMode cut, AntiAliasSettings antiAliasing)
        {
            if (transferFunction != lookedUp)
            {
                Lookup = new OpacityLookup(transferFunction, volume.Intensity);
                intensityToLookup = new Vector4(Lookup.Scale, Lookup.Offset, OpacityLookup.LastEntry, 0f);
                lookedUp = transferFunction;
            }
            counts = new Vector4(sphereCount, spheres.WordsPerMask, volume.Segments.Count, cut == CutMode.Smooth ? 1f : 0f);
            antiAlias = new Vector4(antiAliasing.ThresholdAbsolute, antiAliasing.ThresholdRelative, antiAliasing.GradientMinimum, antiAliasing.Strength);
        }

        /// <summary>Takes the voxels that opacities and normals are stored of.</summary>
        public void SetStored(VoxelBox box)
        {
            storedFirst = new Vector4(box.MinI, box.MinJ, box.MinK, 0f);
            storedLast = new Vector4(box.MaxI - box.MinI, box.MaxJ - box.MinJ, box.MaxK - box.MinK, 0f);
        }

        /// <summary>Sets all of it for a kernel that works on bricks. Other volumes use its shader too.</summary>
        public void Bind<T>(T target, int bricks, int groupsPerRow) where T : IShaderValues
        {
            target.SetVector(ShaderIds.VolumeDims, new Vector4(dims.x, dims.y, dims.z, bricks));
            target.SetVector(ShaderIds.BrickGrid, new Vector4(brickGrid.x, brickGrid.y, brickGrid.z, groupsPerRow));
            target.SetVector(ShaderIds.CarveCounts, counts);
            target.SetVector(ShaderIds.IndexToMm0, indexToMm0);
            target.SetVector(ShaderIds.IndexToMm1, indexToMm1);
            target.SetVector(ShaderIds.IndexToMm2, indexToMm2);
            target.SetVector(ShaderIds.MmToIndex0, mmToIndex0);
            target.SetVector(ShaderIds.MmToIndex1, mmToIndex1);
            target.SetVector(ShaderIds.MmToIndex2, mmToIndex2);
            target.SetVector(ShaderIds.StoredFirst, storedFirst);
            target.SetVector(ShaderIds.StoredLast, storedLast);
            target.SetVector(ShaderIds.CentreIndex, centreIndex);
            target.SetVector(ShaderIds.IntensityToLookup, intensityToLookup);
            target.SetVector(ShaderIds.AntiAlias, antiAlias);
        }

        /// <summary>Sets all of it for what works on rays.</summary>
        public void Bind<T>(T target) where T : IShaderValues => Bind(target, 0, 1);

        static Vector4 Row(Affine matrix, int row) => new Vector4((float)matrix[row, 0], (float)matrix[row, 1], (float)matrix[row, 2], 0f);
    }
}
