using System;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// A picture of a carved volume on the GPU: colour, depth and first visible segment, made in the size of the first rendering and again
    /// when the size changes. Row 0 is the bottom row. Use it on the main thread.
    /// </summary>
    public sealed class CarvedPicture : IDisposable
    {
        /// <summary>Samples and look-ups.</summary>
        const int CountsPerGroup = 2;

        readonly string name;
        PictureInputs shown;
        uint[] noSamples;
        bool isShown;

        /// <summary>A picture without pixels yet, to render into with <see cref="CarvedVolumeRenderer"/>. Dispose it when done.</summary>
        /// <param name="name">A name for frame debuggers.</param>
        public CarvedPicture(string name = "AnatomyCarve picture") => this.name = name ?? throw new ArgumentNullException(nameof(name));

        /// <summary>Width in pixels; 0 before the first rendering.</summary>
        public int Width { get; private set; }

        /// <summary>Height in pixels; 0 before the first rendering.</summary>
        public int Height { get; private set; }

        /// <summary>Colour: R16G16B16A16_SFloat, linear, premultiplied by alpha. Null before the first rendering.</summary>
        public RenderTexture ColorTexture { get; private set; }

        /// <summary>
        /// Depth of the first visible segment: R32_SFloat, patient's millimetres along the ray from its origin; infinite where there is none.
        /// Null before the first rendering.
        /// </summary>
        public RenderTexture DepthTexture { get; private set; }

        /// <summary>First visible segment: R32_UInt, its index in the segment table; 65535 where there is none. Null before the first rendering.</summary>
        public RenderTexture SegmentTexture { get; private set; }

        /// <summary>
        /// What hides the volume: a texture of the picture's size with one float per pixel, in the rays' t (for cameras the depth along the view in
        /// world units). Null = nothing. The picture is made anew in each rendering while it is set, as its contents may have changed. A texture of another
        /// size is refused with an <see cref="ArgumentException"/> when the picture is rendered.
        /// </summary>
        public Texture SceneDepth { get; set; }

        /// <summary>Rises each time the kernel has written the picture.</summary>
        public int Version { get; private set; }

        internal GraphicsBuffer SampleCounts { get; private set; }

        internal long Bytes => (8L + 4L + 4L) * Width * Height + (SampleCounts == null ? 0 : (long)SampleCounts.count * SampleCounts.stride);

        internal string Name => name;

        /// <summary>Reads the picture. It waits until the GPU is done, so it is for tools and tests; a running scene uses <see cref="ReadAsync"/>.</summary>
        /// <exception cref="InvalidOperationException">Nothing was rendered into it yet.</exception>
        /// <exception cref="AnatomyCarveException">The device could not deliver it.</exception>
        public PictureData Read()
        {
            CheckReadable();
            AsyncGPUReadbackRequest color = AsyncGPUReadback.Request(ColorTexture, 0);
            AsyncGPUReadbackRequest depth = AsyncGPUReadback.Request(DepthTexture, 0);
            AsyncGPUReadbackRequest segment = AsyncGPUReadback.Request(SegmentTexture, 0);
            color.WaitForCompletion();
            depth.WaitForCompletion();
            segment.WaitForCompletion();
            var data = new PictureData(Width, Height);
            data.TakeColor(color);
            data.TakeDepth(depth);
            data.TakeSegments(segment);
            return data;
        }

        /// <summary>Reads the picture as it is now, without waiting for the GPU: the result comes some frames later, on the main thread.</summary>
        /// <exception cref="InvalidOperationException">Nothing was rendered into it yet.</exception>
        /// <exception cref="AnatomyCarveException">The device could not deliver it.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public Task<PictureData> ReadAsync(CancellationToken cancellationToken = default)
        {
            CheckReadable();
            cancellationToken.ThrowIfCancellationRequested();
            var data = new PictureData(Width, Height);
            var result = new TaskCompletionSource<PictureData>();
            int missing = 3;
            void Arrived(AsyncGPUReadbackRequest request, Action<AsyncGPUReadbackRequest> take)
            {
                try
                {
                    take(request);
                    if (cancellationToken.IsCancellationRequested)
                        result.TrySetCanceled(cancellationToken);
                    else if (--missing == 0)
                        result.TrySetResult(data);
                }
                catch (Exception e)
                {
                    result.TrySetException(e);
                }
            }
            AsyncGPUReadback.Request(ColorTexture, 0, request => Arrived(request, data.TakeColor));
            AsyncGPUReadback.Request(DepthTexture, 0, request => Arrived(request, data.TakeDepth));
            AsyncGPUReadback.Request(SegmentTexture, 0, request => Arrived(request, data.TakeSegments));
            return result.Task;
        }

        /// <summary>How many opacity samples the rays took, where they were counted; -1 where not. Waits until the GPU is done.</summary>
        public long ReadSampleCount() => ReadCount(0);

        /// <summary>How many texels of the skip structure the rays read, where work was counted; -1 where not. Waits until the GPU is done.</summary>
        public long ReadLookupCount() => ReadCount(1);

        /// <summary>Frees the textures. The picture may be rendered into again.</summary>
        public void Dispose()
        {
            GpuObjects.Destroy(ColorTexture);
            GpuObjects.Destroy(DepthTexture);
            GpuObjects.Destroy(SegmentTexture);
            SampleCounts?.Release();
            ColorTexture = null;
            DepthTexture = null;
            SegmentTexture = null;
            SampleCounts = null;
            Width = 0;
            Height = 0;
            isShown = false;
            shown = default;
        }

        internal void Resize(int width, int height, bool countSamples)
        {
            if (width < 1 || height < 1 || width > SystemInfo.maxTextureSize || height > SystemInfo.maxTextureSize)
                throw new ArgumentOutOfRangeException(
                    nameof(width), $"{width} x {height}", $"A picture has 1 to {SystemInfo.maxTextureSize} pixels along an axis.");
            bool lost = ColorTexture == null || DepthTexture == null || SegmentTexture == null
                || !ColorTexture.IsCreated() || !DepthTexture.IsCreated() || !SegmentTexture.IsCreated();
            if (lost || width != Width || height != Height || countSamples != (SampleCounts != null) || (SampleCounts != null && !SampleCounts.IsValid()))
            {
                Dispose();
                try
                {
                    Make(width, height, countSamples);
                }
                catch
                {
                    Dispose();
                    throw;
                }
            }
        }

        /// <exception cref="ArgumentException">The scene's depth does not fit a picture of this size.</exception>
        internal void CheckSceneDepth(int width, int height)
        {
            if (SceneDepth != null && (SceneDepth.dimension != TextureDimension.Tex2D || SceneDepth.width != width || SceneDepth.height != height))
                throw new ArgumentException(
                    $"The scene's depth '{SceneDepth.name}' is a {SceneDepth.dimension} texture of {SceneDepth.width} x {SceneDepth.height} pixels; "
                    + $"the picture '{name}' needs Tex2D, {width} x {height}.", nameof(SceneDepth));
        }

        /// <summary>The kernel adds to the counts.</summary>
        internal void ClearSampleCounts()
        {
            if (SampleCounts == null)
                return;
            if (noSamples == null || noSamples.Length != SampleCounts.count)
                noSamples = new uint[SampleCounts.count];
            SampleCounts.SetData(noSamples);
        }

        internal bool Shows(in PictureInputs inputs) => isShown && !inputs.HaveSceneDepth && shown.Equals(inputs);

        internal void SetShown(in PictureInputs inputs)
        {
            shown = inputs;
            isShown = true;
            Version++;
        }

        long ReadCount(int kind)
        {
            if (SampleCounts == null || !isShown)
                return -1;
            var counts = new uint[SampleCounts.count];
            SampleCounts.GetData(counts);
            long sum = 0;
            for (int n = kind; n < counts.Length; n += CountsPerGroup)
                sum += counts[n];
            return sum;
        }

        void Make(int width, int height, bool countSamples)
        {
            Width = width;
            Height = height;
            ColorTexture = Create("colour", GraphicsFormat.R16G16B16A16_SFloat, FilterMode.Bilinear);
            DepthTexture = Create("depth", GraphicsFormat.R32_SFloat, FilterMode.Point);
            SegmentTexture = Create("segments", GraphicsFormat.R32_UInt, FilterMode.Point);
            if (countSamples)
                SampleCounts = GpuObjects.CreateBuffer(name + " samples", CountsPerGroup * Raymarcher.Groups(width) * Raymarcher.Groups(height), sizeof(uint));
        }

        RenderTexture Create(string part, GraphicsFormat format, FilterMode filter)
        {
            var descriptor = new RenderTextureDescriptor(Width, Height, format, 0) { enableRandomWrite = true, msaaSamples = 1 };
            return GpuObjects.CreateWritable(descriptor, name + " " + part, filter);
        }

        void CheckReadable()
        {
            if (!isShown)
                throw new InvalidOperationException($"Nothing has been rendered into '{name}' yet.");
            if (!SystemInfo.supportsAsyncGPUReadback)
                throw new AnatomyCarveException($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) cannot read textures back.");
        }
    }
}
