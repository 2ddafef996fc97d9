// The pass of SceneDepth.shader, after Unity's or URP's include files and SceneDistance(uv).
float _Unit;

struct appdata
{
    float3 position : POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct v2f
{
    float4 position : SV_POSITION;
    float4 screen : TEXCOORD0;
    UNITY_VERTEX_OUTPUT_STEREO
};

v2f vert(appdata v)
{
    v2f o = (v2f)0;
    UNITY_SETUP_INSTANCE_ID(v);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
    o.position = mul(UNITY_MATRIX_VP, mul(UNITY_MATRIX_M, float4(v.position, 1)));
    float4 middle = o.position * 0.5;
    o.screen = float4(middle.x + middle.w, middle.y * _ProjectionParams.x + middle.w, o.position.zw);
    return o;
}

float4 frag(v2f i) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
    return float4(SceneDistance(i.screen.xy / i.screen.w) / _Unit, i.screen.w / _Unit, 0, 1);
}
