#ifndef ANATOMYCARVE_VOLUME_LAYOUT_INCLUDED
#define ANATOMYCARVE_VOLUME_LAYOUT_INCLUDED

// Limits and memory layouts that the kernels share with C# (Runtime/Rendering); a test compares them. Only rows of 16 bytes,
// because Direct3D and Vulkan pack anything smaller differently.
//
// Spaces. "Index": voxel (i, j, k) has its centre at (i, j, k); the volume fills [-0.5, dims - 0.5]. "Centred mm": LPS millimetres
// relative to the volume's centre, p = M * (index - (dims - 1) / 2). M holds spacing, rotation and shear.

#define BRICK_SIZE 8        // voxels per axis of a brick; a group of 8x8x1 threads works on one, each thread on a column along z
#define GROUP_SIZE 8        // threads per axis of a group, x and y
#define GROUP_THREADS 64
#define SEGMENTS_PER_ROW 1024 // texels per row of _SegmentColors

// One clip sphere; stride 32.
struct SphereRow
{
    float4 centreRadius; // xyz: centre in centred mm; w: radius in mm (0: clips nothing)
    uint4 mask;          // x: index of the mask's first word in _MaskWords; bit s of the mask = this sphere clips segment s; yzw: its first three words
};

// Whole numbers too are floats here: a material, unlike a compute shader, has no rows of integers. They stay below 2^24, so they are exact.
cbuffer CarvedVolume
{
    float4 _VolumeDims;        // xyz: voxels per axis; w: bricks in _Bricks
    float4 _BrickGrid;         // xyz: bricks per axis; w: groups per row of the dispatch
    float4 _IndexToMm0;        // xyz: row 0 of M, mm per voxel
    float4 _IndexToMm1;
    float4 _IndexToMm2;
    float4 _MmToIndex0;        // xyz: row 0 of M's inverse, voxels per mm
    float4 _MmToIndex1;
    float4 _MmToIndex2;
    float4 _StoredFirst;       // xyz: the first voxel of the box that the kernels' opacities and normals are stored of; a brick begins there
    float4 _StoredLast;        // xyz: its last voxel, counted from the first
    float4 _CentreIndex;       // xyz: (dims - 1) / 2; w: reference length = the smallest spacing, mm
    float4 _IntensityToLookup; // texel of the transfer function = saturate(code * x + y) * z; z = texels - 1
    float4 _CarveCounts;       // x: spheres; y: words per mask; z: segments; w: cut mode, 0 = binary, 1 = smooth
    float4 _AntiAlias;         // x: absolute, y: relative contrast threshold; z: smallest gradient; w: strength, 0..1
};

// What all rays of a picture have in common.
cbuffer RaymarchSettings
{
    float4 _Skip;              // x: 1 = rays skip cells that are empty (SkipCells.hlsl); y: parts into which a step is cut to find the first visible point
    float4 _March;             // x: step in reference lengths; y: alpha at which a ray ends; z: alpha that makes a segment visible; w: 1 = exact filter
    float4 _LightDirection;    // xyz: unit vector towards the light; Raymarch: centred mm; CarvedVolume: x right, y up, z towards the viewer
    float4 _LightColor;        // rgb: linear
    float4 _Shading;           // x: ambient; y: diffuse; z: specular; w: shininess
};

int3 VolumeDims() { return int3(_VolumeDims.xyz); }
uint SegmentCount() { return (uint)_CarveCounts.z; }
bool IsSmoothCut() { return _CarveCounts.w > 0.5; }

int3 ClampToVolume(int3 voxel)
{
    return clamp(voxel, int3(0, 0, 0), VolumeDims() - 1);
}

bool IsInVolume(int3 voxel)
{
    return all(voxel >= 0) && all(voxel < VolumeDims());
}

// Opacities and normals are stored of a box of bricks: of all in which anything is visible before carving, and of those around them. Beyond it everything is 0,
// and so is its outermost layer, but for where it ends with the volume. So the nearest stored voxel stands for all that are not stored, and for what lies beyond the
// volume.

struct StoredBox
{
    int3 first; // voxel
    int3 last;  // from the first
};

// Loops take it from before the loop: constants are not always free to read.
StoredBox StoredVoxels()
{
    StoredBox box;
    box.first = int3(_StoredFirst.xyz);
    box.last = int3(_StoredLast.xyz);
    return box;
}

// Where in the box the nearest to a voxel lies: its place in the textures, but for packing.
int3 StoredAt(StoredBox box, int3 voxel) { return clamp(voxel - box.first, int3(0, 0, 0), box.last); }

// Whether a voxel's own place is in the textures; stored: voxel - first.
bool IsStored(StoredBox box, int3 stored) { return all(stored >= 0) && all(stored <= box.last); }

#endif
