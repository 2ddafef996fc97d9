using AnatomyCarve.Carving;

namespace AnatomyCarve
{
    /// <summary>
    /// What a volume will take on the GPU at most, counted before anything is made: <see cref="RenderStatistics.VolumeBytesResident"/> afterwards, where matter comes
    /// near all of the volume's faces, with at most 16 clip spheres that meet at most 64 bricks.
    /// </summary>
    static class VolumeGpuBytes
    {
        /// <param name="sizeI">Voxels along i.</param>
        /// <param name="sizeJ">Voxels along j.</param>
        /// <param name="sizeK">Voxels along k.</param>
        /// <param name="segments">Rows of the segment table.</param>
        /// <param name="layout">Compact or portable.</param>
        /// <param name="labelsIn8Bits">Whether labels take 8 bits: <see cref="DeviceSupport.LabelsIn8Bits"/>.</param>
        public static long Of(int sizeI, int sizeJ, int sizeK, int segments, TextureLayout layout, bool labelsIn8Bits) =>
            VolumeTextureForm.Intensity.Bytes(sizeI, sizeJ, sizeK)
            + VolumeTextureForm.Labels(labelsIn8Bits).Bytes(sizeI, sizeJ, sizeK)
            + 2 * VolumeTextureForm.Opacity(layout).Bytes(sizeI, sizeJ, sizeK)
            + VolumeTextureForm.Normals(layout).Bytes(sizeI, sizeJ, sizeK)
            + LookupTextures.BytesOf(segments)
            + SphereBuffers.FirstBytesOf(segments)
            + SkipStructure.BytesOf(sizeI, sizeJ, sizeK)
            + BrickWork.FirstBytesOf(BrickGrid.CountOf(sizeI, sizeJ, sizeK));
    }
}
