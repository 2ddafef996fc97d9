#ifndef ANATOMYCARVE_VOLUME_FIELDS_INCLUDED
#define ANATOMYCARVE_VOLUME_FIELDS_INCLUDED

#include "VolumeLayout.hlsl"

// What the kernels compute for each voxel, and how it lies in textures. Numbers and pictures are the same in both layouts.
//
// Of which voxels: StoredAt (VolumeLayout.hlsl).
//
//   compact:  opacity R8_UNorm, anti-aliased opacity R8_UNorm, normal R8G8_UNorm
//   portable: the same bytes packed along k into R32_UInt, which every device can write: four opacities to a texel (voxel k in bits
//             8 * (k % 4) and up), two normals (bits 16 * (k % 2) and up, the first code in the lower byte)

#ifdef PORTABLE_LAYOUT
Texture3D<uint> _Opacity;
Texture3D<uint> _OpacityAA;
Texture3D<uint> _Normals;
#else
Texture3D<float> _Opacity;
Texture3D<float> _OpacityAA;
Texture3D<float2> _Normals;
#endif

// A byte of a packed texel as the UNorm number that it stands for.
float UnpackUNorm(uint texel, int k)
{
    return float((texel >> (8u * ((uint)k & 3u))) & 255u) / 255.0;
}

// Opacity before anti-aliasing, per reference length.
float OpacityOf(int3 stored)
{
#ifdef PORTABLE_LAYOUT
    return UnpackUNorm(_Opacity.Load(int4(stored.xy, stored.z >> 2, 0)), stored.z);
#else
    return _Opacity.Load(int4(stored, 0));
#endif
}

// The same as it is stored, 0..255.
uint OpacityCodeOf(int3 stored)
{
#ifdef PORTABLE_LAYOUT
    return (_Opacity.Load(int4(stored.xy, stored.z >> 2, 0)) >> (8u * ((uint)stored.z & 3u))) & 255u;
#else
    return (uint)(_Opacity.Load(int4(stored, 0)) * 255.0 + 0.5);
#endif
}

float OpacityAAOf(int3 stored)
{
#ifdef PORTABLE_LAYOUT
    return UnpackUNorm(_OpacityAA.Load(int4(stored.xy, stored.z >> 2, 0)), stored.z);
#else
    return _OpacityAA.Load(int4(stored, 0));
#endif
}

// The two codes of a normal, 0..255 each (Octahedral.hlsl).
float2 NormalCodeOf(int3 stored)
{
#ifdef PORTABLE_LAYOUT
    uint texel = _Normals.Load(int4(stored.xy, stored.z >> 1, 0)) >> (16u * ((uint)stored.z & 1u));
    return float2(texel & 255u, (texel >> 8) & 255u);
#else
    return floor(_Normals.Load(int4(stored, 0)) * 255.0 + 0.5);
#endif
}

#endif
