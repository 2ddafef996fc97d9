using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>The cbuffer <c>CarvedVolume</c> of <c>Shaders/VolumeLayout.hlsl</c>: a volume's geometry, tables and carving, for every kernel.</summary>
    sealed class VolumeConstants
    {
        readonly SegmentedVolume volume;
        readonly int[] dims = new int[4];
        readonly int[] brickGrid = new int[4];
        readonly int[] counts = new int[4];
        readonly Vector4 indexToMm0, indexToMm1, indexToMm2;
        readonly Vector4 mmToIndex0, mmToIndex1, mmToIndex2;
        readonly Vector4 centreIndex;
        OpacityTransferFunction lookedUp;
        Vector4 intensityToLookup;
        Vector4 antiAlias;

        public VolumeConstants(SegmentedVolume volume, BrickGrid bricks)
        {
            this.volume = volume;
            VolumeGeometry geometry = volume.Geometry;
            Grid = new CentredGrid(geometry);
            dims[0] = geometry.SizeI;
            dims[1] = geometry.SizeJ;
            dims[2] = geometry.SizeK;
            brickGrid[0] = bricks.BricksX;
            brickGrid[1] = bricks.BricksY;
            brickGrid[2] = bricks.BricksZ;
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

        public void Set(OpacityTransferFunction transferFunction, SphereBuffers spheres, CutMode cut, AntiAliasSettings antiAliasing)
        {
            if (transferFunction != lookedUp)
            {
                var lookup = new OpacityLookup(transferFunction, volume.Intensity);
                intensityToLookup = new Vector4(lookup.Scale, lookup.Offset, OpacityLookup.LastEntry, 0f);
                lookedUp = transferFunction;
            }
            counts[0] = spheres.Count;
            counts[1] = spheres.WordsPerMask;
            counts[2] = volume.Segments.Count;
            counts[3] = cut == CutMode.Smooth ? 1 : 0;
            antiAlias = new Vector4(antiAliasing.ThresholdAbsolute, antiAliasing.ThresholdRelative, antiAliasing.GradientMinimum, antiAliasing.Strength);
        }

        /// <summary>Sets all of it on a shader, which other volumes use too. <paramref name="bricks"/> 0 = the kernel works on no bricks.</summary>
        public void Bind(ComputeShader shader, int bricks, int groupsPerRow)
        {
            dims[3] = bricks;
            brickGrid[3] = groupsPerRow;
            shader.SetInts(ShaderIds.VolumeDims, dims);
            shader.SetInts(ShaderIds.BrickGrid, brickGrid);
            shader.SetInts(ShaderIds.CarveCounts, counts);
            shader.SetVector(ShaderIds.IndexToMm0, indexToMm0);
            shader.SetVector(ShaderIds.IndexToMm1, indexToMm1);
            shader.SetVector(ShaderIds.IndexToMm2, indexToMm2);
            shader.SetVector(ShaderIds.MmToIndex0, mmToIndex0);
            shader.SetVector(ShaderIds.MmToIndex1, mmToIndex1);
            shader.SetVector(ShaderIds.MmToIndex2, mmToIndex2);
            shader.SetVector(ShaderIds.CentreIndex, centreIndex);
            shader.SetVector(ShaderIds.IntensityToLookup, intensityToLookup);
            shader.SetVector(ShaderIds.AntiAlias, antiAlias);
        }

        static Vector4 Row(Affine matrix, int row) => new Vector4((float)matrix[row, 0], (float)matrix[row, 1], (float)matrix[row, 2], 0f);
    }
}
