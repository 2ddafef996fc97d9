// The pass of Eyes.shader, after Unity's or URP's include files.
struct appdata
{
    float3 position : POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct v2f
{
    float4 position : SV_POSITION;
    nointerpolation float3 camera : TEXCOORD0;
    UNITY_VERTEX_OUTPUT_STEREO
};

v2f vert(appdata v)
{
    v2f o = (v2f)0;
    UNITY_SETUP_INSTANCE_ID(v);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
    o.position = mul(UNITY_MATRIX_VP, mul(UNITY_MATRIX_M, float4(v.position, 1)));
    o.camera = _WorldSpaceCameraPos;
    return o;
}

float4 frag(v2f i) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
    // Both stages must mean the same eye.
    float same = abs(_WorldSpaceCameraPos.x - i.camera.x) < 1e-6 ? 1 : 0;
    return float4(0.5 + i.camera.x, unity_StereoEyeIndex, same, 1);
}
