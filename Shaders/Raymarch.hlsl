#ifndef ANATOMYCARVE_RAYMARCH_INCLUDED
#define ANATOMYCARVE_RAYMARCH_INCLUDED

#include "SegmentLookup.hlsl"
#include "Shading.hlsl"
#include "VolumeFields.hlsl"

// Direct volume rendering of one ray, front to back (Max, "Optical Models for Direct Volume Rendering", IEEE TVCG 1(2), 1995).
// No writes and no structured buffers here, so that a fragment shader can include it as well as a kernel.
//
// The ray's part inside the volume and [nearT, farT] is cut into steps of _March.x reference lengths from where it enters; the last step ends
// where the ray leaves. Each step is sampled in its middle: opacity a per reference length gives  alpha = 1 - (1 - a)^(length of the step in
// reference lengths).  The first visible segment is where accumulated alpha reaches _March.z; within its step alpha grows as
// 1 - (1 - a)^length, which is solved for the length.

#ifndef PORTABLE_LAYOUT
SamplerState sampler_LinearClamp;
#endif

static const float MAX_STEPS = 1048576.0; // so that no setting makes a ray endless
static const float NO_DEPTH = asfloat(0x7F800000); // +infinity

struct RayResult
{
    float4 color;  // linear, premultiplied by a = alpha
    float depthMm; // from the ray's origin to the first visible segment, along the ray; NO_DEPTH: none
    float enterMm; // likewise to the first matter, however translucent; NO_DEPTH where alpha is 0
    uint segment;  // NO_SEGMENT: none
    uint samples;  // opacity samples taken
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

// origin, direction: centred mm; a point of the ray is origin + t * direction. toLight: unit vector, centred mm.
RayResult MarchRay(float3 origin, float3 direction, float nearT, float farT, float3 toLight)
{
    RayResult result;
    result.color = float4(0.0, 0.0, 0.0, 0.0);
    result.depthMm = NO_DEPTH;
    result.enterMm = NO_DEPTH;
    result.segment = NO_SEGMENT;
    result.samples = 0u;
    float mmPerT = length(direction);
    float3 velocity = MmToIndexVector(direction);
    float3 start = MmToIndexVector(origin) + _CentreIndex.xyz;
    if (mmPerT > 0.0 && ClipToVolume(start, velocity, nearT, farT))
    {
        float3 toViewer = -direction / mmPerT;
        float stepT = _March.x * _CentreIndex.w / mmPerT;
        float steps = min((farT - nearT) / stepT, MAX_STEPS); // the last one may be a fraction
        uint stepCount = (uint)ceil(steps);
        float3 first = start + nearT * velocity; // index space
        float3 perStep = stepT * velocity;
        int3 lookedUp = int3(-2, -2, -2); // the corner whose segment is known: no ray gets there
        uint segment = NO_SEGMENT;
        float3 segmentColor = float3(0.0, 0.0, 0.0);
        bool seen = false;
        uint n = 0u;
        [loop]
        while (n < stepCount && result.color.a < _March.y)
        {
            float opacity = 0.0, begin = 0.0, end = 0.0;
            [loop]
            while (n < stepCount && opacity == 0.0) // on to the next step with something in it
            {
                begin = float(n);
                end = min(begin + 1.0, steps);
                opacity = OpacityAt(first + 0.5 * (begin + end) * perStep);
                n++;
            }
            if (opacity > 0.0)
            {
                float3 index = first + 0.5 * (begin + end) * perStep;
                int3 corner = int3(floor(index));
                if (any(corner != lookedUp))
                {
                    lookedUp = corner;
                    segment = SegmentAround(corner);
                    segmentColor = SegmentColor(segment);
                }
                float before = result.color.a;
                if (before == 0.0)
                    result.enterMm = (nearT + begin * stepT) * mmPerT;
                float lengths = (end - begin) * _March.x; // of the step, in reference lengths
                float logPassing = lengths * log2(max(1.0 - opacity, 1e-30)); // of the light that passes the step
                float passing = opacity < 1.0 ? exp2(logPassing) : 0.0; // matter of opacity 1 stops all light, however short the step
                float weight = (1.0 - before) * (1.0 - passing);
                result.color.rgb += weight * BlinnPhong(segmentColor, BlendedNormal(index), toViewer, toLight);
                result.color.a = before + weight;
                if (!seen && result.color.a >= _March.z)
                {
                    seen = true;
                    float part = opacity < 1.0 ? saturate(log2((1.0 - _March.z) / (1.0 - before)) / logPassing) : 0.0;
                    float position = begin + part * (end - begin); // in steps
                    result.depthMm = (nearT + position * stepT) * mmPerT;
                    uint there = SegmentAround(int3(floor(first + position * perStep)));
                    result.segment = there != NO_SEGMENT ? there : segment;
                }
            }
        }
        result.samples = n;
    }
    return result;
}

#endif
