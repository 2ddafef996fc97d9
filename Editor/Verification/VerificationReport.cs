using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;
using UnityEngine.Rendering;

namespace AnatomyCarve.Editor
{
    /// <summary>What the verification found, as the file report.json holds it.</summary>
    [Serializable]
    sealed class VerificationReport
    {
        public bool passed;
        public List<string> failures = new List<string>();
        public List<string> errorsLogged = new List<string>();
        public string unity, package, platform, graphicsDevice, graphicsApi, graphicsVersion, renderPipeline, colorSpace, scene;
        public int frames;
        public float secondsUntilLoaded;
        public string volumeVoxels = "", volumeOrientation = "", textureLayout = "", problem = "";
        public int segments;
        public long bytesOnGpu;
        public int pictureWidth, pictureHeight, pixelsWithSegment;
        public float differenceFromKernel, differenceFromBackground;

        /// <summary>Takes down what does not depend on the scene.</summary>
        public void DescribeMachine()
        {
            var info = UnityEditor.PackageManager.PackageInfo.FindForAssembly(typeof(CarvedVolumeRenderer).Assembly);
            RenderPipelineAsset pipeline = GraphicsSettings.currentRenderPipeline;
            unity = Application.unityVersion;
            package = info == null ? "not a package" : info.name + " " + info.version;
            platform = Application.platform.ToString();
            graphicsDevice = SystemInfo.graphicsDeviceName;
            graphicsApi = SystemInfo.graphicsDeviceType.ToString();
            graphicsVersion = SystemInfo.graphicsDeviceVersion;
            renderPipeline = pipeline == null ? "Built-in" : pipeline.GetType().Name;
            colorSpace = QualitySettings.activeColorSpace.ToString();
        }

        public void DescribeVolume(CarvedVolumeRenderer renderer)
        {
            var geometry = renderer.Volume.Geometry;
            volumeVoxels = $"{geometry.SizeI} x {geometry.SizeJ} x {geometry.SizeK}";
            volumeOrientation = geometry.OrientationCode;
            segments = renderer.Volume.Segments.Count;
            textureLayout = renderer.Statistics.Layout.ToString();
            bytesOnGpu = renderer.Statistics.BytesResident;
            problem = renderer.Problem ?? "";
        }

        public void Write(string folder)
        {
            passed = failures.Count == 0;
            File.WriteAllText(Path.Combine(folder, "report.json"), JsonUtility.ToJson(this, true));
        }
    }
}
