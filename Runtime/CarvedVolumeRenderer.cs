using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// Makes pictures of the volume on its GameObject, carved as it is at that moment: for any number of cameras, or for rays of one's own.
    /// Only what changed since the last picture is computed again. Disabling it frees all GPU memory.
    /// </summary>
    [AddComponentMenu("AnatomyCarve/Carved Volume Renderer")]
    [DisallowMultipleComponent]
    public sealed class CarvedVolumeRenderer : MonoBehaviour
    {
        [SerializeField, Tooltip("The volume to show; empty = the one on this GameObject")]
        private VolumeLoader loader;

        [SerializeField, Tooltip("The carving to show; empty = the one on this GameObject; none = the whole volume")]
        private ClipSphereStack stack;

        [SerializeField, Tooltip("Step, cuts and anti-aliasing")]
        private RenderQuality quality = RenderQuality.Balanced();

        [SerializeField, Tooltip("The light that the volume is shaded with")]
        private LightSettings shading = new LightSettings();

        readonly RenderStatistics statistics = new RenderStatistics();
        readonly VolumeSettings settings = new VolumeSettings();
        readonly FieldCache field = new FieldCache();
        VolumeGpu gpu;
        SegmentedVolume refused;

        /// <summary>The volume that is shown: the one that was set, or else the one on this GameObject. Null if there is none.</summary>
        public VolumeLoader Loader
        {
            get
            {
                if (loader == null)
                    TryGetComponent(out loader);
                return loader;
            }
            set => loader = value;
        }

        /// <summary>The carving that is shown: the one that was set, or else the one on this GameObject. Null = the whole volume is shown.</summary>
        public ClipSphereStack Stack
        {
            get
            {
                if (stack == null)
                    TryGetComponent(out stack);
                return stack;
            }
            set => stack = value;
        }

        /// <summary>The volume; null while none is loaded.</summary>
        public SegmentedVolume Volume => Loader != null ? Loader.Volume : null;

        /// <summary>Opacity by intensity. Unless set, one is derived from each volume's intensities; null goes back to that.</summary>
        public OpacityTransferFunction TransferFunction
        {
            get => settings.TransferFunctionFor(Volume);
            set => settings.TransferFunction = value;
        }

        /// <summary>
        /// The segments as they are shown, with colours and opacities; null while no volume is loaded. Another volume starts with its own table.
        /// </summary>
        /// <exception cref="ArgumentException">The table has another number of segments than the volume.</exception>
        public SegmentTable Segments
        {
            get => settings.SegmentsFor(Volume);
            set => settings.SetSegments(Volume, value);
        }

        /// <summary>Step, cuts and anti-aliasing. Changes of its properties take effect with the next picture.</summary>
        /// <exception cref="ArgumentNullException">The value is null.</exception>
        public RenderQuality Quality
        {
            get => quality;
            set => quality = value ?? throw new ArgumentNullException(nameof(value));
        }

        /// <summary>The light that the volume is shaded with. Changes of its properties take effect with the next picture.</summary>
        /// <exception cref="ArgumentNullException">The value is null.</exception>
        public LightSettings Light
        {
            get => shading;
            set => shading = value ?? throw new ArgumentNullException(nameof(value));
        }

        /// <summary>Whether pictures count the samples that their rays take; see <see cref="CarvedPicture.ReadSampleCount"/>.</summary>
        public bool CountSamples { get; set; }

        /// <summary>What this renderer has done and what it holds on the GPU.</summary>
        public RenderStatistics Statistics => statistics;

        /// <summary>The carved volume on the CPU, as it would be shown now; for pointers. Null while no volume is loaded.</summary>
        public CarvedField Field
        {
            get
            {
                SegmentedVolume volume = Volume;
                return volume == null ? null : field.Of(volume, CarvingOf(volume), TransferFunction, Segments, quality.CutMode, quality.AntiAliasSettings);
            }
        }

        /// <summary>How rays are marched and when a segment counts as visible, for pointers that find what the picture shows.</summary>
        public RaySettings RaySettings => quality.RaySettings;

        /// <summary>Makes a camera's picture. Each camera has a picture of its own, which is used again.</summary>
        /// <param name="camera">The camera; enabled or not.</param>
        /// <param name="width">Width in pixels; 0 = the camera's. Its projection is the camera's, so keep the camera's aspect.</param>
        /// <param name="height">Height in pixels; 0 = the camera's.</param>
        /// <returns>The picture; null while there is nothing to show: no volume, a scale of 0, disabled, or a device that cannot (said once in the console).</returns>
        /// <exception cref="ArgumentNullException"><paramref name="camera"/> is null.</exception>
        public CarvedPicture Render(Camera camera, int width = 0, int height = 0)
        {
            if (camera == null)
                throw new ArgumentNullException(nameof(camera));
            Matrix4x4 volumeToWorld = Loader != null ? Loader.transform.localToWorldMatrix : Matrix4x4.identity;
            if (VolumeSpace.WorldScale(volumeToWorld) == 0 || !Prepare())
                return null;
            PictureRayBundle rays = CameraRays.Bundle(camera.projectionMatrix, camera.cameraToWorldMatrix, volumeToWorld, gpu.Volume.Geometry,
                width > 0 ? width : camera.pixelWidth, height > 0 ? height : camera.pixelHeight);
            return Finish(rays, gpu.Pictures.Of(camera));
        }

        /// <summary>Makes the picture that rays of one's own see.</summary>
        /// <param name="rays">The rays in LPS millimetres.</param>
        /// <param name="picture">Where to; null = a picture that the next call without one uses again.</param>
        /// <returns>The picture; null while there is nothing to show, as with a camera.</returns>
        /// <exception cref="ArgumentNullException"><paramref name="rays"/> is null.</exception>
        public CarvedPicture Render(PictureRays rays, CarvedPicture picture = null)
        {
            if (rays == null)
                throw new ArgumentNullException(nameof(rays));
            return Prepare() ? Finish(new PictureRayBundle(rays), picture ?? gpu.Pictures.OfRays()) : null;
        }

        /// <summary>Frees all GPU memory; the next picture takes it again. Pictures that this renderer returned are freed too.</summary>
        public void ReleaseResources()
        {
            gpu?.Dispose();
            gpu = null;
            refused = null;
        }

        void LateUpdate()
        {
            if (gpu != null && gpu.Volume != Volume)
                ReleaseResources();
            if (Volume == null)
                field.Clear();
        }

        void OnDisable() => ReleaseResources();

        void OnValidate()
        {
            quality?.Clamp();
            shading?.Clamp();
        }

        /// <summary>Brings the GPU up to date; false where there is nothing to show.</summary>
        bool Prepare()
        {
            SegmentedVolume volume = Volume;
            if (gpu != null && gpu.Volume != volume)
                ReleaseResources();
            if (volume == null || volume == refused || !isActiveAndEnabled)
                return false;
            gpu ??= VolumeGpu.TryCreate(volume, statistics, out string problem) ?? Refuse(volume, problem);
            gpu?.Update(CarvingOf(volume), TransferFunction, Segments, quality);
            return gpu != null;
        }

        CarvedPicture Finish(in PictureRayBundle rays, CarvedPicture picture)
        {
            gpu.Render(rays, quality, shading, CountSamples, picture);
            return picture;
        }

        VolumeGpu Refuse(SegmentedVolume volume, string problem)
        {
            refused = volume;
            Debug.LogError($"{name}: this volume cannot be shown. {problem}", this);
            return null;
        }

        CarvingSnapshot CarvingOf(SegmentedVolume volume) => Stack != null && Stack.Carving != null && Stack.Loader.Volume == volume ? Stack.Carving.State : null;
    }
}
