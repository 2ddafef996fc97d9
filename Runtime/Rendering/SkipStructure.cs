using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// By how many cells of 4 x 4 x 4 voxels rays may skip: the distance of each cell to the nearest in which a sample can be above 0, at most 7. Computed from
    /// what AntiAlias says of each brick. Where bricks change, distances can change up to 7 cells around: its own dirty set is the box of the dirty bricks,
    /// with one cell more, and then 7 more, on every side.
    /// </summary>
    sealed class SkipStructure : IDisposable
    {
        const int CellSize = 4, CellsPerBrick = 2, FarthestCell = 7, CellsPerTexel = 4, CellsPerWord = 32, GroupSize = 4;

        static readonly ProfilerMarker Marker = new ProfilerMarker("AnatomyCarve.SkipStructure");

        readonly BrickGrid bricks;
        readonly ComputeKernel occupiedCells, planeDistances, skipDistances;
        readonly int cellsX, cellsY, cellsZ;
        readonly int[] first = new int[4], size = new int[4];

        /// <exception cref="Volumes.AnatomyCarveException">A kernel could not be made.</exception>
        public SkipStructure(BrickGrid bricks, AnatomyCarveShaders shaders)
        {
            this.bricks = bricks;
            occupiedCells = new ComputeKernel(shaders.OccupiedCells, nameof(shaders.OccupiedCells), TextureLayout.Automatic);
            planeDistances = new ComputeKernel(shaders.PlaneDistances, nameof(shaders.PlaneDistances), TextureLayout.Automatic);
            skipDistances = new ComputeKernel(shaders.SkipDistances, nameof(shaders.SkipDistances), TextureLayout.Automatic);
            cellsX = Cells(bricks.SizeI);
            cellsY = Cells(bricks.SizeJ);
            cellsZ = Cells(bricks.SizeK);
        }

        /// <summary>Where in each brick anything is, two words a brick: written by AntiAlias and ClearBricks.</summary>
        public GraphicsBuffer BrickMatter { get; private set; }

        /// <summary>Distances, four cells along x to a texel.</summary>
        public RenderTexture Map { get; private set; }

        GraphicsBuffer Occupied { get; set; }

        GraphicsBuffer Planes { get; set; }

        public bool Exists => Map != null && IsThere(BrickMatter) && IsThere(Occupied) && IsThere(Planes);

        /// <summary>The bytes of a volume's skip structure.</summary>
        public static long BytesOf(int sizeI, int sizeJ, int sizeK) => 2 * sizeof(uint) * BrickGrid.CountOf(sizeI, sizeJ, sizeK)
            + sizeof(uint) * (long)Cells(sizeJ) * Cells(sizeK) * (Words(sizeI) + 2 * Texels(sizeI));

        /// <exception cref="Volumes.AnatomyCarveException">The device could not make it.</exception>
        public void Make()
        {
            BrickMatter = GpuObjects.CreateBuffer("AnatomyCarve matter of bricks", bricks.Count, 2 * sizeof(uint));
            Occupied = GpuObjects.CreateBuffer("AnatomyCarve occupied cells", Words(bricks.SizeI) * cellsY * cellsZ, sizeof(uint));
            Planes = GpuObjects.CreateBuffer("AnatomyCarve plane distances", Texels(bricks.SizeI) * cellsY * cellsZ, sizeof(uint));
            var descriptor = new RenderTextureDescriptor(Texels(bricks.SizeI), cellsY, GraphicsFormat.R32_UInt, 0)
            {
                dimension = TextureDimension.Tex3D,
                volumeDepth = cellsZ,
                enableRandomWrite = true,
                msaaSamples = 1,
            };
            Map = GpuObjects.CreateWritable(descriptor, "AnatomyCarve skip map", FilterMode.Point);
        }

        /// <summary>Makes the map's contents if the device has lost them; true where they have to be computed anew.</summary>
        public bool Restore()
        {
            if (Map.IsCreated())
                return false;
            GpuObjects.CreateOrThrow(Map);
            return true;
        }

        public void AddSizes(List<ResourceSize> sizes) => sizes.Add(new ResourceSize("AnatomyCarve skip structure", BytesOf(bricks.SizeI, bricks.SizeJ, bricks.SizeK)));

        /// <summary>Follows a change of the matter in bricks.</summary>
        /// <param name="dirty">The numbers of the bricks that AntiAlias wrote; null = all.</param>
        public void Update(IReadOnlyList<int> dirty, VolumeConstants constants, ref StageStatistics statistics)
        {
            VoxelBox box = dirty == null ? Whole : Grown(CellsOf(dirty), 1, 1, 1);
            using (Marker.Auto())
            {
                occupiedCells.SetBuffer(ShaderIds.BrickMatterIn, BrickMatter);
                occupiedCells.SetBuffer(ShaderIds.OccupiedCellsOut, Occupied);
                Dispatch(occupiedCells, box, CellsPerWord, constants, ref statistics);
                box = Grown(box, FarthestCell, FarthestCell, 0);
                planeDistances.SetBuffer(ShaderIds.OccupiedCells, Occupied);
                planeDistances.SetBuffer(ShaderIds.PlaneDistancesOut, Planes);
                Dispatch(planeDistances, box, CellsPerTexel, constants, ref statistics);
                box = Grown(box, 0, 0, FarthestCell);
                skipDistances.SetBuffer(ShaderIds.PlaneDistances, Planes);
                skipDistances.SetTexture(ShaderIds.SkipMapOut, Map);
                Dispatch(skipDistances, box, CellsPerTexel, constants, ref statistics);
            }
        }

        public void Dispose()
        {
            BrickMatter?.Release();
            Occupied?.Release();
            Planes?.Release();
            GpuObjects.Destroy(Map);
            BrickMatter = Occupied = Planes = null;
            Map = null;
        }

        void Dispatch(in ComputeKernel kernel, in VoxelBox box, int cellsPerUnit, VolumeConstants constants, ref StageStatistics statistics)
        {
            int firstX = box.MinI / cellsPerUnit;
            first[0] = firstX;
            first[1] = box.MinJ;
            first[2] = box.MinK;
            size[0] = box.MaxI / cellsPerUnit - firstX + 1;
            size[1] = box.MaxJ - box.MinJ + 1;
            size[2] = box.MaxK - box.MinK + 1;
            constants.Bind(kernel);
            kernel.Shader.SetInts(ShaderIds.SkipFirst, first);
            kernel.Shader.SetInts(ShaderIds.SkipSize, size);
            kernel.Dispatch(Groups(size[0]), Groups(size[1]), Groups(size[2]));
            statistics.Add(1, 0, (box.MaxI - box.MinI + 1L) * size[1] * size[2]);
        }

        VoxelBox Whole => new VoxelBox { MaxI = cellsX - 1, MaxJ = cellsY - 1, MaxK = cellsZ - 1 };

        /// <summary>The box of cells around bricks.</summary>
        VoxelBox CellsOf(IReadOnlyList<int> dirty)
        {
            var box = new VoxelBox { MinI = cellsX, MinJ = cellsY, MinK = cellsZ };
            for (int n = 0; n < dirty.Count; n++)
            {
                bricks.BrickAt(dirty[n], out int x, out int y, out int z);
                box.MinI = Math.Min(box.MinI, x * CellsPerBrick);
                box.MinJ = Math.Min(box.MinJ, y * CellsPerBrick);
                box.MinK = Math.Min(box.MinK, z * CellsPerBrick);
                box.MaxI = Math.Max(box.MaxI, x * CellsPerBrick + CellsPerBrick - 1);
                box.MaxJ = Math.Max(box.MaxJ, y * CellsPerBrick + CellsPerBrick - 1);
                box.MaxK = Math.Max(box.MaxK, z * CellsPerBrick + CellsPerBrick - 1);
            }
            return box;
        }

        /// <summary>A box that is larger on every side, as far as the volume goes.</summary>
        VoxelBox Grown(in VoxelBox box, int x, int y, int z) => new VoxelBox
        {
            MinI = Math.Max(box.MinI - x, 0), MinJ = Math.Max(box.MinJ - y, 0), MinK = Math.Max(box.MinK - z, 0),
            MaxI = Math.Min(box.MaxI + x, cellsX - 1), MaxJ = Math.Min(box.MaxJ + y, cellsY - 1), MaxK = Math.Min(box.MaxK + z, cellsZ - 1),
        };

        static int Cells(int voxels) => (voxels + CellSize - 1) / CellSize;

        static int Texels(int voxels) => (Cells(voxels) + CellsPerTexel - 1) / CellsPerTexel;

        static int Words(int voxels) => (Cells(voxels) + CellsPerWord - 1) / CellsPerWord;

        static int Groups(int units) => (units + GroupSize - 1) / GroupSize;

        static bool IsThere(GraphicsBuffer buffer) => buffer != null && buffer.IsValid();
    }
}
