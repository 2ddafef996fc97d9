#ifndef ANATOMYCARVE_SKIP_CELLS_INCLUDED
#define ANATOMYCARVE_SKIP_CELLS_INCLUDED

#include "VolumeLayout.hlsl"

// Cells of 4x4x4 voxels, the unit in which rays skip empty space. A place in index space is in the cell of the voxel that its coordinates round down to; it is
// sampled from that voxel and the next along each axis. So a cell is occupied if one of its voxels, or of the voxels one beyond its upper faces, is above 0.
//
// A brick has 2x2x2 cells. What AntiAlias writes of each: a byte whose bits say whether a voxel above 0 lies anywhere in the cell (bit 0), in its lowest
// layer along x (1), y (2), z (3), in two of these at once: xy (4), xz (5), yz (6), or in all three (7). The cells below read those.

#define CELL_SIZE 4
#define CELL_SHIFT 2 // its logarithm
#define FARTHEST_CELL 7 // distances in cells are cut off here: the longer they are, the more of them an edit changes
#define CELLS_PER_TEXEL 4
#define TEXEL_SHIFT 2

// Where a cell's byte lies in its brick's two words: word = z, bits 8 * (x + 2 * y) and up. cell: 0 or 1 per axis.
uint CellShift(uint2 cell) { return 8u * (cell.x + 2u * cell.y); }

// The bits that a voxel above 0 sets in word offset.z / 4 of its brick.
uint CellMatter(uint3 offset)
{
    bool3 lowest = (offset & (CELL_SIZE - 1u)) == 0u;
    uint bits = 1u | (lowest.x ? 2u : 0u) | (lowest.y ? 4u : 0u) | (lowest.z ? 8u : 0u)
        | (lowest.x && lowest.y ? 16u : 0u) | (lowest.x && lowest.z ? 32u : 0u) | (lowest.y && lowest.z ? 64u : 0u)
        | (lowest.x && lowest.y && lowest.z ? 128u : 0u);
    return bits << CellShift(offset.xy >> CELL_SHIFT);
}

// Cells per axis of the volume.
int3 CellDims() { return (VolumeDims() + CELL_SIZE - 1) >> CELL_SHIFT; }

#endif
