using System;
using UnityEngine.Rendering;
using UnityEngine.Shaders;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>A pass's fixed states with the values of a material's properties in place.</summary>
    struct DrawState
    {
        internal CullMode Cull;
        internal CompareFunction ZTest;
        internal bool ZWrite;
        internal bool ZClip;
        internal bool AlphaToMask;
        internal ColorWriteMask Mask;
        internal bool Blends;
        internal BlendMode SourceColor;
        internal BlendMode TargetColor;
        internal BlendMode SourceAlpha;
        internal BlendMode TargetAlpha;
        internal BlendOp ColorOperation;
        internal BlendOp AlphaOperation;
        internal float OffsetFactor;
        internal float OffsetUnits;

        /// <summary>All that a pipeline depends on, as one number; the offset is set with each draw.</summary>
        internal readonly ulong Key
        {
            get
            {
                ulong key = 0;
                void Add(int value, int bits) => key = (key << bits) | (uint)value & ((1u << bits) - 1);
                Add((int)Cull, 2);
                Add((int)ZTest, 4);
                Add(ZWrite ? 1 : 0, 1);
                Add(ZClip ? 1 : 0, 1);
                Add(AlphaToMask ? 1 : 0, 1);
                Add((int)Mask, 4);
                Add(Blends ? 1 : 0, 1);
                Add((int)SourceColor, 4);
                Add((int)TargetColor, 4);
                Add((int)SourceAlpha, 4);
                Add((int)TargetAlpha, 4);
                Add((int)ColorOperation, 3);
                Add((int)AlphaOperation, 3);
                return key;
            }
        }

        /// <param name="state">As written.</param>
        /// <param name="property">The value of a property by its ID.</param>
        internal static DrawState Of(ShaderLabState state, Func<int, float> property)
        {
            float Float(in StateValue value) => value.Property == null ? value.Number : property(value.PropertyId);
            int Number(in StateValue value) => Mathf.RoundToInt(Float(value));
            return new DrawState
            {
                Cull = (CullMode)Number(state.Cull),
                ZTest = (CompareFunction)Number(state.ZTest),
                ZWrite = Float(state.ZWrite) != 0,
                ZClip = Float(state.ZClip) != 0,
                AlphaToMask = Float(state.AlphaToMask) != 0,
                Mask = (ColorWriteMask)Number(state.ColorMask),
                Blends = state.Blends,
                SourceColor = (BlendMode)Number(state.SourceColor),
                TargetColor = (BlendMode)Number(state.TargetColor),
                SourceAlpha = (BlendMode)Number(state.SourceAlpha),
                TargetAlpha = (BlendMode)Number(state.TargetAlpha),
                ColorOperation = (BlendOp)Number(state.ColorOperation),
                AlphaOperation = (BlendOp)Number(state.AlphaOperation),
                OffsetFactor = Float(state.OffsetFactor),
                OffsetUnits = Float(state.OffsetUnits),
            };
        }

        internal readonly VkPipelineDepthStencilStateCreateInfo DepthStencil => new()
        {
            sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
            depthTestEnable = ZTest == CompareFunction.Disabled ? 0u : 1u,
            depthWriteEnable = ZWrite ? 1u : 0u,
            depthCompareOp = Reversed(ZTest),
            maxDepthBounds = 1,
        };

        /// <summary>Of one colour target; a target that the shader does not write keeps what it has.</summary>
        internal readonly VkPipelineColorBlendAttachmentState Blend(bool written, bool integer) => new()
        {
            blendEnable = Blends && !integer ? 1u : 0u,
            srcColorBlendFactor = Factor(SourceColor, false),
            dstColorBlendFactor = Factor(TargetColor, false),
            colorBlendOp = Operation(ColorOperation),
            srcAlphaBlendFactor = Factor(SourceAlpha, true),
            dstAlphaBlendFactor = Factor(TargetAlpha, true),
            alphaBlendOp = Operation(AlphaOperation),
            colorWriteMask = written ? WriteMask(Mask) : 0,
        };

        internal readonly uint CullMode => Cull switch
        {
            Rendering.CullMode.Off => Vk.VK_CULL_MODE_NONE,
            Rendering.CullMode.Front => Vk.VK_CULL_MODE_FRONT_BIT,
            _ => Vk.VK_CULL_MODE_BACK_BIT,
        };

        // Near is 1 and far 0 on this API: what is less in Unity's words is greater in the buffer.
        static uint Reversed(CompareFunction function) => function switch
        {
            CompareFunction.Never => Vk.VK_COMPARE_OP_NEVER,
            CompareFunction.Less => Vk.VK_COMPARE_OP_GREATER,
            CompareFunction.Equal => Vk.VK_COMPARE_OP_EQUAL,
            CompareFunction.LessEqual => Vk.VK_COMPARE_OP_GREATER_OR_EQUAL,
            CompareFunction.Greater => Vk.VK_COMPARE_OP_LESS,
            CompareFunction.NotEqual => Vk.VK_COMPARE_OP_NOT_EQUAL,
            CompareFunction.GreaterEqual => Vk.VK_COMPARE_OP_LESS_OR_EQUAL,
            _ => Vk.VK_COMPARE_OP_ALWAYS,
        };

        static uint Factor(BlendMode mode, bool alpha) => mode switch
        {
            BlendMode.Zero => Vk.VK_BLEND_FACTOR_ZERO,
            BlendMode.One => Vk.VK_BLEND_FACTOR_ONE,
            BlendMode.DstColor => alpha ? Vk.VK_BLEND_FACTOR_DST_ALPHA : Vk.VK_BLEND_FACTOR_DST_COLOR,
            BlendMode.SrcColor => alpha ? Vk.VK_BLEND_FACTOR_SRC_ALPHA : Vk.VK_BLEND_FACTOR_SRC_COLOR,
            BlendMode.OneMinusDstColor => alpha ? Vk.VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA : Vk.VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR,
            BlendMode.SrcAlpha => Vk.VK_BLEND_FACTOR_SRC_ALPHA,
            BlendMode.OneMinusSrcColor => alpha ? Vk.VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA : Vk.VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR,
            BlendMode.DstAlpha => Vk.VK_BLEND_FACTOR_DST_ALPHA,
            BlendMode.OneMinusDstAlpha => Vk.VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA,
            BlendMode.SrcAlphaSaturate => Vk.VK_BLEND_FACTOR_SRC_ALPHA_SATURATE,
            BlendMode.OneMinusSrcAlpha => Vk.VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
            _ => throw new ArgumentOutOfRangeException(nameof(mode), mode, "no blend factor"),
        };

        static uint Operation(BlendOp operation) => operation switch
        {
            BlendOp.Add => Vk.VK_BLEND_OP_ADD,
            BlendOp.Subtract => Vk.VK_BLEND_OP_SUBTRACT,
            BlendOp.ReverseSubtract => Vk.VK_BLEND_OP_REVERSE_SUBTRACT,
            BlendOp.Min => Vk.VK_BLEND_OP_MIN,
            BlendOp.Max => Vk.VK_BLEND_OP_MAX,
            _ => throw new ArgumentOutOfRangeException(nameof(operation), operation, "no blend operation that every device has"),
        };

        static uint WriteMask(ColorWriteMask mask)
        {
            uint bits = 0;
            if ((mask & ColorWriteMask.Red) != 0)
                bits |= Vk.VK_COLOR_COMPONENT_R_BIT;
            if ((mask & ColorWriteMask.Green) != 0)
                bits |= Vk.VK_COLOR_COMPONENT_G_BIT;
            if ((mask & ColorWriteMask.Blue) != 0)
                bits |= Vk.VK_COLOR_COMPONENT_B_BIT;
            if ((mask & ColorWriteMask.Alpha) != 0)
                bits |= Vk.VK_COLOR_COMPONENT_A_BIT;
            return bits;
        }
    }
}
