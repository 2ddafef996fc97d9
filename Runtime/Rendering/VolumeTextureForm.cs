using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// What one of a volume's textures is made of. All that a volume takes per voxel stands here: <see cref="VolumeTextures"/> makes its textures so, and
    /// <see cref="VolumeGpuBytes"/> counts them before they are made.
    /// </summary>
    readonly struct VolumeTextureForm
    {
        VolumeTextureForm(GraphicsFormat format, int bytesPerTexel, int voxelsPerTexel) =>
            (Format, BytesPerTexel, VoxelsPerTexel) = (format, bytesPerTexel, voxelsPerTexel);

        /// <summary>Codes of 16 bits.</summary>
        public static VolumeTextureForm Intensity => new VolumeTextureForm(GraphicsFormat.R16_UInt, 2, 1);

        public GraphicsFormat Format { get; }

        public int BytesPerTexel { get; }

        /// <summary>Voxels along k that share a texel.</summary>
        public int VoxelsPerTexel { get; }

        public static VolumeTextureForm Labels(bool in8Bits) =>
            in8Bits ? new VolumeTextureForm(GraphicsFormat.R8_UInt, 1, 1) : new VolumeTextureForm(GraphicsFormat.R16_UInt, 2, 1);

        /// <summary>Opacity, and anti-aliased opacity.</summary>
        public static VolumeTextureForm Opacity(TextureLayout layout) =>
            layout == TextureLayout.Portable ? new VolumeTextureForm(GraphicsFormat.R32_UInt, 4, 4) : new VolumeTextureForm(GraphicsFormat.R8_UNorm, 1, 1);

        public static VolumeTextureForm Normals(TextureLayout layout) =>
            layout == TextureLayout.Portable ? new VolumeTextureForm(GraphicsFormat.R32_UInt, 4, 2) : new VolumeTextureForm(GraphicsFormat.R8G8_UNorm, 2, 1);

        /// <summary>Texels along k.</summary>
        public int Depth(int sizeK) => (sizeK + VoxelsPerTexel - 1) / VoxelsPerTexel;

        /// <summary>The texture's bytes, without the driver's padding.</summary>
        public long Bytes(int sizeI, int sizeJ, int sizeK) => (long)sizeI * sizeJ * Depth(sizeK) * BytesPerTexel;
    }
}
