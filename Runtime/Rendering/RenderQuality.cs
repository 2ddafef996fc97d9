using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>What a picture may cost: the ray's step, how cuts are made, anti-aliasing, and where rays stop.</summary>
    [Serializable]
    public sealed class RenderQuality
    {
        /// <summary>Shortest step in reference lengths (the smallest spacing).</summary>
        public const float MinStep = 0.05f;

        /// <summary>Longest step in reference lengths.</summary>
        public const float MaxStep = 4f;

        [SerializeField, Range(MinStep, MaxStep), Tooltip("Distance of samples along a ray, in reference lengths (the smallest spacing)")]
        private float step = 0.5f;

        [SerializeField, Tooltip("Binary: Eq. 1, a voxel is clipped or not. Smooth: by the share of the voxel that lies inside the sphere")]
        private CutMode cutMode = CutMode.Smooth;

        [SerializeField, Range(0f, 1f), Tooltip("How much of the 3D anti-aliasing is applied; 0 = none")]
        private float antiAliasing = 1f;

        [SerializeField, Range(0.5f, 1f), Tooltip("Accumulated opacity at which a ray stops")]
        private float opaqueAlpha = 1f - 1f / 255f;

        [SerializeField, Range(0.01f, 0.99f), Tooltip("Accumulated opacity at which a segment counts as seen")]
        private float firstVisibleAlpha = 0.5f;

        [NonSerialized] private AntiAliasSettings antiAliasSettings;
        [NonSerialized] private RaySettings raySettings;

        /// <summary>Distance of samples along a ray in reference lengths, 0.05 to 4.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float Step
        {
            get => step;
            set => step = Checked(value, MinStep, MaxStep, nameof(Step));
        }

        /// <summary>How a sphere's surface cuts voxels.</summary>
        /// <exception cref="ArgumentOutOfRangeException">No such mode.</exception>
        public CutMode CutMode
        {
            get => cutMode;
            set => cutMode = Enum.IsDefined(typeof(CutMode), value) ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "No such cut mode.");
        }

        /// <summary>How much of the 3D anti-aliasing is applied, 0 (none) to 1.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float AntiAliasing
        {
            get => antiAliasing;
            set => antiAliasing = Checked(value, 0f, 1f, nameof(AntiAliasing));
        }

        /// <summary>Accumulated opacity at which a ray stops, 0.5 to 1.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float OpaqueAlpha
        {
            get => opaqueAlpha;
            set => opaqueAlpha = Checked(value, 0.5f, 1f, nameof(OpaqueAlpha));
        }

        /// <summary>Accumulated opacity at which a segment counts as seen (first visible segment), 0.01 to 0.99.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float FirstVisibleAlpha
        {
            get => firstVisibleAlpha;
            set => firstVisibleAlpha = Checked(value, 0.01f, 0.99f, nameof(FirstVisibleAlpha));
        }

        /// <summary>The names that <see cref="Named"/> knows, from the cheapest to the best.</summary>
        public static string[] Names => new[] { "fast", "balanced", "best" };

        /// <summary>Binary cuts and steps of one reference length.</summary>
        public static RenderQuality Fast() => new RenderQuality { step = 1f, cutMode = CutMode.Binary, opaqueAlpha = 0.98f };

        /// <summary>Smooth cuts and steps of half a reference length. What a new renderer has.</summary>
        public static RenderQuality Balanced() => new RenderQuality();

        /// <summary>Smooth cuts and steps of a quarter of a reference length.</summary>
        public static RenderQuality Best() => new RenderQuality { step = 0.25f };

        /// <summary>A preset by its name.</summary>
        /// <exception cref="ArgumentException">No preset has this name.</exception>
        public static RenderQuality Named(string name)
        {
            switch (name)
            {
                case "fast": return Fast();
                case "balanced": return Balanced();
                case "best": return Best();
                default: throw new ArgumentException($"There is no quality '{name}'; the qualities are {string.Join(", ", Names)}.", nameof(name));
            }
        }

        /// <summary>The same as the CPU's walk along a ray takes it.</summary>
        internal RaySettings RaySettings
        {
            get
            {
                if (raySettings == null || (float)raySettings.StepReference != step || (float)raySettings.OpaqueAlpha != opaqueAlpha || (float)raySettings.FirstVisibleAlpha != firstVisibleAlpha)
                    raySettings = new RaySettings { StepReference = step, OpaqueAlpha = opaqueAlpha, FirstVisibleAlpha = firstVisibleAlpha };
                return raySettings;
            }
        }

        internal AntiAliasSettings AntiAliasSettings
        {
            get
            {
                if (antiAliasSettings == null || antiAliasSettings.Strength != antiAliasing)
                    antiAliasSettings = new AntiAliasSettings(strength: antiAliasing);
                return antiAliasSettings;
            }
        }

        internal void Clamp()
        {
            step = Mathf.Clamp(step, MinStep, MaxStep);
            antiAliasing = Mathf.Clamp01(antiAliasing);
            opaqueAlpha = Mathf.Clamp(opaqueAlpha, 0.5f, 1f);
            firstVisibleAlpha = Mathf.Clamp(firstVisibleAlpha, 0.01f, 0.99f);
        }

        static float Checked(float value, float min, float max, string name) => value >= min && value <= max
            ? value
            : throw new ArgumentOutOfRangeException(name, value, FormattableString.Invariant($"{name} is {min} to {max}."));
    }
}
