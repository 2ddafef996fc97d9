#ifndef ANATOMYCARVE_RAYMARCH_INCLUDED
#define ANATOMYCARVE_RAYMARCH_INCLUDED

#include "SegmentLookup.hlsl"
#include "Shading.hlsl"
#include "SkipCells.hlsl"
#include "VolumeFields.hlsl"

// Direct volume rendering of one ray, front to back (Max, "Optical Models for Direct Volume Rendering", IEEE TVCG 1(2), 1995).
// No writes and no structured buffers here, so that a fragment shader can include it as well as a kernel.
//
// The ray's part inside the volume and [nearT, farT] is cut into steps of _March.x reference lengths from where it enters; the last step ends
// where the ray leaves. Each step is sampled in its middle: opacity a per reference length gives  alpha = 1 - (1 - a)^(length of the step in
// reference lengths).  Steps whose cell is empty add nothing and are not sampled; that changes no result.
//
// The first visible segment is where accumulated alpha reaches _March.z. In the step where it does so, and in the one before, alpha is accumulated
// anew in _Skip.y parts of a step each; within its part alpha grows as 1 - (1 - a)^length, which is solved for the length.

#ifndef PORTABLE_LAYOUT
SamplerState sampler_LinearClamp;
#endif
Texture3D<uint> _SkipMap; // distances to the nearest occupied cell, four cells along x to a texel (SkipDistances.compute)

static const float MAX_STEPS = 1048576.0; // so that no setting makes a ray endless
static const float NO_DEPTH = asfloat(0x7F800000); // +infinity

struct RayResult
{
    float4 color;  // linear, premultiplied by a = alpha
    float depthMm; // from the ray's origin to the first visible segment, along the ray; NO_DEPTH: none
    float enterMm; // likewise to the first matter, however translucent; NO_DEPTH where alpha is 0
    uint segment;  // NO_SEGMENT: none
    uint samples;  // opacity samples taken
    uint lookups;  // texels of the skip map read
};

float3 MmToIndexVector(float3 v)
{
    return float3(dot(_MmToIndex0.xyz, v), dot(_MmToIndex1.xyz, v), dot(_MmToIndex2.xyz, v));
}

// Opacity between voxels, from the eight around, in float and in the order of the CPU twin (x, then y, then z). Beyond the border the
// nearest repeat.
float ExactOpacityAt(float3 index)
{
    float3 corner = floor(index);
    float3 part = index - corner;
    int3 last = VolumeDims() - 1;
    int3 a = clamp(int3(corner), int3(0, 0, 0), last);
    int3 b = clamp(int3(corner) + 1, int3(0, 0, 0), last);
    float4 low = float4(OpacityAAOf(a), OpacityAAOf(int3(a.x, b.y, a.z)), OpacityAAOf(int3(a.xy, b.z)), OpacityAAOf(int3(a.x, b.yz)));
    float4 high = float4(OpacityAAOf(int3(b.x, a.yz)), OpacityAAOf(int3(b.xy, a.z)), OpacityAAOf(int3(b.x, a.y, b.z)), OpacityAAOf(b));
    float4 alongX = low + part.x * (high - low);
    float2 alongY = alongX.xz + part.y * (alongX.yw - alongX.xz);
    return alongY.x + part.z * (alongY.y - alongY.x);
}

// The texture filters of many devices have 8 bits of precision, in the weights or in the result: fast, but not quite what the CPU's pointer
// computes. Packed opacities cannot be filtered. The branch is the same for all rays.
float OpacityAt(float3 index)
{
#ifdef PORTABLE_LAYOUT
    return ExactOpacityAt(index);
#else
    float opacity;
    [branch]
    if (_March.w > 0.0)
        opacity = ExactOpacityAt(index);
    else
        opacity = _OpacityAA.SampleLevel(sampler_LinearClamp, (index + 0.5) / _VolumeDims.xyz, 0.0);
    return opacity;
#endif
}

// Narrows [nearT, farT] to the part of a ray (index space) inside the volume's box; false when nothing is left.
bool ClipToVolume(float3 start, float3 velocity, inout float nearT, inout float farT)
{
    float3 speed = abs(velocity);
    float slowest = 1e-9 * max(speed.x, max(speed.y, speed.z)); // axis-parallel rays: no division by 0, no 0 * infinity
    float3 divisor = float3(speed.x > slowest ? velocity.x : slowest, speed.y > slowest ? velocity.y : slowest, speed.z > slowest ? velocity.z : slowest);
    float3 toLow = (-0.5 - start) / divisor;
    float3 toHigh = (_VolumeDims.xyz - 0.5 - start) / divisor;
    float3 enter = min(toLow, toHigh), leave = max(toLow, toHigh);
    nearT = max(nearT, max(enter.x, max(enter.y, enter.z)));
    farT = min(farT, min(leave.x, min(leave.y, leave.z)));
    return farT > nearT;
}

// A ray in index space, by steps: step n begins at first + n * perStep.
struct StepRay
{
    float3 first;
    float3 perStep;
    float3 stepsPerVoxel; // 1 / perStep; huge for an axis along which the ray does not move
};

float OpacityOnRay(StepRay ray, float position) { return OpacityAt(ray.first + position * ray.perStep); }

// The first step whose middle may lie outside of the cells that are empty with the middle of step n, or of the cell itself if that is occupied.
uint StepBeyondCells(StepRay ray, uint n, float rayEnd, uint lastStep, out bool isEmpty)
{
    const float INSIDE = 1e-3; // voxels; more than rounding does
    int3 cells = CellDims();
    float middle = 0.5 * (float(n) + min(float(n) + 1.0, rayEnd)); // the last step may be a fraction
    int3 cell = clamp((int3)floor(ray.first + middle * ray.perStep), int3(0, 0, 0), VolumeDims() - 1) >> CELL_SHIFT;
    uint distance = (_SkipMap.Load(int4(cell.x >> TEXEL_SHIFT, cell.yz, 0)) >> (8u * ((uint)cell.x & (CELLS_PER_TEXEL - 1u)))) & 255u;
    isEmpty = distance > 0u;
    int reach = max((int)distance - 1, 0);
    int3 low = cell - reach, high = cell + 1 + reach;
    // What lies beyond the outermost voxels belongs to the outermost cells.
    float3 from = float3(low.x <= 0 ? -2.0 : low.x * CELL_SIZE + INSIDE, low.y <= 0 ? -2.0 : low.y * CELL_SIZE + INSIDE, low.z <= 0 ? -2.0 : low.z * CELL_SIZE + INSIDE);
    float3 to = float3(high.x >= cells.x ? cells.x * CELL_SIZE + 2.0 : high.x * CELL_SIZE - INSIDE,
        high.y >= cells.y ? cells.y * CELL_SIZE + 2.0 : high.y * CELL_SIZE - INSIDE, high.z >= cells.z ? cells.z * CELL_SIZE + 2.0 : high.z * CELL_SIZE - INSIDE);
    float3 leave = float3(ray.perStep.x < 0.0 ? from.x : to.x, ray.perStep.y < 0.0 ? from.y : to.y, ray.perStep.z < 0.0 ? from.z : to.z);
    float3 steps = (leave - ray.first) * ray.stepsPerVoxel;
    float beyond = ceil(min(steps.x, min(steps.y, steps.z)) - 0.5);
    return (uint)clamp(beyond, float(n + 1u), float(max(lastStep, n + 1u)));
}

// Where alpha, accumulated from position begin on (in steps) where it is alpha, reaches _March.z; -1 if it does not before end.
float FirstVisiblePosition(StepRay ray, float begin, float end, float alpha, inout uint samples)
{
    float wanted = log2((1.0 - _March.z) / (1.0 - alpha)); // the log of the light that is to pass
    float passing = 0.0;
    float position = -1.0;
    [loop]
    for (float from = begin; from < end; from += 1.0 / _Skip.y)
    {
        float to = min(from + 1.0 / _Skip.y, end);
        float opacity = OpacityOnRay(ray, 0.5 * (from + to));
        samples++;
        float here = opacity < 1.0 ? (to - from) * _March.x * log2(1.0 - opacity) : -1e30;
        if (passing + here <= wanted)
        {
            position = from + saturate((wanted - passing) / min(here, -1e-30)) * (to - from);
            break;
        }
        passing += here;
    }
    return position;
}

// origin, direction: centred mm; a point of the ray is origin + t * direction. toLight: unit vector, centred mm.
RayResult MarchRay(float3 origin, float3 direction, float nearT, float farT, float3 toLight)
{
    RayResult result;
    result.color = float4(0.0, 0.0, 0.0, 0.0);
    result.depthMm = NO_DEPTH;
    result.enterMm = NO_DEPTH;
    result.segment = NO_SEGMENT;
    result.samples = 0u;
    result.lookups = 0u;
    float mmPerT = length(direction);
    float3 velocity = MmToIndexVector(direction);
    float3 start = MmToIndexVector(origin) + _CentreIndex.xyz;
    if (mmPerT > 0.0 && ClipToVolume(start, velocity, nearT, farT))
    {
        float3 toViewer = -direction / mmPerT;
        float stepT = _March.x * _CentreIndex.w / mmPerT;
        float steps = min((farT - nearT) / stepT, MAX_STEPS); // the last one may be a fraction
        uint stepCount = (uint)ceil(steps);
        StepRay ray;
        ray.first = start + nearT * velocity;
        ray.perStep = stepT * velocity;
        ray.stepsPerVoxel = float3(abs(ray.perStep.x) > 1e-20 ? 1.0 / ray.perStep.x : 1e20, abs(ray.perStep.y) > 1e-20 ? 1.0 / ray.perStep.y : 1e20,
            abs(ray.perStep.z) > 1e-20 ? 1.0 / ray.perStep.z : 1e20);
        int3 lookedUp = int3(-2, -2, -2); // the corner whose segment is known: no ray gets there
        uint segment = NO_SEGMENT;
        float3 segmentColor = float3(0.0, 0.0, 0.0);
        bool isBorder = false; // whether other segments are at the corner as well
        bool seen = false;
        float visibleAt = 0.0;  // in steps
        uint visibleSegment = NO_SEGMENT; // that of the sample there
        float beforeLast = 0.0; // alpha before the last step but one
        float logThrough = 0.0; // of the light that has passed so far: weights are differences of its powers, so that rounding does not add up
        uint lastShaded = stepCount;
        uint sampleUntil = _Skip.x > 0.0 ? 0u : stepCount; // in occupied cells up to here
        uint n = 0u;
        [loop]
        while (n < stepCount && result.color.a < _March.y)
        {
            float opacity = 0.0, begin = 0.0, end = 0.0;
            [loop]
            while (n < stepCount && opacity == 0.0) // on to the next step with something in it
            {
                [loop]
                while (n >= sampleUntil && n < stepCount)
                {
                    bool isEmpty;
                    sampleUntil = StepBeyondCells(ray, n, steps, stepCount, isEmpty);
                    n = isEmpty ? sampleUntil : n;
                    result.lookups++;
                }
                if (n < stepCount)
                {
                    begin = float(n);
                    end = min(begin + 1.0, steps);
                    opacity = OpacityOnRay(ray, 0.5 * (begin + end));
                    result.samples++;
                    n++;
                }
            }
            if (opacity > 0.0)
            {
                float3 index = ray.first + 0.5 * (begin + end) * ray.perStep;
                int3 corner = int3(floor(index));
                if (any(corner != lookedUp))
                {
                    lookedUp = corner;
                    segment = SegmentOfEight(corner, isBorder);
                    segmentColor = SegmentColor(segment);
                }
                uint shown = segment;
                float3 base = segmentColor;
                [branch]
                if (segment == NO_SEGMENT) // anti-aliasing alone put something here
                {
                    bool ignored;
                    shown = SegmentOfEight(int3(floor(index + ray.perStep / _March.x)), ignored);
                    [branch]
                    if (shown == NO_SEGMENT)
                        shown = SegmentAround(corner);
                    base = SegmentColor(shown);
                }
                float before = result.color.a;
                if (before == 0.0)
                    result.enterMm = (nearT + begin * stepT) * mmPerT;
                if (lastShaded + 2u != n)
                    beforeLast = before; // the step before was empty
                float lengths = (end - begin) * _March.x; // of the step, in reference lengths
                logThrough += lengths * log2(max(1.0 - opacity, 1e-30));
                float after = opacity < 1.0 ? 1.0 - exp2(logThrough) : 1.0; // matter of opacity 1 stops all light, however short the step
                float weight = max(after - before, 0.0);
                [branch]
                if (isBorder)
                    base = BorderColor(index, segmentColor);
                result.color.rgb += weight * BlinnPhong(base, BlendedNormal(index), toViewer, toLight);
                result.color.a = after;
                if (!seen && result.color.a >= _March.z)
                {
                    visibleSegment = shown;
                    visibleAt = begin; // where an earlier step should have shown it and did not, quite
                    if (beforeLast < _March.z)
                        visibleAt = FirstVisiblePosition(ray, max(begin - 1.0, 0.0), end, beforeLast, result.samples);
                    seen = visibleAt >= 0.0; // else a later step is to show it, or what is left of the ray does not
                    visibleAt = seen ? visibleAt : end;
                }
                beforeLast = before;
                lastShaded = n - 1u;
            }
        }
        if (result.color.a >= _March.z)
        {
            uint there = SegmentAround(int3(floor(ray.first + visibleAt * ray.perStep)));
            result.segment = there != NO_SEGMENT ? there : visibleSegment;
            result.depthMm = (nearT + visibleAt * stepT) * mmPerT;
        }
    }
    return result;
}

#endif
