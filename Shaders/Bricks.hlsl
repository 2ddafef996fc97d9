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

// First voxel of the group's brick.
int3 BrickOrigin(uint3 group)
{
    uint packed = _Bricks[group.x + group.y * (uint)_BrickGrid.w];
    return int3(packed & 1023u, (packed >> 10) & 1023u, (packed >> 20) & 1023u) * BRICK_SIZE;
}

#endif
