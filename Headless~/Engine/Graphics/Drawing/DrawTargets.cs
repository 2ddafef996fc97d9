using System;
using System.Collections.Generic;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>What drawing goes into at the moment.</summary>
    static class DrawTargets
    {
        /// <summary>Stands for all slices of an array.</summary>
        internal const int AllSlices = -1;

        static RenderTexture[] s_Colors = { null };
        static RenderTexture s_Depth;
        static int s_Mip;
        static int s_Slice;
        static bool s_Multiview;
        static bool s_WritesSRGB = true;
        static PassTarget s_Resolved;
        static ulong s_ResolvedFor;

        /// <summary>The first colour target; null for the screen.</summary>
        internal static RenderTexture Color => s_Colors.Length > 0 ? s_Colors[0] : s_Depth;

        internal static bool IsScreen => Color == null;

        internal static int Mip => s_Mip;

        /// <summary>The slice of an array, or <see cref="AllSlices"/>.</summary>
        internal static int Slice => s_Slice;

        /// <summary>Pixels from the lower left.</summary>
        internal static Rect Viewport { get; set; }

        /// <summary>Null: the whole viewport.</summary>
        internal static Rect? Scissor { get; set; }

        internal static bool InvertCulling { get; set; }

        internal static bool WritesSRGB
        {
            get => s_WritesSRGB;
            set
            {
                if (s_WritesSRGB == value)
                    return;
                s_WritesSRGB = value;
                s_Resolved = null;
            }
        }

        // The screen's size is known without a device.
        internal static int Width => IsScreen ? Screen.width : Math.Max(1, Color.width >> s_Mip);

        internal static int Height => IsScreen ? Screen.height : Math.Max(1, Color.height >> s_Mip);

        /// <summary>Whether the first row of the target's memory is the bottom of the picture: all but the screen.</summary>
        internal static bool IntoTexture => !IsScreen;

        /// <summary>A texture with its own depth; null for the screen.</summary>
        internal static void Set(RenderTexture texture, int mip, int slice) => Set(new[] { texture }, texture, mip, slice);

        /// <param name="colors">Null stands for the screen; none for depth alone.</param>
        /// <param name="depth">Null for none, or for the screen's.</param>
        /// <param name="mip">The mip level.</param>
        /// <param name="slice">The slice of an array, or all.</param>
        /// <param name="multiview">Whether a draw goes to both slices by views.</param>
        internal static void Set(RenderTexture[] colors, RenderTexture depth, int mip, int slice, bool multiview = false)
        {
            foreach (var color in colors)
                if (color is not null)
                    color.Create();
            if (depth is not null)
                depth.Create();
            (s_Colors, s_Depth, s_Mip, s_Slice, s_Multiview) = (colors, depth, mip, slice, multiview);
            s_Resolved = null;
            s_WritesSRGB = ColorSpaces.IsLinear;
            ResetViewport();
        }

        /// <summary>A texture loses its memory: it is no target any more.</summary>
        internal static void Drop(RenderTexture texture)
        {
            if (ReferenceEquals(s_Depth, texture) || Array.IndexOf(s_Colors, texture) >= 0)
                Set(null, 0, 0);
        }

        /// <summary>The same targets and view again, after others were set in between.</summary>
        internal static Action Remember()
        {
            var (colors, depth, mip, slice, multiview, viewport, view) = (s_Colors, s_Depth, s_Mip, s_Slice, s_Multiview, Viewport, Drawer.View);
            return () =>
            {
                Set(colors, depth, mip, slice, multiview);
                Viewport = viewport;
                Drawer.View = view;
            };
        }

        internal static void ResetViewport()
        {
            Viewport = new Rect(0, 0, Width, Height);
            Scissor = null;
        }

        /// <summary>The images; null, with an error in the log, if there is nothing to draw into.</summary>
        internal static PassTarget Resolve()
        {
            var state = State();
            if (s_Resolved != null && s_ResolvedFor == state)
                return s_Resolved;
            s_Resolved = Build();
            s_ResolvedFor = state;
            return s_Resolved;
        }

        /// <summary>A rectangle in pixels from the lower left, in rows of the target's memory.</summary>
        internal static VkRect2D ToMemory(Rect rect)
        {
            var x0 = Mathf.Clamp(Mathf.RoundToInt(rect.x), 0, Width);
            var x1 = Mathf.Clamp(Mathf.RoundToInt(rect.xMax), 0, Width);
            var y0 = Mathf.Clamp(Mathf.RoundToInt(rect.y), 0, Height);
            var y1 = Mathf.Clamp(Mathf.RoundToInt(rect.yMax), 0, Height);
            return new VkRect2D
            {
                x = x0,
                y = IntoTexture ? y0 : Height - y1,
                width = (uint)(x1 - x0),
                height = (uint)(y1 - y0),
            };
        }

        internal static void Clear(bool color, bool depth, bool stencil, Color value, float depthValue, uint stencilValue)
        {
            if (Resolve() is not { } target)
                return;
            var area = ToMemory(Viewport);
            if (area.width == 0 || area.height == 0)
                return;
            var clear = new ClearCommand
            {
                Color = color,
                Depth = depth,
                Stencil = stencil,
                // Near is 1 and far 0 in the buffer.
                DepthValue = 1f - Mathf.Clamp01(depthValue),
                StencilValue = stencilValue,
                Area = area,
                ColorValue = Value(value),
            };
            Gpu.Context.Stream.Pass(target).Add(clear);
        }

        internal static void Forget()
        {
            (s_Colors, s_Depth, s_Mip, s_Slice, s_Multiview) = (new RenderTexture[] { null }, null, 0, 0, false);
            s_Resolved = null;
            Scissor = null;
            InvertCulling = false;
            s_WritesSRGB = true;
        }

        static unsafe VkClearColorValue Value(Color color)
        {
            var clear = default(VkClearColorValue);
            var integer = s_Colors.Length > 0 && Existing(s_Colors[0]).ColorNative is { Format.IsInteger: true };
            for (var c = 0; c < 4; c++)
            {
                if (integer)
                    clear.int32[c] = (int)color[c];
                else
                    clear.float32[c] = color[c];
            }
            return clear;
        }

        // Changes when a target got new memory.
        static ulong State()
        {
            ulong state = 17;
            foreach (var color in s_Colors)
                state = state * 31 + (Existing(color)?.ColorNative?.Image.Handle ?? 0);
            return state * 31 + (Existing(s_Depth)?.DepthNative?.Image.Handle ?? 0);
        }

        static RenderTexture Existing(RenderTexture texture) => texture is null ? ScreenBuffer.Texture : texture;

        static PassTarget Build()
        {
            var colors = new List<VulkanImage>();
            var resolves = new List<VulkanImage>();
            foreach (var color in s_Colors)
            {
                var texture = Existing(color);
                if (texture.dimension == TextureDimension.Tex3D)
                    return Fail($"'{texture.NameForMessages}' is a volume, whose slices cannot be drawn into in this host");
                if (texture.ColorNative is not { } native)
                    continue;
                if (texture.MultisampledNative is { } samples)
                {
                    colors.Add(samples.Image);
                    resolves.Add(native.Image);
                }
                else
                    colors.Add(native.Image);
            }
            // Depth has no mip levels: only the first one is drawn with it.
            var depth = s_Mip > 0 ? null : DepthOf();
            if (colors.Count == 0 && depth == null)
                return Fail("the target is not created");
            var first = colors.Count > 0 ? colors[0] : depth.Image;
            var all = s_Slice == AllSlices;
            var (layer, layers) = all ? (0, first.Shape.Layers) : (s_Slice, 1);
            if (layer < 0 || layer >= first.Shape.Layers || s_Mip < 0 || s_Mip >= first.Shape.Mips)
                return Fail($"the target has no slice {layer} of mip level {s_Mip}");
            var linear = !s_WritesSRGB;
            return new PassTarget(colors.ToArray(), resolves.ToArray(), depth?.Image, s_Mip, layer, layers, s_Multiview ? (1u << layers) - 1 : 0, linear,
                Gpu.Context.Device.Abilities.DrawsOneViewOnly);
        }

        static GpuTexture DepthOf()
        {
            // Without a depth of its own the screen's belongs to the screen's colour only.
            if (s_Depth is null)
                return IsScreen ? ScreenBuffer.Texture.DepthNative : null;
            return s_Depth.DepthNative;
        }

        static PassTarget Fail(string problem)
        {
            Debug.LogError($"Drawing is impossible: {problem}.");
            return null;
        }
    }
}
