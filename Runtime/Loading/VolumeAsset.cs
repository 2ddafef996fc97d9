using System;
using System.Collections.Generic;
using AnatomyCarve.Formats;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// A scan with its segmentation as an asset of the project: packed, so that it loads without parsing a medical format, and with what people want to
    /// know of it. The Editor's importers make it of NIfTI and NRRD files. It holds no folders and nothing of what headers say about patients.
    /// </summary>
    public sealed class VolumeAsset : ScriptableObject
    {
        const int ThumbnailSize = 128;

        [SerializeField, Tooltip("The packed volume's bytes")]
        TextAsset data;

        [SerializeField, HideInInspector, Tooltip("A checksum of these bytes")]
        long checksum;

        [SerializeField, Tooltip("A picture of the volume from the patient's front, left and above")]
        Texture2D thumbnail;

        [SerializeField, Tooltip("Voxels along the three axes")]
        Vector3Int size;

        [SerializeField, Tooltip("Distance between voxels along the three axes, mm")]
        Vector3 spacingMm;

        [SerializeField, Tooltip("The direction that each axis runs to: L/R, P/A, S/I")]
        string orientation = "";

        [SerializeField, Tooltip("The same in a sentence")]
        string orientationSentence = "";

        [SerializeField, Tooltip("The smallest intensity")]
        double valueMin;

        [SerializeField, Tooltip("The largest intensity")]
        double valueMax;

        [SerializeField, Tooltip("Width of the histogram's bins")]
        double binWidth = 1;

        [SerializeField, Tooltip("Voxels in each of the histogram's bins")]
        long[] bins = { 0 };

        [SerializeField, Tooltip("The segments, label 0 first")]
        VolumeAssetSegment[] segments = Array.Empty<VolumeAssetSegment>();

        [SerializeField, Tooltip("The files that it was made of, without folders")]
        string[] sources = Array.Empty<string>();

        [SerializeField, Tooltip("What was odd in the files")]
        string[] warnings = Array.Empty<string>();

        IntensityHistogram histogram;
        bool ownsParts;

        /// <summary>The packed volume's bytes (<see cref="PackedVolume"/>).</summary>
        public TextAsset Data => data;

        /// <summary>A checksum of the packed volume: another one when the file was imported anew with other voxels or settings.</summary>
        internal long Checksum => checksum;

        /// <summary>A picture of the volume from the patient's front, left and above: sRGB, transparent behind it.</summary>
        public Texture2D Thumbnail => thumbnail;

        /// <summary>Voxels along the three axes.</summary>
        public Vector3Int Size => size;

        /// <summary>Distance between voxels along the three axes, mm.</summary>
        public Vector3 SpacingMm => spacingMm;

        /// <summary>The direction that each axis runs to, such as LPS: patient's left or right, posterior or anterior, superior or inferior.</summary>
        public string Orientation => orientation;

        /// <summary>What <see cref="Orientation"/> means, in a sentence.</summary>
        public string OrientationSentence => orientationSentence;

        /// <summary>The smallest intensity, in the scan's unit (Hounsfield units of a CT).</summary>
        public double ValueMin => valueMin;

        /// <summary>The largest intensity, in the scan's unit.</summary>
        public double ValueMax => valueMax;

        /// <summary>How often which intensities occur.</summary>
        public IntensityHistogram Histogram => histogram ?? (histogram = new IntensityHistogram(valueMin, valueMax, binWidth, bins));

        /// <summary>The segments in the order of the volume's table: label 0 first, then ascending labels.</summary>
        public IReadOnlyList<VolumeAssetSegment> Segments => segments;

        /// <summary>The files that it was made of, without folders: the scan, then the segmentation.</summary>
        public IReadOnlyList<string> Sources => sources;

        /// <summary>What was odd in the files, a sentence each.</summary>
        public IReadOnlyList<string> Warnings => warnings;

        /// <summary>Bytes of the packed volume.</summary>
        public long PackedBytes => data != null ? data.dataSize : 0;

        /// <summary>Bytes of the voxels in memory once it is loaded: two for the intensity and two for the segment of each.</summary>
        public long UnpackedBytes => (long)size.x * size.y * size.z * (sizeof(ushort) + sizeof(ushort));

        /// <summary>
        /// Makes an asset of a volume at run time. Packing and the picture take about as long as loading did; call it on the main thread. Destroy it like any
        /// object; its parts go with it.
        /// </summary>
        /// <param name="volume">The volume.</param>
        /// <param name="name">The asset's name.</param>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null.</exception>
        /// <exception cref="AnatomyCarveException">The volume takes more bytes than one array holds (2 GiB).</exception>
        public static VolumeAsset Create(SegmentedVolume volume, string name = "Volume")
        {
            byte[] packed = PackedVolume.Write(volume);
            VolumeAsset asset = Create(volume, packed, VolumeThumbnail.Render(volume, ThumbnailSize), Array.Empty<string>());
            asset.name = name;
            asset.ownsParts = true;
            return asset;
        }

        /// <summary>The same of parts that were made elsewhere. Whoever calls owns the asset, its bytes and its picture.</summary>
        /// <param name="volume">The volume.</param>
        /// <param name="packed">The volume, packed.</param>
        /// <param name="picture">Its square picture, RGBA, bottom row first.</param>
        /// <param name="sources">The files that it was made of, without folders.</param>
        internal static VolumeAsset Create(SegmentedVolume volume, byte[] packed, byte[] picture, string[] sources)
        {
            var asset = CreateInstance<VolumeAsset>();
            asset.data = new TextAsset(packed) { name = "data" };
            asset.checksum = (long)PackedVolume.Checksum(packed);
            asset.thumbnail = Picture(picture);
            VolumeGeometry g = volume.Geometry;
            asset.size = new Vector3Int(g.SizeI, g.SizeJ, g.SizeK);
            asset.spacingMm = new Vector3((float)g.SpacingMm.X, (float)g.SpacingMm.Y, (float)g.SpacingMm.Z);
            asset.orientation = g.OrientationCode;
            asset.orientationSentence = AxisDirections.Sentence(g.OrientationCode);
            asset.SetHistogram(volume.Histogram);
            asset.segments = AssetSegments.Of(volume.Labels);
            asset.sources = sources;
            asset.warnings = new List<string>(volume.Warnings).ToArray();
            return asset;
        }

        /// <summary>
        /// A copy of the packed bytes. Call it on the main thread; <see cref="PackedVolume.Read(ReadOnlyMemory{byte}, string,
        /// System.Threading.CancellationToken, IProgress{float})"/> may then read them on any. It is a copy because the engine frees an asset's own bytes
        /// when it unloads or imports it anew, whoever reads them.
        /// </summary>
        /// <exception cref="AnatomyCarveException">The asset holds no bytes.</exception>
        internal ReadOnlyMemory<byte> Open()
        {
            if (data == null)
                throw HoldsNoVolume(name);
            return data.bytes;
        }

        internal static AnatomyCarveException HoldsNoVolume(string name) => new AnatomyCarveException($"{name}: the asset holds no volume. Import its file anew.");

        // The fields may be another import's.
        void OnEnable() => histogram = null;

        void OnValidate() => histogram = null;

        void OnDestroy()
        {
            if (!ownsParts)
                return;
            GpuObjects.Destroy(data);
            GpuObjects.Destroy(thumbnail);
        }

        static Texture2D Picture(byte[] rgba)
        {
            int side = (int)Math.Sqrt(rgba.Length / 4);
            var picture = new Texture2D(side, side, TextureFormat.RGBA32, false) { name = "thumbnail", wrapMode = TextureWrapMode.Clamp };
            picture.SetPixelData(rgba, 0);
            picture.Apply(false);
            return picture;
        }

        void SetHistogram(IntensityHistogram source)
        {
            histogram = source;
            valueMin = source.ValueMin;
            valueMax = source.ValueMax;
            binWidth = source.BinWidth;
            bins = new List<long>(source.Counts).ToArray();
        }
    }
}
