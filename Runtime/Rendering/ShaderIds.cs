using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>The names in <c>Shaders/</c>, as Unity's property ids.</summary>
    static class ShaderIds
    {
        public const string CountSamples = "COUNT_SAMPLES";
        public const string CountWork = "COUNT_WORK";
        public const string PortableLayout = "PORTABLE_LAYOUT";

        public static readonly int Bricks = Shader.PropertyToID("_Bricks");
        public static readonly int Spheres = Shader.PropertyToID("_Spheres");
        public static readonly int MaskWords = Shader.PropertyToID("_MaskWords");
        public static readonly int BrickSpheres = Shader.PropertyToID("_BrickSpheres");
        public static readonly int SphereSlots = Shader.PropertyToID("_SphereSlots");
        public static readonly int BrickMatter = Shader.PropertyToID("_BrickMatter");
        public static readonly int BrickMatterIn = Shader.PropertyToID("_BrickMatterIn");
        public static readonly int OccupiedCells = Shader.PropertyToID("_OccupiedCells");
        public static readonly int OccupiedCellsOut = Shader.PropertyToID("_OccupiedCellsOut");
        public static readonly int PlaneDistances = Shader.PropertyToID("_PlaneDistances");
        public static readonly int PlaneDistancesOut = Shader.PropertyToID("_PlaneDistancesOut");
        public static readonly int SkipMap = Shader.PropertyToID("_SkipMap");
        public static readonly int SkipMapOut = Shader.PropertyToID("_SkipMapOut");
        public static readonly int SkipFirst = Shader.PropertyToID("_SkipFirst");
        public static readonly int SkipSize = Shader.PropertyToID("_SkipSize");
        public static readonly int WorkCounts = Shader.PropertyToID("_WorkCounts");
        public static readonly int Intensity = Shader.PropertyToID("_Intensity");
        public static readonly int Labels = Shader.PropertyToID("_Labels");
        public static readonly int TransferFunction = Shader.PropertyToID("_TransferFunction");
        public static readonly int SegmentColors = Shader.PropertyToID("_SegmentColors");
        public static readonly int Opacity = Shader.PropertyToID("_Opacity");
        public static readonly int OpacityAA = Shader.PropertyToID("_OpacityAA");
        public static readonly int Normals = Shader.PropertyToID("_Normals");
        public static readonly int OpacityOut = Shader.PropertyToID("_OpacityOut");
        public static readonly int OpacityAAOut = Shader.PropertyToID("_OpacityAAOut");
        public static readonly int NormalsOut = Shader.PropertyToID("_NormalsOut");

        public static readonly int VolumeDims = Shader.PropertyToID("_VolumeDims");
        public static readonly int BrickGrid = Shader.PropertyToID("_BrickGrid");
        public static readonly int IndexToMm0 = Shader.PropertyToID("_IndexToMm0");
        public static readonly int IndexToMm1 = Shader.PropertyToID("_IndexToMm1");
        public static readonly int IndexToMm2 = Shader.PropertyToID("_IndexToMm2");
        public static readonly int MmToIndex0 = Shader.PropertyToID("_MmToIndex0");
        public static readonly int MmToIndex1 = Shader.PropertyToID("_MmToIndex1");
        public static readonly int MmToIndex2 = Shader.PropertyToID("_MmToIndex2");
        public static readonly int StoredFirst = Shader.PropertyToID("_StoredFirst");
        public static readonly int StoredLast = Shader.PropertyToID("_StoredLast");
        public static readonly int CentreIndex = Shader.PropertyToID("_CentreIndex");
        public static readonly int IntensityToLookup = Shader.PropertyToID("_IntensityToLookup");
        public static readonly int CarveCounts = Shader.PropertyToID("_CarveCounts");
        public static readonly int AntiAlias = Shader.PropertyToID("_AntiAlias");

        public static readonly int PictureSize = Shader.PropertyToID("_PictureSize");
        public static readonly int RayOrigin = Shader.PropertyToID("_RayOrigin");
        public static readonly int RayOriginDx = Shader.PropertyToID("_RayOriginDx");
        public static readonly int RayOriginDy = Shader.PropertyToID("_RayOriginDy");
        public static readonly int RayDirection = Shader.PropertyToID("_RayDirection");
        public static readonly int RayDirectionDx = Shader.PropertyToID("_RayDirectionDx");
        public static readonly int RayDirectionDy = Shader.PropertyToID("_RayDirectionDy");
        public static readonly int RayRange = Shader.PropertyToID("_RayRange");
        public static readonly int Skip = Shader.PropertyToID("_Skip");
        public static readonly int March = Shader.PropertyToID("_March");
        public static readonly int LightDirection = Shader.PropertyToID("_LightDirection");
        public static readonly int LightColor = Shader.PropertyToID("_LightColor");
        public static readonly int Shading = Shader.PropertyToID("_Shading");
        public static readonly int SceneDepth = Shader.PropertyToID("_SceneDepth");
        public static readonly int ColorOut = Shader.PropertyToID("_ColorOut");
        public static readonly int DepthOut = Shader.PropertyToID("_DepthOut");
        public static readonly int SegmentOut = Shader.PropertyToID("_SegmentOut");
        public static readonly int SampleCounts = Shader.PropertyToID("_SampleCounts");
    }
}
