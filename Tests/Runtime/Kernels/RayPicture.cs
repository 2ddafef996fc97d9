using System.Linq;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>What Raymarch wrote for a scene; pixel (x, y) is element x + width * y, row 0 at the bottom.</summary>
    sealed class RayPicture
    {
        public Vector4[] Colors { get; private set; }

        public float[] DepthsMm { get; private set; }

        public uint[] Segments { get; private set; }

        /// <summary>Samples per group of 8x8 pixels; null when not counted.</summary>
        public uint[] SampleCounts { get; private set; }

        public static RayPicture Render(RayScene scene, GraphicsFormat opacityFormat = GraphicsFormat.R32_SFloat, bool countSamples = false)
        {
            using (KernelRig rig = KernelRig.Raymarch(countSamples, opacityFormat == GraphicsFormat.R32_UInt))
            {
                int groupsX = (scene.Width + 7) / 8, groupsY = (scene.Height + 7) / 8;
                scene.Bind(rig, opacityFormat);
                if (countSamples)
                    rig.SetRows("_SampleCounts", new uint[2 * groupsX * groupsY]);
                RenderTexture colors = rig.PictureTarget("_ColorOut", GraphicsFormat.R32G32B32A32_SFloat, scene.Width, scene.Height);
                RenderTexture depths = rig.PictureTarget("_DepthOut", GraphicsFormat.R32_SFloat, scene.Width, scene.Height);
                RenderTexture segments = rig.PictureTarget("_SegmentOut", GraphicsFormat.R32_UInt, scene.Width, scene.Height);
                rig.Dispatch(groupsX, groupsY);
                return new RayPicture
                {
                    Colors = KernelRig.Read<Vector4>(colors),
                    DepthsMm = KernelRig.Read<float>(depths),
                    Segments = KernelRig.Read<uint>(segments),
                    SampleCounts = countSamples ? rig.ReadRows("_SampleCounts").Where((_, n) => n % 2 == 0).ToArray() : null,
                };
            }
        }
    }
}
