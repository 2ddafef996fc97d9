#ifndef ANATOMYCARVE_BRICKS_INCLUDED
#define ANATOMYCARVE_BRICKS_INCLUDED

#include "VolumeLayout.hlsl"

// Which brick a group of threads works on, and which of its voxels: the kernels of the volume run over a list of bricks, all of them or only those that an edit
// touched. A part of a brick is, of each strip of its columns (4x2 of them), what lies between two z: whole steps of NORMALS_STEP voxels, as a texel of the portable
// layout holds so many normals. Parts of opacities are whole blocks of OPACITY_STEP voxels along each axis: cells of the skip structure.

#define OPACITY_STEP 4
#define NORMALS_STEP 2
#define STRIP_COLUMNS 4 // along x
#define STRIP_ROWS 2    // along y
#define STRIPS 8        // upper rows of a quarter + 2 * x half + 4 * y half

StructuredBuffer<uint2> _Bricks; // _VolumeDims.w bricks: x: coordinates, x | y << 10 | z << 20; y: part, 4 bits a strip (RangeOf)

// False for the groups that pad the last row of the dispatch. Uniform over the group, so a kernel may return on it before a barrier.
bool GroupHasBrick(uint3 group)
{
    return group.x < (uint)_BrickGrid.w && group.x + group.y * (uint)_BrickGrid.w < (uint)_VolumeDims.w;
}

// The group's place in the list.
uint ListedBrick(uint3 group) { return group.x + group.y * (uint)_BrickGrid.w; }

// First voxel of the group's brick.
int3 BrickOrigin(uint3 group)
{
    uint packed = _Bricks[ListedBrick(group)].x;
    return int3(packed & 1023u, (packed >> 10) & 1023u, (packed >> 20) & 1023u) * BRICK_SIZE;
}

uint BrickPart(uint3 group) { return _Bricks[ListedBrick(group)].y; }

// The column that a thread works on. Threads of a strip are neighbours, and those of the strip beside it, so that those without work are so together.
uint2 ColumnOf(uint threadIndex)
{
    return uint2((threadIndex & 3u) | ((threadIndex >> 2) & 4u), ((threadIndex >> 2) & 3u) | ((threadIndex >> 3) & 4u));
}

// A strip's first z and end, in steps: 3 less the lower two bits, and 1 more than the upper two; so all bits 0 are nothing (the end lies before the first), all 1
// everything.
uint2 RangeOf(uint part, uint strip)
{
    uint bits = part >> (4u * strip);
    return NORMALS_STEP * uint2(3u - (bits & 3u), 1u + ((bits >> 2) & 3u));
}

// A strip's first column.
uint2 StripOrigin(uint strip) { return uint2(STRIP_COLUMNS * ((strip >> 1) & 1u), STRIP_ROWS * ((strip & 1u) | ((strip >> 1) & 2u))); }

// A column's first z and end.
uint2 ColumnRange(uint part, uint threadIndex) { return RangeOf(part, threadIndex / (STRIP_COLUMNS * STRIP_ROWS)); }

// The box around all that belongs to a part.
void PartBox(uint part, out uint3 first, out uint3 end)
{
    first = uint3(BRICK_SIZE, BRICK_SIZE, BRICK_SIZE);
    end = uint3(0u, 0u, 0u);
    [unroll]
    for (uint strip = 0u; strip < STRIPS; strip++)
    {
        uint2 range = RangeOf(part, strip);
        uint3 low = uint3(StripOrigin(strip), range.x);
        if (range.y > range.x)
        {
            first = min(first, low);
            end = max(end, uint3(low.xy + uint2(STRIP_COLUMNS, STRIP_ROWS), range.y));
        }
    }
}

// The brick's number among all of the volume, x fastest.
uint BrickNumber(int3 origin)
{
    uint3 brick = (uint3)origin / BRICK_SIZE;
    return brick.x + (uint)_BrickGrid.x * (brick.y + (uint)_BrickGrid.y * brick.z);
}

#endif
