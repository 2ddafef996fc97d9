using System;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>One brick's codes as far as they are known.</summary>
    class VoxelCache
    {
        const int BitsPerWord = 64;
        const int ObjectsBytes = 128; // the runtime's own share: the headers of this, its arrays and its list

        readonly byte[] codes = new byte[BrickGrid.VoxelsPerBrick];
        readonly ulong[] known = new ulong[BrickGrid.VoxelsPerBrick / BitsPerWord];

        /// <summary>What it holds in memory, closely.</summary>
        public virtual long Bytes => BrickGrid.VoxelsPerBrick + BrickGrid.VoxelsPerBrick / 8 + ObjectsBytes;

        public bool TryGet(int voxel, out byte code)
        {
            code = codes[voxel];
            return (known[voxel / BitsPerWord] >> (voxel % BitsPerWord) & 1) != 0;
        }

        public byte Keep(int voxel, byte code)
        {
            codes[voxel] = code;
            known[voxel / BitsPerWord] |= 1UL << (voxel % BitsPerWord);
            return code;
        }

        public virtual void Forget() => Array.Clear(known, 0, known.Length);
    }

    /// <summary>One brick's opacity codes, and the spheres that can touch its voxels.</summary>
    sealed class OpacityCache : VoxelCache
    {
        readonly List<CentredSphere> reaching = new List<CentredSphere>();
        bool isSifted;

        public override long Bytes => base.Bytes + (long)reaching.Capacity * CentredSphere.Bytes;

        /// <summary>The spheres that can touch a voxel of the brick, sifted from all when first asked for.</summary>
        public List<CentredSphere> Reaching(VoxelOpacity opacity, int brickX, int brickY, int brickZ)
        {
            if (!isSifted)
                opacity.FindReaching(brickX, brickY, brickZ, reaching);
            isSifted = true;
            return reaching;
        }

        public override void Forget()
        {
            base.Forget();
            isSifted = false;
        }
    }
}
