using System;

namespace UnityEngine.Vulkan
{
    /// <summary>The images that a pass draws into, and which part of them.</summary>
    sealed class PassTarget
    {
        const uint BothViews = 3;

        /// <param name="colors">None for depth alone.</param>
        /// <param name="resolves">Where multisampled colours go at the end of the pass; as many as colours, or none.</param>
        /// <param name="depth">Null if there is none.</param>
        /// <param name="mip">The mip level of all of them.</param>
        /// <param name="layer">The first layer of all of them.</param>
        /// <param name="layers">How many layers; with a view mask those that its bits name.</param>
        /// <param name="viewMask">One bit per view of a multiview pass; 0 for any other.</param>
        /// <param name="linear">Whether colours are written into sRGB images as they are.</param>
        /// <param name="viewsInTurn">Whether a device can draw one view of a pass only.</param>
        internal PassTarget(VulkanImage[] colors, VulkanImage[] resolves, VulkanImage depth, int mip, int layer, int layers, uint viewMask, bool linear,
            bool viewsInTurn = false)
        {
            Colors = colors;
            Resolves = resolves;
            Depth = depth;
            Mip = mip;
            Layer = layer;
            Layers = layers;
            ViewMask = viewMask;
            IsLinear = linear;
            var any = colors.Length > 0 ? colors[0] : depth ?? throw new ArgumentException("a pass needs an image", nameof(colors));
            (Width, Height, _) = any.Shape.Mip(mip);
            Samples = any.Samples;
            Passes = viewsInTurn && viewMask == BothViews
                ? Array.ConvertAll(new[] { 1u, 2u }, view => new PassTarget(colors, resolves, depth, mip, layer, layers, view, linear))
                : new[] { this };
        }

        /// <summary>What is recorded one after the other for it: itself, or its views.</summary>
        internal PassTarget[] Passes { get; }

        internal VulkanImage[] Colors { get; }

        internal VulkanImage[] Resolves { get; }

        internal VulkanImage Depth { get; }

        internal int Mip { get; }

        internal int Layer { get; }

        internal int Layers { get; }

        internal uint ViewMask { get; }

        internal bool IsLinear { get; }

        internal int Width { get; }

        internal int Height { get; }

        internal int Samples { get; }

        /// <summary>Layers that a framebuffer has: views are no layers of it.</summary>
        internal int FramebufferLayers => ViewMask != 0 ? 1 : Layers;

        /// <summary>The render pass that fits it; 0 until it was asked for.</summary>
        internal ulong RenderPass { get; set; }

        /// <summary>The format in which a colour is written.</summary>
        internal uint FormatOf(VulkanImage color) => IsLinear ? color.LinearFormat : color.Format;

        /// <summary>Whether the image is drawn into.</summary>
        internal bool Has(VulkanResource image) =>
            Depth == image || Array.IndexOf(Colors, image) >= 0 || Array.IndexOf(Resolves, image) >= 0;

        internal bool IsSameAs(PassTarget other)
        {
            if (ReferenceEquals(this, other))
                return true;
            if (other == null || Depth != other.Depth || Mip != other.Mip || Layer != other.Layer || Layers != other.Layers
                || ViewMask != other.ViewMask || IsLinear != other.IsLinear
                || Colors.Length != other.Colors.Length || Resolves.Length != other.Resolves.Length)
                return false;
            for (var i = 0; i < Colors.Length; i++)
                if (Colors[i] != other.Colors[i] || (Resolves.Length > 0 && Resolves[i] != other.Resolves[i]))
                    return false;
            return true;
        }
    }
}
