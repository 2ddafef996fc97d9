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
    StoredBox box = StoredVoxels();
    int3 stored = column + int3(0, 0, z) - box.first;
#ifdef PORTABLE_LAYOUT
    if (IsStored(box, stored))
        texel |= (uint)round(saturate(opacity) * 255.0) << (8u * (z & 3u));
    if ((z & 3u) == 3u)
    {
        if (IsStored(box, stored - int3(0, 0, 3)))
            OPACITY_TARGET[int3(stored.xy, stored.z >> 2)] = texel;
        texel = 0u;
    }
#else
    if (IsStored(box, stored))
        OPACITY_TARGET[stored] = opacity;
#endif
}

#endif
