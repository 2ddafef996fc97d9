#ifndef ANATOMYCARVE_CARVED_VOLUME_PASS_INCLUDED
#define ANATOMYCARVE_CARVED_VOLUME_PASS_INCLUDED

#include "Raymarch.hlsl"

// The pass of CarvedVolume.shader. Before the include come UnityCG.cginc or URP's Core.hlsl, for the names that both define.
//
// Object space is the volume's local space: metres, +x left, +y superior, +z posterior of the patient. Rays are in centred mm (LPS). t counts the
// depth along the view in world units, from the camera, as it does in the kernel's pictures of cameras.
//
// What is the same for all pixels of an eye is computed at the box's corners and not interpolated.

static const float MM_PER_METRE = 1000.0;
static const float FARTHEST = 1e30;           // world units
static const float LEAST_ALPHA = 0.5 / 255.0; // less is not seen, and must not write depth

struct Attributes
{
    float3 position : POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 clipPosition : SV_POSITION;
    float3 position : TEXCOORD0;                 // on the box, centred mm
    nointerpolation float4 eye : TEXCOORD1;      // xyz: the camera, centred mm; w: 1 = parallel rays
    nointerpolation float3 forward : TEXCOORD2;  // along the view, centred mm per unit of depth
    nointerpolation float4 depthRow : TEXCOORD3; // depth of p = dot(row, float4(p, 1)), p in centred mm
    nointerpolation float4 clipZRow : TEXCOORD4; // likewise z and w of the clip position
    nointerpolation float4 clipWRow : TEXCOORD5;
    nointerpolation float3 toLight : TEXCOORD6;  // unit vector, centred mm
    UNITY_VERTEX_OUTPUT_STEREO
};

struct Fragment
{
    float4 color : SV_Target;
    float depth : SV_Depth;
};

// Metres (left, superior, posterior) and LPS millimetres: the last two axes change places.
float3 LocalToMm(float3 local) { return MM_PER_METRE * local.xzy; }

// A row that is multiplied with (local, 1) as one that is multiplied with (centred mm, 1).
float4 RowForMm(float4 row) { return float4(row.xzy / MM_PER_METRE, row.w); }

// The inverse of a map from local space to the view.
float3x3 ViewToLocal(float3x3 m)
{
    float3 a = cross(m[1], m[2]), b = cross(m[2], m[0]), c = cross(m[0], m[1]);
    return transpose(float3x3(a, b, c)) / dot(m[0], a);
}

Varyings CarvedVolumeVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output);
    float4x4 p = UNITY_MATRIX_P;
    float4x4 localToView = mul(UNITY_MATRIX_V, unity_ObjectToWorld);
    float4x4 localToClip = mul(p, localToView);
    float3x3 viewToLocal = ViewToLocal((float3x3)localToView);

    // As CameraRays has it, for any matrices that a camera may be given: where the projection's rays meet, which need not be the view's origin, and
    // where they go. Not _WorldSpaceCameraPos: that is where the camera's GameObject is, even where an eye is drawn.
    float parallel = p[3][2] == 0.0 ? 1.0 : 0.0;
    float eyeZ = parallel > 0.0 ? 0.0 : -p[3][3] / p[3][2];
    float2x2 clipToView = float2x2(p[1][1], -p[0][1], -p[1][0], p[0][0]) / (p[0][0] * p[1][1] - p[0][1] * p[1][0]);
    float3 eye = float3(mul(clipToView, -float2(p[0][2] * eyeZ + p[0][3], p[1][2] * eyeZ + p[1][3])), eyeZ);
    float3 forward = float3(mul(clipToView, float2(p[0][2], p[1][2])), -1.0);

    output.position = LocalToMm(input.position);
    output.eye = float4(LocalToMm(mul(viewToLocal, eye - float3(localToView[0][3], localToView[1][3], localToView[2][3]))), parallel);
    output.forward = LocalToMm(mul(viewToLocal, forward));
    output.depthRow = -RowForMm(localToView[2]) + float4(0.0, 0.0, 0.0, eyeZ);
    output.clipZRow = RowForMm(localToClip[2]);
    output.clipWRow = RowForMm(localToClip[3]);
    output.toLight = normalize(LocalToMm(mul(viewToLocal, _LightDirection.xyz)));

    // The planes must not cut faces off through which the volume is seen: they end the rays, and depth comes from the fragments.
    float4 clip = mul(localToClip, float4(input.position, 1.0));
    clip.z = 0.5 * clip.w;
    output.clipPosition = clip;
    return output;
}

// Colours are linear up to here; what a gamma project blends and stores is encoded.
float4 InProjectsColorSpace(float4 premultiplied)
{
#ifdef UNITY_COLORSPACE_GAMMA
    float3 linearColor = max(premultiplied.rgb / max(premultiplied.a, 1e-4), 0.0);
    float3 low = 12.92 * linearColor;
    float3 high = 1.055 * pow(max(linearColor, 1e-4), 1.0 / 2.4) - 0.055;
    float3 encoded = float3(
        linearColor.r <= 0.0031308 ? low.r : high.r, linearColor.g <= 0.0031308 ? low.g : high.g, linearColor.b <= 0.0031308 ? low.b : high.b);
    premultiplied.rgb = encoded * premultiplied.a;
#endif
    return premultiplied;
}

// Narrows [nearT, farT] to where start + t * rate is positive.
void ClipToPlane(float start, float rate, inout float nearT, inout float farT)
{
    if (rate > 0.0)
        nearT = max(nearT, -start / rate);
    else if (rate < 0.0)
        farT = min(farT, -start / rate);
}

Fragment CarvedVolumeFragment(Varyings input)
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
    float depthHere = dot(input.depthRow, float4(input.position, 1.0));
    float3 direction, origin;
    if (input.eye.w > 0.0)
    {
        direction = input.forward;
        origin = input.position - depthHere * direction;
    }
    else
    {
        direction = (input.position - input.eye.xyz) / depthHere;
        origin = input.eye.xyz;
    }
    // The camera's planes, whose depth is reversed: z = w at the near one, 0 at the far one.
    float nearT = -FARTHEST, farT = FARTHEST;
    float4 from = float4(origin, 1.0);
    float4 nearRow = input.clipWRow - input.clipZRow;
    ClipToPlane(dot(nearRow, from), dot(nearRow.xyz, direction), nearT, farT);
    ClipToPlane(dot(input.clipZRow, from), dot(input.clipZRow.xyz, direction), nearT, farT);
    RayResult ray = MarchRay(origin, direction, nearT, farT, input.toLight);
    if (ray.color.a < LEAST_ALPHA)
        discard;

    // Matter that never becomes opaque enough to count as a segment has the depth at which it begins.
    float distanceMm = ray.color.a >= _March.z ? ray.depthMm : ray.enterMm;
    float4 seen = float4(origin + distanceMm / length(direction) * direction, 1.0);
    Fragment output;
    output.color = InProjectsColorSpace(ray.color);
    output.depth = dot(input.clipZRow, seen) / dot(input.clipWRow, seen);
    return output;
}

#endif
