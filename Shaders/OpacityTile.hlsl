#ifndef ANATOMYCARVE_OPACITY_TILE_INCLUDED
#define ANATOMYCARVE_OPACITY_TILE_INCLUDED

#include "Bricks.hlsl"
#include "VolumeFields.hlsl"

// A brick's opacities with one voxel around, in memory that the group shares, and the 3x3x3 Sobel operator on it. Before the include,
// TILE_OPACITY is defined as the function that reads a voxel's opacity.

#define TILE_SIZE (BRICK_SIZE + 2)
#define TILE_VOXELS (TILE_SIZE * TILE_SIZE * TILE_SIZE)
#define PLANE 9
#define NEIGHBOURHOOD 27 // i fastest; 13 is the voxel itself

// Gradients below this are none, but for rounding: half of the smallest that 8-bit opacities can have, 1 / (255 * 32).
static const float NO_GRADIENT = 0.5 / (255.0 * 32.0);

groupshared float OpacityTile[TILE_VOXELS];

// Called by all threads of a group, before a barrier. Voxels outside the volume get outsideFactor times the nearest voxel inside:
// 1 continues the volume, 0 ends it.
void FillOpacityTile(int3 brickOrigin, uint threadIndex, float outsideFactor)
{
    for (uint cell = threadIndex; cell < TILE_VOXELS; cell += GROUP_THREADS)
    {
        uint3 offset = uint3(cell % TILE_SIZE, (cell / TILE_SIZE) % TILE_SIZE, cell / (TILE_SIZE * TILE_SIZE));
        int3 voxel = brickOrigin + int3(offset) - 1;
        float opacity = TILE_OPACITY(ClampToVolume(voxel));
        OpacityTile[cell] = IsInVolume(voxel) ? opacity : opacity * outsideFactor;
    }
}

// The 3x3 opacities around a column of the brick (offset 0..7 per axis) in a plane of the tile (0..9), i fastest.
void ReadPlane(uint2 offset, uint plane, out float o[PLANE])
{
    uint first = offset.x + TILE_SIZE * (offset.y + TILE_SIZE * plane);
    [unroll]
    for (uint n = 0u; n < PLANE; n++)
        o[n] = OpacityTile[first + n % 3u + TILE_SIZE * (n / 3u)];
}

// Three-dimensional Sobel gradient, opacity per voxel: [1 2 1] x [1 2 1] x [-1 0 1] / 32. Differences come first, so equal values on
// both sides give exactly 0.
float3 SobelGradient(float o[NEIGHBOURHOOD])
{
    const uint3 strides = uint3(1u, 3u, 9u);
    float3 gradient = float3(0.0, 0.0, 0.0);
    [unroll]
    for (uint axis = 0u; axis < 3u; axis++)
    {
        uint along = strides[axis], u = strides[(axis + 1u) % 3u], v = strides[(axis + 2u) % 3u];
        float sum = 0.0;
        [unroll]
        for (uint n = 0u; n < 9u; n++)
        {
            uint a = n % 3u, b = n / 3u;
            float weight = (a == 1u ? 2.0 : 1.0) * (b == 1u ? 2.0 : 1.0);
            uint low = a * u + b * v;
            sum += weight * (o[low + 2u * along] - o[low]);
        }
        gradient[axis] = sum / 32.0;
    }
    return gradient;
}

#endif
