using System;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>A kernel in a volume's texture layout, found once, and its dispatch over a list of bricks.</summary>
    readonly struct ComputeKernel : IShaderValues
    {
        /// <summary>The most groups that a dispatch may have along one axis, on every graphics API.</summary>
        public const int MaxGroupsPerAxis = 65535;

        readonly int index;
        readonly LocalKeyword portableLayout;
        readonly bool hasLayouts, portable;

        /// <param name="shader">The shader.</param>
        /// <param name="name">Its kernel's name, and its own in messages.</param>
        /// <param name="layout">The volume's layout; automatic = the kernel does not touch what has a layout.</param>
        /// <exception cref="AnatomyCarveException">The shader is missing, or the device cannot run its kernel.</exception>
        public ComputeKernel(ComputeShader shader, string name, TextureLayout layout)
        {
            if (shader == null)
                throw new AnatomyCarveException($"The compute shader {name} is missing in AnatomyCarveShaders.asset: reimport the package.");
            if (!shader.HasKernel(name))
                throw new AnatomyCarveException($"The compute shader {name} has no kernel {name} on {SystemInfo.graphicsDeviceType}.");
            Shader = shader;
            index = shader.FindKernel(name);
            hasLayouts = layout != TextureLayout.Automatic;
            portable = layout == TextureLayout.Portable;
            portableLayout = hasLayouts ? new LocalKeyword(shader, ShaderIds.PortableLayout) : default;
            if (hasLayouts)
                shader.SetKeyword(portableLayout, portable);
            if (!shader.IsSupported(index))
                throw new AnatomyCarveException($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) cannot run the kernel {name}.");
        }

        public ComputeShader Shader { get; }

        public void SetVector(int id, Vector4 value) => Shader.SetVector(id, value);

        public void SetTexture(int id, Texture texture) => Shader.SetTexture(index, id, texture);

        public void SetBuffer(int id, GraphicsBuffer buffer) => Shader.SetBuffer(index, id, buffer);

        /// <summary>Has a kernel that can count its work add it to a buffer; null = it does not count.</summary>
        public void Count(GraphicsBuffer counts)
        {
            if (counts == null)
            {
                Shader.DisableKeyword(ShaderIds.CountWork);
                return;
            }
            Shader.EnableKeyword(ShaderIds.CountWork);
            SetBuffer(ShaderIds.WorkCounts, counts);
        }

        /// <summary>The shader is shared by volumes of either layout, so its keyword is set each time.</summary>
        public void Dispatch(int groupsX, int groupsY, int groupsZ = 1)
        {
            if (hasLayouts)
                Shader.SetKeyword(portableLayout, portable);
            Shader.Dispatch(index, groupsX, groupsY, groupsZ);
        }

        /// <summary>How a dispatch over a number of bricks is split into rows, so that no axis has more groups than allowed.</summary>
        /// <exception cref="ArgumentOutOfRangeException">More bricks than rows of groups can hold.</exception>
        public static (int perRow, int rows) SplitGroups(int bricks)
        {
            if (bricks < 1)
                throw new ArgumentOutOfRangeException(nameof(bricks), bricks, "A dispatch needs 1 brick at least.");
            int rows = (int)(((long)bricks + MaxGroupsPerAxis - 1) / MaxGroupsPerAxis);
            return ((int)(((long)bricks + rows - 1) / rows), rows);
        }
    }
}
