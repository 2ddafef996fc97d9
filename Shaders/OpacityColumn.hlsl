#ifndef ANATOMYCARVE_OPACITY_COLUMN_INCLUDED
#define ANATOMYCARVE_OPACITY_COLUMN_INCLUDED

#include "VolumeLayout.hlsl"

// Writes opacities in either layout (VolumeFields.hlsl). Before the include, OPACITY_TARGET is defined as the texture's name.

#ifdef PORTABLE_LAYOUT
RWTexture3D<uint> OPACITY_TARGET;
#else
RWTexture3D<unorm float> OPACITY_TARGET;
#endif

// Called for z = 0..7 of a brick's column in this order, by one thread; voxels beyond the volume are left out. texel: 0 at first.
void StoreOpacity(int3 column, uint z, float opacity, inout uint texel)
{
    int3 voxel = column + int3(0, 0, z);
#ifdef PORTABLE_LAYOUT
    if (IsInVolume(voxel))
        texel |= (uint)round(saturate(opacity) * 255.0) << (8u * (z & 3u));
    if ((z & 3u) == 3u)
    {
        if (IsInVolume(voxel - int3(0, 0, 3)))
            OPACITY_TARGET[int3(voxel.xy, voxel.z >> 2)] = texel;
        texel = 0u;
    }
#else
    if (IsInVolume(voxel))
        OPACITY_TARGET[voxel] = opacity;
#endif
}

#endif
