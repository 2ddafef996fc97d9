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
        VolumeLoader loader;

        [SerializeField, Tooltip("The carving to show; empty = the one on this GameObject; none = the whole volume")]
        ClipSphereStack stack;

        [SerializeField, Tooltip("Step, cuts and anti-aliasing")]
        RenderQuality quality = RenderQuality.Balanced();

        [SerializeField, Tooltip("The light that the volume is shaded with")]
        LightSettings shading = new LightSettings();

        readonly GpuSlot gpu = new GpuSlot(new RenderStatistics());
        readonly VolumeSettings settings = new VolumeSettings();
        readonly FieldCache field = new FieldCache();

        /// <summary>The volume that is shown: the one that was set, or else the one on this GameObject. Null if there is none.</summary>
        public VolumeLoader Loader
        {
            get => this.WiredOrSibling(ref loader);
            set => loader = value;
        }

        /// <summary>The carving that is shown: the one that was set, or else the one on this GameObject. Null = the whole volume is shown.</summary>
        public ClipSphereStack Stack
        {
            get => this.WiredOrSibling(ref stack);
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
        public RenderStatistics Statistics => gpu.Statistics;

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
        /// <returns>The picture; null while there is nothing to show: no volume, a scale of 0, disabled, or a device that cannot (said once in the console,
        /// and tried again after <see cref="ReleaseResources"/>).</returns>
        /// <exception cref="ArgumentNullException"><paramref name="camera"/> is null.</exception>
        public CarvedPicture Render(Camera camera, int width = 0, int height = 0)
        {
            if (camera == null)
                throw new ArgumentNullException(nameof(camera));
            Matrix4x4 volumeToWorld = Loader != null ? Loader.transform.localToWorldMatrix : Matrix4x4.identity;
            VolumeGpu shown = VolumeSpace.WorldScale(volumeToWorld) == 0 ? null : Shown();
            if (shown == null)
                return null;
            PictureRayBundle rays = CameraRays.Bundle(camera.projectionMatrix, camera.cameraToWorldMatrix, volumeToWorld, shown.Volume.Geometry,
                width > 0 ? width : camera.pixelWidth, height > 0 ? height : camera.pixelHeight);
            return Finish(shown, rays, shown.Pictures.Of(camera));
        }

        /// <summary>Makes the picture that rays of one's own see.</summary>
        /// <param name="rays">The rays in LPS millimetres.</param>
        /// <param name="picture">Where to; null = a picture that the next call without one uses again.</param>
        /// <returns>The picture; null while there is nothing to show, as with a camera.</returns>
        /// <exception cref="ArgumentNullException"><paramref name="rays"/> is null.</exception>
        /// <exception cref="ArgumentException">The picture's scene depth is of another size.</exception>
        public CarvedPicture Render(PictureRays rays, CarvedPicture picture = null)
        {
            if (rays == null)
                throw new ArgumentNullException(nameof(rays));
            VolumeGpu shown = Shown();
            return shown == null ? null : Finish(shown, new PictureRayBundle(rays), picture ?? shown.Pictures.OfRays());
        }

        /// <summary>Frees all GPU memory; the next picture takes it again. Pictures that this renderer returned are freed too.</summary>
        public void ReleaseResources() => gpu.Release();

        void LateUpdate()
        {
            KeepOnly(Volume);
            gpu.Gpu?.Pictures.DropGone();
        }

        void OnDisable()
        {
            ReleaseResources();
            field.KeepOnly(null);
        }

        void OnValidate()
        {
            quality?.Clamp();
            shading?.Clamp();
        }

        /// <summary>A volume is large: none is held that is not shown.</summary>
        void KeepOnly(SegmentedVolume volume)
        {
            gpu.KeepOnly(volume);
            field.KeepOnly(volume);
            settings.SegmentsFor(volume);
        }

        CarvedPicture Finish(VolumeGpu shown, in PictureRayBundle rays, CarvedPicture picture)
        {
            try
            {
                shown.Update(CarvingOf(shown.Volume), TransferFunction, Segments, quality);
                shown.Render(rays, quality, shading, CountSamples, picture);
                return picture;
            }
            catch (AnatomyCarveException e)
            {
                gpu.Refuse(shown.Volume, e.Message, this);
                return null;
            }
        }

        VolumeGpu Shown() => isActiveAndEnabled ? gpu.For(Volume, this) : null;

        CarvingSnapshot CarvingOf(SegmentedVolume volume) =>
            Stack != null && Stack.Carving != null && Stack.Loader.Volume == volume ? Stack.Carving.State : null;
    }
}
