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
// Light changes more slowly along a ray than opacity: steps of half a reference length or less are shaded in pairs, an even one and the next, once at the mean
// place of the two, each weighing by the alpha that it adds. That is of second order, as the steps are; and because the pairs are the same on all rays, what is
// seen stays continuous from pixel to pixel. What adds less than SHADED_WEIGHT is shaded with what follows within MOST_SHADED steps. Nothing is shaded together
// with what lies behind SHADED_ALPHA, so that whether rays end there changes next to nothing.
//
// The first visible segment is where accumulated alpha reaches _March.z. From the beginning of the step before the one where it does so, alpha is accumulated
// anew in _Skip.y parts of a step each; within its part alpha grows as 1 - (1 - a)^length, which is solved for the length. Where alpha comes near the threshold
// (NEARLY of it) and reaches it neither with this step nor the next, as on rays that graze a surface, the parts begin where this matter begins (if that is within
// FURTHER_STEPS): so the finer sum alone decides whether the threshold is reached here or on a surface behind. What the steps reach and the parts do not within
// FURTHER_STEPS is taken to be at the end of the step.
//
// Voxels and filters make a ramp of an edge, and alpha reaches the threshold only far up it. The depth is that of the edge: where on the way to the first visible
// point opacity last rises through half of the matter's own (its highest from where alpha comes near the threshold to PLATEAU behind, as far as SHADED_ALPHA), and
// from there as far as this opacity needs to reach the threshold; at most EDGE_REACH before that point. Without an edge there it is that point's.

#ifndef PORTABLE_LAYOUT
SamplerState sampler_LinearClamp;
#endif
Texture3D<uint> _SkipMap; // distances to the nearest occupied cell, four cells along x to a texel (SkipDistances.compute)

static const float MAX_STEPS = 1048576.0; // so that no setting makes a ray endless
static const float NO_DEPTH = asfloat(0x7F800000); // +infinity
static const float SHADED_WEIGHT = 1.0 / 128.0, SHADED_ALPHA = 1.0 - 1.0 / 512.0;
static const uint MOST_SHADED = 7u;
static const float NEARLY = 0.9, FURTHER_STEPS = 32.0; // steps
static const float EDGE_REACH = 0.5, PLATEAU = 2.5; // reference lengths
static const float ONE_CODE = 1.0 / 255.0; // opacities nearer to 1 are taken to stop all light, the nearer the more so

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
float ExactOpacityAt(StoredBox box, float3 index)
{
    float3 corner = floor(index);
    float3 part = index - corner;
    int3 a = StoredAt(box, int3(corner));
    int3 b = StoredAt(box, int3(corner) + 1);
    float4 low = float4(OpacityAAOf(a), OpacityAAOf(int3(a.x, b.y, a.z)), OpacityAAOf(int3(a.xy, b.z)), OpacityAAOf(int3(a.x, b.yz)));
    float4 high = float4(OpacityAAOf(int3(b.x, a.yz)), OpacityAAOf(int3(b.xy, a.z)), OpacityAAOf(int3(b.x, a.y, b.z)), OpacityAAOf(b));
    float4 alongX = low + part.x * (high - low);
    float2 alongY = alongX.xz + part.y * (alongX.yw - alongX.xz);
    return alongY.x + part.z * (alongY.y - alongY.x);
}

// The texture filters of many devices have 8 bits of precision, in the weights or in the result: fast, but not quite what the CPU's pointer
// computes. Packed opacities cannot be filtered. The branch is the same for all rays.
float OpacityAt(StoredBox box, float3 index)
{
#ifdef PORTABLE_LAYOUT
    return ExactOpacityAt(box, index);
#else
    float opacity;
    [branch]
    if (_March.w > 0.0)
        opacity = ExactOpacityAt(box, index);
    else
        opacity = _OpacityAA.SampleLevel(sampler_LinearClamp, (index - _StoredFirst.xyz + 0.5) / (_StoredLast.xyz + 1.0), 0.0);
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
    float3 isBackwards;   // 1 for axes along which the index falls, else 0
    StoredBox box;
};

float OpacityOnRay(StepRay ray, float position) { return OpacityAt(ray.box, ray.first + position * ray.perStep); }

// The first step whose middle may lie outside of the cells that are empty with the middle of step n, or of the cell itself if that is occupied.
uint StepBeyondCells(StepRay ray, uint n, float rayEnd, uint lastStep, out bool isEmpty)
{
    const float INSIDE = 1e-3; // voxels; more than rounding does
    float middle = 0.5 * (float(n) + min(float(n) + 1.0, rayEnd)); // the last step may be a fraction
    float3 cell = clamp(floor((ray.first + middle * ray.perStep) / CELL_SIZE), 0.0, float3(CellDims() - 1));
    uint3 texel = (uint3)cell;
    uint distance = (_SkipMap.Load(int4(texel.x >> TEXEL_SHIFT, texel.yz, 0)) >> (8u * (texel.x & (CELLS_PER_TEXEL - 1u)))) & 255u;
    isEmpty = distance > 0u;
    float reach = max(float(distance), 1.0) - 1.0;
    // Where the ray leaves along each axis. The first cells begin below the first voxels' centres.
    float3 leave = (cell + lerp(1.0 + reach, -reach, ray.isBackwards)) * CELL_SIZE;
    leave += float3(ray.isBackwards.x == 0.0 ? -INSIDE : leave.x <= 0.0 ? -CELL_SIZE : INSIDE, ray.isBackwards.y == 0.0 ? -INSIDE : leave.y <= 0.0 ? -CELL_SIZE : INSIDE,
        ray.isBackwards.z == 0.0 ? -INSIDE : leave.z <= 0.0 ? -CELL_SIZE : INSIDE);
    float3 steps = (leave - ray.first) * ray.stepsPerVoxel;
    float beyond = ceil(min(steps.x, min(steps.y, steps.z)) - 0.5);
    return (uint)clamp(beyond, float(n + 1u), float(max(lastStep, n + 1u)));
}

// Where alpha, accumulated from position begin on (in steps) where it is alpha, reaches _March.z, and the middle of the part in which it does; position -1 if
// it does not before end. edge: where opacity last rises to level before that; -1 where it is lower there. It is looked for from half a step less than EDGE_REACH
// before begin on, as the position is half a step and more behind begin but for odd rays; where opacity never is lower, that is the edge.
float FirstVisiblePosition(StepRay ray, float begin, float end, float alpha, float level, out float edge, inout float middle, inout uint samples)
{
    float wanted = log2((1.0 - _March.z) / (1.0 - alpha)); // the log of the light that is to pass
    float passing = 0.0;
    float position = -1.0;
    float earlier = 0.0, earlierMiddle = 0.0; // opacity of the part before, and where it was sampled
    float first = max(begin + 0.5 - max(ceil(EDGE_REACH / _March.x), 1.0), 0.0);
    edge = first;
    [loop]
    for (float from = first; from < end; from += 1.0 / _Skip.y)
    {
        float to = min(from + 1.0 / _Skip.y, end), here = 0.5 * (from + to);
        float opacity = OpacityOnRay(ray, here);
        samples++;
        float rise = here - (opacity - level) / max(opacity - earlier, 1e-6) * (here - earlierMiddle);
        edge = opacity < level ? -1.0 : edge < 0.0 ? rise : edge;
        earlier = opacity;
        earlierMiddle = here;
        float passed = from < begin ? 0.0 : opacity < 1.0 ? (to - from) * _March.x * log2(1.0 - opacity) : -1e30;
        if (from >= begin && passing + passed <= wanted)
        {
            position = from + saturate((wanted - passing) / min(passed, -1e-30)) * (to - from);
            middle = here;
            break;
        }
        passing += passed;
    }
    return position;
}

// Colour of matter at a place between voxels.
float3 ShadedColor(StoredBox box, float3 index, float3 lengthAhead, float3 toViewer, float3 toLight)
{
    float3 base = float3(0.0, 0.0, 0.0);
    bool isFound = false;
    [loop]
    for (uint look = 0u; look < 2u && !isFound; look++) // filters spread opacity in front of matter
        isFound = MatterColor(box, look == 0u ? index : index + lengthAhead, base);
    [branch]
    if (!isFound)
        base = SegmentColor(SegmentAround(box, int3(floor(index))));
    return BlinnPhong(base, BlendedNormal(box, index), toViewer, toLight);
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
        uint pairing = _March.x > 0.5 ? 0u : 1u;
        StepRay ray;
        ray.box = StoredVoxels();
        ray.first = start + nearT * velocity;
        ray.perStep = stepT * velocity;
        ray.stepsPerVoxel = float3(abs(ray.perStep.x) > 1e-20 ? 1.0 / ray.perStep.x : 1e20, abs(ray.perStep.y) > 1e-20 ? 1.0 / ray.perStep.y : 1e20,
            abs(ray.perStep.z) > 1e-20 ? 1.0 / ray.perStep.z : 1e20);
        ray.isBackwards = float3(ray.perStep.x < 0.0 ? 1.0 : 0.0, ray.perStep.y < 0.0 ? 1.0 : 0.0, ray.perStep.z < 0.0 ? 1.0 : 0.0);
        float logThrough = 0.0; // of the light that has passed so far: weights are differences of its powers, so that rounding does not add up
        float alpha = 0.0;
        float nearlyVisible = -1.0, visible = -1.0; // the steps in which alpha comes near _March.z, and reaches it
        float2 matter = float2(0.0, 0.0); // the step where the matter begins that the ray is in; alpha there
        float2 search = float2(0.0, 0.0); // where the parts begin; alpha there
        float peak = 0.0;       // the highest opacity about where alpha reaches _March.z
        float earlier = 0.0;    // alpha where the last step that was not empty begins
        uint last = stepCount;  // that step
        uint sampleUntil = _Skip.x > 0.0 ? 0u : stepCount; // in occupied cells up to here
        uint n = 0u;
        [loop]
        while (n < stepCount && alpha < _March.y)
        {
            uint from = stepCount, until = stepCount; // the stretch's steps
            float weight = 0.0, moment = 0.0;         // of its steps; about its beginning
            [loop]
            while (n < until && alpha < _March.y)
            {
                [loop]
                while (n >= sampleUntil && n < until)
                {
                    bool isEmpty;
                    sampleUntil = StepBeyondCells(ray, n, steps, stepCount, isEmpty);
                    n = isEmpty ? sampleUntil : n;
                    result.lookups++;
                }
                float begin = float(n), end = min(begin + 1.0, steps);
                float opacity = n < until ? OpacityOnRay(ray, 0.5 * (begin + end)) : 0.0;
                result.samples += n < until ? 1u : 0u;
                if (opacity > 0.0)
                {
                    if (alpha == 0.0)
                        result.enterMm = (nearT + begin * stepT) * mmPerT;
                    from = min(from, n);
                    float before = alpha;
                    logThrough += (end - begin) * _March.x * log2(max(1.0 - opacity, 1e-30));
                    alpha = opacity < 1.0 ? max(1.0 - exp2(logThrough), before) : 1.0; // matter of opacity 1 stops all light, however short the step
                    weight += alpha - before;
                    uint pairEnd = (n | pairing) + 1u;
                    pairEnd = weight < SHADED_WEIGHT ? min(pairEnd + 2u, (from | pairing) + MOST_SHADED) : pairEnd;
                    until = min(alpha < SHADED_ALPHA ? pairEnd : n + 1u, stepCount);
                    moment += (alpha - before) * (0.5 * (begin + end) - float(from));
                    matter = last + 1u == n ? matter : float2(begin, before);
                    earlier = last + 1u == n ? earlier : before;
                    bool isReached = visible < 0.0 && alpha >= _March.z;
                    visible = isReached ? begin : visible;
                    if (nearlyVisible < 0.0 ? alpha >= NEARLY * _March.z : isReached && begin <= nearlyVisible + 1.0)
                    {
                        nearlyVisible = begin;
                        search = isReached || begin > matter.x + FURTHER_STEPS ? float2(begin, earlier) : matter;
                    }
                    bool isBehindEdge = nearlyVisible >= 0.0 && before < SHADED_ALPHA && begin <= max(nearlyVisible, visible) + PLATEAU / _March.x;
                    peak = isBehindEdge ? max(peak, opacity) : peak;
                    earlier = before;
                    last = n;
                }
                n += n < until ? 1u : 0u;
            }
            if (weight > 0.0)
                result.color.rgb += weight * ShadedColor(ray.box, ray.first + (float(from) + moment / weight) * ray.perStep, ray.perStep / _March.x, toViewer, toLight);
        }
        result.color.a = alpha;
        if (nearlyVisible >= 0.0)
        {
            float stepEnd = min(visible + 1.0, steps), sampled = 0.5 * (visible + stepEnd);
            float searchEnd = min(max(nearlyVisible, visible) + 1.0 + FURTHER_STEPS, steps);
            float behind = OpacityOnRay(ray, min(max(nearlyVisible, visible) + 1.0 + PLATEAU / _March.x, steps)); // where rays may have ended before
            result.samples++;
            peak = max(peak, behind);
            float edge;
            float position = FirstVisiblePosition(ray, max(search.x - 1.0, 0.0), searchEnd, search.y, 0.5 * peak, edge, sampled, result.samples);
            // Of matter of the peak's opacity; never 0 / 0.
            float thickness = log2(1.0 - _March.z) / log2(clamp(1.0 - peak, ONE_CODE, 1.0 - 1e-6)) * saturate((1.0 - peak) / ONE_CODE);
            float depth = edge < 0.0 ? position : min(position, max(edge, position - EDGE_REACH / _March.x) + thickness / _March.x);
            depth = position < 0.0 ? stepEnd : depth;
            position = position < 0.0 && visible >= 0.0 ? stepEnd : position;
            [loop]
            for (uint look = 0u; look < 2u && position >= 0.0 && result.segment == NO_SEGMENT; look++) // what was sampled has matter around, should the place have none
                result.segment = SegmentAround(ray.box, int3(floor(ray.first + (look == 0u ? position : sampled) * ray.perStep)));
            result.depthMm = position >= 0.0 ? (nearT + depth * stepT) * mmPerT : NO_DEPTH;
        }
    }
    return result;
}

#endif
