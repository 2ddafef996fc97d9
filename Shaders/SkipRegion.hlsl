#ifndef ANATOMYCARVE_SKIP_REGION_INCLUDED
#define ANATOMYCARVE_SKIP_REGION_INCLUDED

#include "SkipCells.hlsl"

// What the kernels of the skip structure share: the box of cells that is computed anew. Three steps lead from bricks' matter to distances; each reads the one
// before within FARTHEST_CELL cells of its own cells.

cbuffer SkipRegion
{
    int4 _SkipFirst; // xyz: first unit of the dispatch: x in words of 32 cells (OccupiedCells) or texels of 4 cells, y and z in cells
    int4 _SkipSize;  // xyz: units per axis
};

// False for threads beyond the box. unit: x in words or texels, y and z in cells.
bool HasUnit(uint3 thread, out int3 unit)
{
    unit = _SkipFirst.xyz + int3(thread);
    return all(int3(thread) < _SkipSize.xyz);
}

int WordsPerRow() { return (CellDims().x + 31) >> 5; }
int TexelsPerRow() { return (CellDims().x + CELLS_PER_TEXEL - 1) >> TEXEL_SHIFT; }

#endif
