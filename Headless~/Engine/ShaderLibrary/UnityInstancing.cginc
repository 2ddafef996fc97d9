// Which instance and which eye a vertex or a pixel belongs to. Needs unity_ObjectToWorld, unity_WorldToObject and, for both eyes in one draw,
// unity_StereoEyeIndex.
#ifndef UNITY_INSTANCING_INCLUDED
#define UNITY_INSTANCING_INCLUDED

#if defined(INSTANCING_ON)
    #define UNITY_INSTANCING_ENABLED
#endif
#if defined(UNITY_INSTANCING_ENABLED) || defined(UNITY_STEREO_INSTANCING_ENABLED)
    #define UNITY_ANY_INSTANCING_ENABLED 1
#else
    #define UNITY_ANY_INSTANCING_ENABLED 0
#endif

#if UNITY_ANY_INSTANCING_ENABLED
    static uint unity_InstanceID;
    CBUFFER_START(UnityDrawCallInfo)
        int unity_BaseInstanceID;
        int unity_InstanceCount;
    CBUFFER_END
    #define UNITY_VERTEX_INPUT_INSTANCE_ID uint instanceID : SV_InstanceID;
    #define UNITY_GET_INSTANCE_ID(input) input.instanceID
    #define UNITY_TRANSFER_INSTANCE_ID(input, output) output.instanceID = UNITY_GET_INSTANCE_ID(input)
    // Both eyes' instances come in turn.
    void UnitySetupInstanceID(uint id)
    {
    #ifdef UNITY_STEREO_INSTANCING_ENABLED
        unity_StereoEyeIndex = id & 1u;
        unity_InstanceID = (uint)unity_BaseInstanceID + (id >> 1);
    #else
        unity_InstanceID = (uint)unity_BaseInstanceID + id;
    #endif
    }
    #define UNITY_SETUP_INSTANCE_ID(input) { UnitySetupInstanceID(UNITY_GET_INSTANCE_ID(input)); }
#elif defined(UNITY_STEREO_MULTIVIEW_ENABLED)
    #define UNITY_VERTEX_INPUT_INSTANCE_ID uint viewID : SV_ViewID;
    #define UNITY_TRANSFER_INSTANCE_ID(input, output) output.viewID = input.viewID
    #define UNITY_SETUP_INSTANCE_ID(input) { unity_StereoEyeIndex = input.viewID; }
#else
    #define UNITY_VERTEX_INPUT_INSTANCE_ID
    #define UNITY_TRANSFER_INSTANCE_ID(input, output)
    #define UNITY_SETUP_INSTANCE_ID(input)
#endif

// From the vertex to the pixel: the eye, which with instancing is also the layer that is drawn to.
#if defined(UNITY_STEREO_INSTANCING_ENABLED)
    #define UNITY_VERTEX_OUTPUT_STEREO uint stereoTargetEyeIndexAsRTArrayIdx : SV_RenderTargetArrayIndex;
    #define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output) output.stereoTargetEyeIndexAsRTArrayIdx = unity_StereoEyeIndex;
    #define UNITY_TRANSFER_VERTEX_OUTPUT_STEREO(input, output) output.stereoTargetEyeIndexAsRTArrayIdx = input.stereoTargetEyeIndexAsRTArrayIdx;
    #define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input) unity_StereoEyeIndex = input.stereoTargetEyeIndexAsRTArrayIdx;
#elif defined(UNITY_STEREO_MULTIVIEW_ENABLED)
    #define UNITY_VERTEX_OUTPUT_STEREO float stereoTargetEyeIndexAsBlendIdx0 : BLENDWEIGHT0;
    #define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output) output.stereoTargetEyeIndexAsBlendIdx0 = (float)unity_StereoEyeIndex;
    #define UNITY_TRANSFER_VERTEX_OUTPUT_STEREO(input, output) output.stereoTargetEyeIndexAsBlendIdx0 = input.stereoTargetEyeIndexAsBlendIdx0;
    #define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input) unity_StereoEyeIndex = (uint)(input.stereoTargetEyeIndexAsBlendIdx0 + 0.5);
#else
    #define UNITY_VERTEX_OUTPUT_STEREO
    #define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
    #define UNITY_TRANSFER_VERTEX_OUTPUT_STEREO(input, output)
    #define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)
#endif

#if defined(UNITY_INSTANCING_ENABLED)
    #define UNITY_INSTANCED_ARRAY_SIZE 500
    CBUFFER_START(UnityInstancing_PerDraw0)
        float4x4 unity_ObjectToWorldArray[UNITY_INSTANCED_ARRAY_SIZE];
        float4x4 unity_WorldToObjectArray[UNITY_INSTANCED_ARRAY_SIZE];
    CBUFFER_END
    #define unity_ObjectToWorld unity_ObjectToWorldArray[unity_InstanceID]
    #define unity_WorldToObject unity_WorldToObjectArray[unity_InstanceID]
    #define UNITY_INSTANCING_BUFFER_START(buffer) CBUFFER_START(UnityInstancing_##buffer)
    #define UNITY_INSTANCING_BUFFER_END(buffer) CBUFFER_END
    #define UNITY_DEFINE_INSTANCED_PROP(type, name) type name[UNITY_INSTANCED_ARRAY_SIZE];
    #define UNITY_ACCESS_INSTANCED_PROP(buffer, name) name[unity_InstanceID]
#else
    #define UNITY_INSTANCING_BUFFER_START(buffer) CBUFFER_START(buffer)
    #define UNITY_INSTANCING_BUFFER_END(buffer) CBUFFER_END
    #define UNITY_DEFINE_INSTANCED_PROP(type, name) type name;
    #define UNITY_ACCESS_INSTANCED_PROP(buffer, name) name
#endif

#endif
