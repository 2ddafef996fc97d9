// A carved volume in a camera's own picture: a fragment pass on the volume's box that marches each pixel's ray as the kernel Raymarch does
// (CarvedVolumePass.hlsl). It writes depth, so that the volume and opaque objects hide each other; its colour is premultiplied by alpha. The faces
// that look away from the viewer are drawn, so that the viewer may be inside. The queue comes after the sky and before other
// transparent objects, which then see the volume's depth.
//
// Properties are set by CarvedVolumeRenderer. All that the passes read is declared here: of a shader whose declared numbers lie outside
// UnityPerMaterial URP's SRP Batcher keeps its hands off, while numbers that nobody declared might be those of the volume drawn before.

Shader "AnatomyCarve/Carved Volume"
{
    Properties
    {
        [HideInInspector] _Opacity("Opacity", 3D) = "" {}
        [HideInInspector] _OpacityAA("Anti-aliased opacity", 3D) = "" {}
        [HideInInspector] _Normals("Normals", 3D) = "" {}
        [HideInInspector] _SkipMap("Skip map", 3D) = "" {}
        [HideInInspector] _Labels("Labels", 3D) = "" {}
        [HideInInspector] _SegmentColors("Segment colours", 2D) = "" {}
        [HideInInspector] _VolumeDims("Voxels", Vector) = (0, 0, 0, 0)
        [HideInInspector] _BrickGrid("Bricks", Vector) = (0, 0, 0, 0)
        [HideInInspector] _IndexToMm0("Index to mm, row 0", Vector) = (0, 0, 0, 0)
        [HideInInspector] _IndexToMm1("Index to mm, row 1", Vector) = (0, 0, 0, 0)
        [HideInInspector] _IndexToMm2("Index to mm, row 2", Vector) = (0, 0, 0, 0)
        [HideInInspector] _MmToIndex0("Mm to index, row 0", Vector) = (0, 0, 0, 0)
        [HideInInspector] _MmToIndex1("Mm to index, row 1", Vector) = (0, 0, 0, 0)
        [HideInInspector] _MmToIndex2("Mm to index, row 2", Vector) = (0, 0, 0, 0)
        [HideInInspector] _StoredFirst("First voxel that is stored", Vector) = (0, 0, 0, 0)
        [HideInInspector] _StoredLast("Last voxel that is stored", Vector) = (0, 0, 0, 0)
        [HideInInspector] _CentreIndex("Centre", Vector) = (0, 0, 0, 0)
        [HideInInspector] _IntensityToLookup("Intensity to lookup", Vector) = (0, 0, 0, 0)
        [HideInInspector] _CarveCounts("Counts", Vector) = (0, 0, 0, 0)
        [HideInInspector] _AntiAlias("Anti-aliasing", Vector) = (0, 0, 0, 0)
        [HideInInspector] _Skip("Skipping", Vector) = (0, 0, 0, 0)
        [HideInInspector] _March("Steps", Vector) = (0, 0, 0, 0)
        [HideInInspector] _LightDirection("Light direction", Vector) = (0, 0, 0, 0)
        [HideInInspector] _LightColor("Light colour", Vector) = (0, 0, 0, 0)
        [HideInInspector] _Shading("Shading", Vector) = (0, 0, 0, 0)
    }

    SubShader
    {
        PackageRequirements
        {
            "com.unity.render-pipelines.universal"
        }
        Tags
        {
            "RenderPipeline" = "UniversalPipeline"
            "Queue" = "Transparent-100"
            "RenderType" = "Transparent"
            "IgnoreProjector" = "True"
            "DisableBatching" = "True"
        }

        Pass
        {
            Name "CarvedVolume"
            Cull Front
            ZTest LEqual
            ZWrite On
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 4.5
            #pragma exclude_renderers gles3 glcore
            #pragma vertex CarvedVolumeVertex
            #pragma fragment CarvedVolumeFragment
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ PORTABLE_LAYOUT
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "CarvedVolumePass.hlsl"
            ENDHLSL
        }
    }

    SubShader
    {
        Tags
        {
            "Queue" = "Transparent-100"
            "RenderType" = "Transparent"
            "IgnoreProjector" = "True"
            "DisableBatching" = "True"
        }

        Pass
        {
            Name "CarvedVolume"
            Cull Front
            ZTest LEqual
            ZWrite On
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 4.5
            #pragma exclude_renderers gles3 glcore
            #pragma vertex CarvedVolumeVertex
            #pragma fragment CarvedVolumeFragment
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ PORTABLE_LAYOUT
            #include "UnityCG.cginc"
            #include "CarvedVolumePass.hlsl"
            ENDHLSL
        }
    }

    Fallback Off
}
