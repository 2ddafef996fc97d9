using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>How the opacity between voxels is read along a ray.</summary>
    public enum OpacityFilter
    {
        /// <summary>
        /// By the GPU's texture filter. Its precision is the driver's, often 8 bits: pointing may then differ from the picture where matter is
        /// semi-transparent.
        /// </summary>
        Hardware,

        /// <summary>From the eight voxels around, in float: picture and pointer agree.</summary>
        Exact,
    }

    /// <summary>What a picture may cost: the ray's step, how cuts are made, anti-aliasing, and where rays stop.</summary>
    [Serializable]
    public sealed class RenderQuality
    {
        /// <summary>Shortest step in reference lengths (the smallest spacing).</summary>
        public const float MinStep = 0.05f;

        /// <summary>Longest step in reference lengths.</summary>
        public const float MaxStep = 4f;

        [SerializeField, Range(MinStep, MaxStep), Tooltip("Distance of samples along a ray, in reference lengths (the smallest spacing)")]
        float step = 0.5f;

        [SerializeField, Tooltip("Binary: Eq. 1, a voxel is clipped or not. Smooth: by the share of the voxel that lies inside the sphere")]
        CutMode cutMode = CutMode.Binary;

        [SerializeField, Range(0f, 1f), Tooltip("How much of the 3D anti-aliasing is applied; 0 = none")]
        float antiAliasing = 1f;

        [SerializeField, Range(0.5f, 1f), Tooltip("Accumulated opacity at which a ray stops")]
        float opaqueAlpha = (float)RaySettings.DefaultOpaqueAlpha;

        [SerializeField, Range(0.01f, 0.99f), Tooltip("Accumulated opacity at which a segment counts as seen")]
        float firstVisibleAlpha = 0.5f;

        [SerializeField, Tooltip("Exact: opacity between voxels in full precision; pointers find what is shown. Hardware: the GPU's filter, faster")]
        OpacityFilter filter = OpacityFilter.Exact;

        [NonSerialized] bool skipEmptySpace = true;

        [NonSerialized] AntiAliasSettings antiAliasSettings;
        [NonSerialized] RaySettings raySettings;

        /// <summary>Distance of samples along a ray in reference lengths, 0.05 to 4.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float Step
        {
            get => step;
            set => step = SettingRange.Checked(value, MinStep, MaxStep, nameof(Step));
        }

        /// <summary>How a sphere's surface cuts voxels.</summary>
        /// <exception cref="ArgumentOutOfRangeException">No such mode.</exception>
        public CutMode CutMode
        {
            get => cutMode;
            set => cutMode = SettingRange.Defined(value, nameof(CutMode));
        }

        /// <summary>How much of the 3D anti-aliasing is applied, 0 (none) to 1.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float AntiAliasing
        {
            get => antiAliasing;
            set => antiAliasing = SettingRange.Checked(value, 0f, 1f, nameof(AntiAliasing));
        }

        /// <summary>Accumulated opacity at which a ray stops, 0.5 to 1.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float OpaqueAlpha
        {
            get => opaqueAlpha;
            set => opaqueAlpha = SettingRange.Checked(value, 0.5f, 1f, nameof(OpaqueAlpha));
        }

        /// <summary>Accumulated opacity at which a segment counts as seen (first visible segment), 0.01 to 0.99.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float FirstVisibleAlpha
        {
            get => firstVisibleAlpha;
            set => firstVisibleAlpha = SettingRange.Checked(value, 0.01f, 0.99f, nameof(FirstVisibleAlpha));
        }

        /// <summary>How the opacity between voxels is read along a ray.</summary>
        /// <exception cref="ArgumentOutOfRangeException">No such filter.</exception>
        public OpacityFilter Filter
        {
            get => filter;
            set => filter = SettingRange.Defined(value, nameof(Filter));
        }

        /// <summary>Whether rays skip what is empty. Pictures are the same without, which is for measuring; it is not saved.</summary>
        public bool SkipEmptySpace { get => skipEmptySpace; set => skipEmptySpace = value; }

        /// <summary>The names that <see cref="Named"/> knows, from the cheapest to the best.</summary>
        public static string[] Names => new[] { "fast", "balanced", "best" };

        /// <summary>Binary cuts, steps of one reference length, the GPU's texture filter.</summary>
        public static RenderQuality Fast() => new RenderQuality { step = 1f, filter = OpacityFilter.Hardware };

        /// <summary>Binary cuts, which are Eq. 1 exactly, and steps of half a reference length. What a new renderer has.</summary>
        public static RenderQuality Balanced() => new RenderQuality();

        /// <summary>Smooth cuts and steps of a quarter of a reference length.</summary>
        public static RenderQuality Best() => new RenderQuality { step = 0.25f, cutMode = CutMode.Smooth };

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

        /// <summary>The row <c>_March</c> of <c>Shaders/VolumeLayout.hlsl</c>.</summary>
        internal Vector4 March => new Vector4(step, opaqueAlpha, firstVisibleAlpha, filter == OpacityFilter.Exact ? 1f : 0f);

        /// <summary>The row <c>_Skip</c> of <c>Shaders/VolumeLayout.hlsl</c>.</summary>
        internal Vector4 Skip => new Vector4(skipEmptySpace ? 1f : 0f, RaySettings.PartsOfStep, 0f, 0f);

        /// <summary>The same as the CPU's walk along a ray takes it.</summary>
        internal RaySettings RaySettings
        {
            get
            {
                if (raySettings == null || (float)raySettings.StepReference != step || (float)raySettings.OpaqueAlpha != opaqueAlpha
                    || (float)raySettings.FirstVisibleAlpha != firstVisibleAlpha)
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
    }
}
