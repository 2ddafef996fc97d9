#ifndef ANATOMYCARVE_BRICKS_INCLUDED
#define ANATOMYCARVE_BRICKS_INCLUDED

#include "VolumeLayout.hlsl"

// Which brick a group of threads works on: the kernels of the volume run over a list of bricks, all of them or only those that an edit
// touched.

StructuredBuffer<uint> _Bricks; // brick coordinates, x | y << 10 | z << 20; _VolumeDims.w of them

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
    uint packed = _Bricks[ListedBrick(group)];
    return int3(packed & 1023u, (packed >> 10) & 1023u, (packed >> 20) & 1023u) * BRICK_SIZE;
}

// The brick's number among all of the volume, x fastest.
uint BrickNumber(int3 origin)
{
    uint3 brick = (uint3)origin / BRICK_SIZE;
    return brick.x + (uint)_BrickGrid.x * (brick.y + (uint)_BrickGrid.y * brick.z);
}

#endif
