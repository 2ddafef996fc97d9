#ifndef ANATOMYCARVE_BRICKS_INCLUDED
#define ANATOMYCARVE_BRICKS_INCLUDED

#include "VolumeLayout.hlsl"

// Which brick a group of threads works on, and which of its voxels: the kernels of the volume run over a list of bricks, all of them or only those that an edit
// touched. A part of a brick is, of each quarter of its columns (4x4 of them), what lies between two z: whole steps of OPACITY_STEP voxels, because a texel of the
// portable layout holds so many opacities and a cell of the skip structure is so long; of NORMALS_STEP for normals.

#define OPACITY_STEP 4
#define NORMALS_STEP 2
#define QUARTER_SIZE 4 // columns along x and y
#define QUARTERS 4     // x half + 2 * y half

StructuredBuffer<uint2> _Bricks; // _VolumeDims.w bricks: x: coordinates, x | y << 10 | z << 20; y: part, 8 bits a quarter: the first z, and the end << 4

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

// The column that a thread works on. Threads of a quarter are neighbours, so that those without work are so together.
uint2 ColumnOf(uint threadIndex)
{
    return uint2((threadIndex & 3u) | ((threadIndex >> 2) & 4u), ((threadIndex >> 2) & 3u) | ((threadIndex >> 3) & 4u));
}

// A quarter's first z and end; both 0 for nothing.
uint2 RangeOf(uint part, uint quarter)
{
    uint bits = part >> (8u * quarter);
    return uint2(bits & 15u, (bits >> 4) & 15u);
}

// A column's first z and end.
uint2 ColumnRange(uint part, uint threadIndex) { return RangeOf(part, threadIndex / (QUARTER_SIZE * QUARTER_SIZE)); }

// The box around all that belongs to a part.
void PartBox(uint part, out uint3 first, out uint3 end)
{
    first = uint3(BRICK_SIZE, BRICK_SIZE, BRICK_SIZE);
    end = uint3(0u, 0u, 0u);
    [unroll]
    for (uint quarter = 0u; quarter < QUARTERS; quarter++)
    {
        uint2 range = RangeOf(part, quarter);
        uint3 low = uint3(QUARTER_SIZE * (quarter & 1u), QUARTER_SIZE * (quarter >> 1), range.x);
        if (range.y > range.x)
        {
            first = min(first, low);
            end = max(end, uint3(low.xy + QUARTER_SIZE, range.y));
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
