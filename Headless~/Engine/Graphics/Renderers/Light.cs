using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>Kinds of lights.</summary>
    public enum LightType
    {
        Spot = 0,
        Directional = 1,
        Point = 2,
        Rectangle = 3,
        Disc = 4,
        Pyramid = 5,
        Box = 6,
        Tube = 7,
    }

    /// <summary>Whether a light casts shadows; the host draws none.</summary>
    public enum LightShadows
    {
        None = 0,
        Hard = 1,
        Soft = 2,
    }

    /// <summary>A light. The host's shaders know the brightest directional one.</summary>
    public sealed class Light : Behaviour
    {
        public Light()
        {
        }

        public LightType type { get; set; } = LightType.Point;

        public Color color { get; set; } = Color.white;

        public float intensity { get; set; } = 1f;

        public float bounceIntensity { get; set; } = 1f;

        public float range { get; set; } = 10f;

        /// <summary>Degrees.</summary>
        public float spotAngle { get; set; } = 30f;

        /// <summary>Degrees.</summary>
        public float innerSpotAngle { get; set; } = 21.80208f;

        public LightShadows shadows { get; set; } = LightShadows.None;

        public float shadowStrength { get; set; } = 1f;

        public int cullingMask { get; set; } = -1;

        public int renderingLayerMask { get; set; } = 1;

        internal static List<Light> Running { get; } = new();

        /// <summary>The directional light that counts most; null if there is none.</summary>
        internal static Light Main
        {
            get
            {
                Light best = null;
                foreach (var light in Running)
                    if (light.type == LightType.Directional && (best is null || light.intensity > best.intensity))
                        best = light;
                return best;
            }
        }

        internal override void OnRunningChanged(bool running)
        {
            if (running)
                Running.Add(this);
            else
                Running.Remove(this);
        }

        internal override void CopyNativeState(Component source, Func<Object, Object> remap)
        {
            var other = (Light)source;
            (type, color, intensity, bounceIntensity, range) = (other.type, other.color, other.intensity, other.bounceIntensity, other.range);
            (spotAngle, innerSpotAngle, shadows, shadowStrength) = (other.spotAngle, other.innerSpotAngle, other.shadows, other.shadowStrength);
            (cullingMask, renderingLayerMask) = (other.cullingMask, other.renderingLayerMask);
        }
    }
}
