using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// Shows a volume at its GameObject's place, carved as it is at that moment: in every camera that sees its layer, and in pictures made on demand. Only
    /// what changed since the last picture is computed again, before the frame's pictures are drawn. Disabling it frees all GPU memory. Mesh and material
    /// of the MeshRenderer beside it are its own.
    /// </summary>
    [AddComponentMenu("AnatomyCarve/Carved Volume Renderer")]
    [DisallowMultipleComponent]
    [ExecuteAlways]
    [RequireComponent(typeof(MeshFilter), typeof(MeshRenderer))]
    [ManualPage("components")]
    public sealed class CarvedVolumeRenderer : MonoBehaviour
    {
        [SerializeField, Tooltip("The volume to show; empty = the one on this GameObject")]
        VolumeLoader loader;

        [SerializeField, Tooltip("The carving to show; empty = the one on this GameObject; none = the whole volume")]
        ClipSphereStack stack;

        [SerializeField, Tooltip("Draw the volume in cameras that see this GameObject's layer. Off: only pictures made by Render")]
        bool drawInCameras = true;

        [SerializeField, Tooltip("Step, cuts and anti-aliasing")]
        RenderQuality quality = RenderQuality.Balanced();

        [SerializeField, Tooltip("The light that the volume is shaded with")]
        LightSettings shading = new LightSettings();

        [SerializeField, Tooltip("Transfer function and segments that look other than the volume says")]
        VolumeAppearance appearance = new VolumeAppearance();

        [SerializeField, Tooltip("How the volume lies in textures. Automatic asks the device; Portable helps where a driver claims more than it can")]
        TextureLayout layout = TextureLayout.Automatic;

        GpuSlot slot;
        readonly VolumeSettings settings = new VolumeSettings();
        readonly FieldCache field = new FieldCache();
        VolumeSurface surface;
        CameraEvents cameras;

        /// <summary>The volume that is shown: the one that was set, or else the one on this GameObject. Null if there is none.</summary>
        public VolumeLoader Loader { get => this.WiredOrSibling(loader); set => loader = value; }

        /// <summary>The carving that is shown: the one that was set, or else the one on this GameObject. Null = the whole volume is shown.</summary>
        public ClipSphereStack Stack { get => this.WiredOrSibling(stack); set => stack = value; }

        /// <summary>The volume; null while none is loaded.</summary>
        public SegmentedVolume Volume => Loader != null ? Loader.Volume : null;

        /// <summary>Whether cameras draw the volume; they need the Built-in or the Universal Render Pipeline.</summary>
        public bool DrawInCameras { get => drawInCameras; set => drawInCameras = value; }

        /// <summary>How volumes look: saved with the scene, and kept when another volume is loaded.</summary>
        public VolumeAppearance Appearance => appearance;

        /// <summary>Opacity by intensity. Unless set, one is derived from each volume's intensities; null goes back to that.</summary>
        public OpacityTransferFunction TransferFunction
        {
            get => appearance.TransferFunction ?? Volume?.AutomaticTransferFunction;
            set => appearance.TransferFunction = value;
        }

        /// <summary>
        /// The segments as they are shown, with colours and opacities; null while no volume is loaded. A table that is set here stays until another volume is
        /// loaded, and is not saved; null goes back to what the volume and <see cref="Appearance"/> say.
        /// </summary>
        /// <exception cref="ArgumentException">The table has another number of segments than the volume.</exception>
        public SegmentTable Segments { get => settings.SegmentsFor(Volume, appearance); set => settings.SetSegments(Volume, value); }

        /// <summary>Step, cuts and anti-aliasing. Changes of its properties take effect with the next picture.</summary>
        /// <exception cref="ArgumentNullException">The value is null.</exception>
        public RenderQuality Quality { get => quality; set => quality = value ?? throw new ArgumentNullException(nameof(value)); }

        /// <summary>The light that the volume is shaded with. Changes of its properties take effect with the next picture.</summary>
        /// <exception cref="ArgumentNullException">The value is null.</exception>
        public LightSettings Light { get => shading; set => shading = value ?? throw new ArgumentNullException(nameof(value)); }

        /// <summary>How the volume lies in textures; pictures are the same in each layout. A change takes the volume to the GPU anew.</summary>
        /// <exception cref="ArgumentOutOfRangeException">No such layout.</exception>
        public TextureLayout Layout { get => layout; set => layout = SettingRange.Defined(value, nameof(Layout)); }

        /// <summary>Whether pictures count the samples that their rays take; see <see cref="CarvedPicture.ReadSampleCount"/>.</summary>
        public bool CountSamples { get; set; }

        /// <summary>What this renderer has done and what it holds on the GPU.</summary>
        public RenderStatistics Statistics => Slot.Statistics;

        /// <summary>
        /// Why the volume, or some way of showing it, is refused by the device or the render pipeline, as a sentence; null = all is well as far as it was
        /// tried. It is also logged, once.
        /// </summary>
        public string Problem => Slot.Problem;

        /// <summary>The carved volume on the CPU, as it would be shown now; for pointers. Null while no volume is loaded.</summary>
        public CarvedField Field => field.Of(Inputs);

        /// <summary>How rays are marched and when a segment counts as visible, for pointers that find what the picture shows.</summary>
        public RaySettings RaySettings => quality.RaySettings;

        GpuSlot Slot => slot ??= new GpuSlot(this);

        VolumeInputs Inputs => Volume is { } volume
            ? new VolumeInputs(volume, transform.localToWorldMatrix, CarvingOf(volume), TransferFunction, Segments, quality, shading)
            : default;

        /// <summary>Makes a camera's picture. Each camera has a picture of its own, which is used again.</summary>
        /// <param name="camera">The camera; enabled or not.</param>
        /// <param name="width">Width in pixels; 0 = the camera's. Its projection is the camera's, so keep the camera's aspect.</param>
        /// <param name="height">Height in pixels; 0 = the camera's.</param>
        /// <returns>The picture; null while there is nothing to show: no volume, a scale of 0, no pixel, disabled, or a device that cannot (see <see cref="Problem"/>;
        /// it is tried again after <see cref="ReleaseResources"/>).</returns>
        /// <exception cref="ArgumentNullException"><paramref name="camera"/> is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException">A side is longer than the device's textures.</exception>
        public CarvedPicture Render(Camera camera, int width = 0, int height = 0)
        {
            if (camera == null)
                throw new ArgumentNullException(nameof(camera));
            VolumeInputs inputs = Inputs;
            (width, height) = (width > 0 ? width : camera.pixelWidth, height > 0 ? height : camera.pixelHeight);
            if (width < 1 || height < 1 || !IsShown(inputs) || !inputs.HasExtent)
                return null;
            PictureRayBundle rays = CameraRays.Bundle(camera, inputs, width, height);
            return Slot.Render(inputs, rays, CountSamples, Slot.Gpu.Pictures.Of(camera));
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
            VolumeInputs inputs = Inputs;
            return IsShown(inputs) ? Slot.Render(inputs, new PictureRayBundle(rays), CountSamples, picture ?? Slot.Gpu.Pictures.OfRays()) : null;
        }

        /// <summary>Frees all GPU memory; the next picture takes it again. Pictures that this renderer returned are freed too.</summary>
        public void ReleaseResources() => Slot.Release();

        void OnEnable()
        {
            surface = new VolumeSurface(gameObject);
            cameras ??= new CameraEvents(this, BeforeCamera);
            cameras.Listen();
        }

        void LateUpdate()
        {
            SegmentedVolume volume = Volume; // a volume is large: none is held that is not shown
            Slot.KeepOnly(volume);
            field.KeepOnly(volume);
            settings.KeepOnly(volume);
            Slot.Gpu?.Pictures.DropGone();
            Place(volume, transform.localToWorldMatrix); // here already, so that the renderer's bounds are known before cameras cull
        }

        void OnDisable()
        {
            cameras.Stop();
            ReleaseResources();
            field.KeepOnly(null);
        }

        void OnValidate()
        {
            quality?.Clamp();
            shading?.Clamp();
            appearance?.Clamp();
        }

        /// <summary>Called as a camera that sees this layer begins to render, after everything has moved and before it culls.</summary>
        void BeforeCamera(Camera camera)
        {
            VolumeInputs inputs = Inputs;
            if (Place(inputs.Volume, inputs.ToWorld) && IsShown(inputs))
                Slot.Bind(inputs);
        }

        bool Place(SegmentedVolume volume, in Matrix4x4 toWorld) =>
            Slot.Place(surface, drawInCameras && VolumeSpace.WorldScale(toWorld) != 0, volume, layout);

        bool IsShown(in VolumeInputs inputs) => isActiveAndEnabled && Slot.Update(inputs, layout) != null;

        CarvingSnapshot CarvingOf(SegmentedVolume volume) =>
            Stack != null && Stack.Carving != null && Stack.Loader.Volume == volume ? Stack.Carving.State : null;
    }
}
