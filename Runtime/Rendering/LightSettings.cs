using System;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>The light that volumes are shaded with (Blinn-Phong). It follows the viewer: directions are those of the picture.</summary>
    [Serializable]
    public sealed class LightSettings
    {
        static readonly Vector3 DefaultDirection = new Vector3(-0.3f, 0.4f, 1f);

        [SerializeField, Tooltip("Where the light comes from: x right, y up, z towards the viewer")]
        Vector3 direction = DefaultDirection;

        [SerializeField, Tooltip("The light's colour")]
        Color color = Color.white;

        [SerializeField, Range(0f, 1f), Tooltip("Light that comes from everywhere")]
        float ambient = 0.25f;

        [SerializeField, Range(0f, 1f), Tooltip("Light that a surface scatters")]
        float diffuse = 0.75f;

        [SerializeField, Range(0f, 1f), Tooltip("Light that a surface reflects")]
        float specular = 0.2f;

        [SerializeField, Range(1f, 256f), Tooltip("How sharp the reflection is")]
        float shininess = 24f;

        /// <summary>Where the light comes from, as seen in the picture: x right, y up, z towards the viewer. Any length but 0.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The direction is zero or not finite.</exception>
        public Vector3 Direction
        {
            get => direction;
            set
            {
                if (!IsDirection(value))
                    throw new ArgumentOutOfRangeException(nameof(Direction), value, "A light's direction is finite and not zero.");
                direction = value;
            }
        }

        /// <summary>The light's colour, sRGB as in all of Unity's colour fields.</summary>
        /// <exception cref="ArgumentOutOfRangeException">A channel is negative, infinite or NaN.</exception>
        public Color Color
        {
            get => color;
            set => color = SettingRange.Checked(value, nameof(Color));
        }

        /// <summary>Light that comes from everywhere, 0 to 1.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float Ambient
        {
            get => ambient;
            set => ambient = SettingRange.Checked(value, 0f, 1f, nameof(Ambient));
        }

        /// <summary>Light that a surface scatters, 0 to 1.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float Diffuse
        {
            get => diffuse;
            set => diffuse = SettingRange.Checked(value, 0f, 1f, nameof(Diffuse));
        }

        /// <summary>Light that a surface reflects, 0 to 1.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float Specular
        {
            get => specular;
            set => specular = SettingRange.Checked(value, 0f, 1f, nameof(Specular));
        }

        /// <summary>The reflection's exponent, 1 to 256.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float Shininess
        {
            get => shininess;
            set => shininess = SettingRange.Checked(value, 1f, 256f, nameof(Shininess));
        }

        /// <summary>Sets what does not depend on the viewer: the rows <c>_LightColor</c> and <c>_Shading</c> of <c>Shaders/VolumeLayout.hlsl</c>.</summary>
        internal void Bind<T>(T target) where T : IShaderValues
        {
            Color linear = color.linear;
            target.SetVector(ShaderIds.LightColor, new Vector4(linear.r, linear.g, linear.b, 0f));
            target.SetVector(ShaderIds.Shading, Shading);
        }

        /// <summary>The row <c>_Shading</c>.</summary>
        internal Vector4 Shading => new Vector4(ambient, diffuse, specular, shininess);

        /// <summary>The direction at length 1, whatever its own length: in float the squares of small numbers are 0.</summary>
        internal Vector3 UnitDirection
        {
            get
            {
                double length = Length(direction);
                return new Vector3((float)(direction.x / length), (float)(direction.y / length), (float)(direction.z / length));
            }
        }

        internal void Clamp()
        {
            if (!IsDirection(direction))
                direction = DefaultDirection;
            if (!SettingRange.IsColor(color))
                color = Color.white;
            ambient = Mathf.Clamp01(ambient);
            diffuse = Mathf.Clamp01(diffuse);
            specular = Mathf.Clamp01(specular);
            shininess = Mathf.Clamp(shininess, 1f, 256f);
        }

        static bool IsDirection(Vector3 v)
        {
            double length = Length(v);
            return length > 0 && !double.IsInfinity(length);
        }

        static double Length(Vector3 v) => Math.Sqrt((double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z);
    }
}
