using System;
using System.Collections.Generic;
using System.Globalization;
using UnityEngine.Rendering;

namespace UnityEngine.Shaders
{
    /// <summary>A value in a fixed state: a number, or a property of the material that holds it.</summary>
    readonly struct StateValue
    {
        StateValue(float number, string property)
        {
            Number = number;
            Property = property;
            PropertyId = property == null ? 0 : Shader.PropertyToID(property);
        }

        internal readonly float Number;
        internal readonly string Property;
        internal readonly int PropertyId;

        internal static StateValue Of(float number) => new(number, null);

        internal static StateValue Of(Enum value) => new(Convert.ToInt32(value, CultureInfo.InvariantCulture), null);

        internal static StateValue OfProperty(string name) => new(0, name);
    }

    /// <summary>A pass's fixed states as written. Enums are Unity's, as numbers, because properties hold them so.</summary>
    sealed class ShaderLabState
    {
        internal StateValue Cull = StateValue.Of(CullMode.Back);
        internal StateValue ZTest = StateValue.Of(CompareFunction.LessEqual);
        internal StateValue ZWrite = StateValue.Of(1);
        internal StateValue ZClip = StateValue.Of(1);
        internal StateValue OffsetFactor = StateValue.Of(0);
        internal StateValue OffsetUnits = StateValue.Of(0);
        internal StateValue ColorMask = StateValue.Of(ColorWriteMask.All);
        internal StateValue AlphaToMask = StateValue.Of(0);
        internal bool Blends;
        internal StateValue SourceColor = StateValue.Of(BlendMode.One);
        internal StateValue TargetColor = StateValue.Of(BlendMode.Zero);
        internal StateValue SourceAlpha = StateValue.Of(BlendMode.One);
        internal StateValue TargetAlpha = StateValue.Of(BlendMode.Zero);
        internal StateValue ColorOperation = StateValue.Of(BlendOp.Add);
        internal StateValue AlphaOperation = StateValue.Of(BlendOp.Add);

        /// <summary>What a Stencil block holds, by key; read, but not done by this host. Null if there is none.</summary>
        internal Dictionary<string, StateValue> Stencil;

        internal ShaderLabState Copy() => (ShaderLabState)MemberwiseClone();

        /// <summary>Names of the properties that states refer to.</summary>
        internal IEnumerable<string> Properties()
        {
            foreach (var value in new[]
            {
                Cull, ZTest, ZWrite, ZClip, OffsetFactor, OffsetUnits, ColorMask, AlphaToMask, SourceColor, TargetColor, SourceAlpha, TargetAlpha,
                ColorOperation, AlphaOperation,
            })
                if (value.Property != null)
                    yield return value.Property;
        }
    }
}
