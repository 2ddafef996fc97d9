using System;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>Everything that a picture depends on, by value; a picture whose inputs have not changed is not made again.</summary>
    readonly struct PictureInputs : IEquatable<PictureInputs>
    {
        readonly object volume;
        readonly int pipelineVersion;
        readonly PictureRayBundle rays;
        readonly Vector4 march;
        readonly Vector4 skip;
        readonly Vector3 lightDirection;
        readonly Color lightColor;
        readonly Vector4 shading;
        readonly bool countSamples;
        readonly Texture sceneDepth;

        public PictureInputs(
            CarvePipeline pipeline, in PictureRayBundle rays, RenderQuality quality, LightSettings light, bool countSamples, Texture sceneDepth)
        {
            volume = pipeline.Identity;
            pipelineVersion = pipeline.Version;
            this.rays = rays;
            march = quality.March;
            skip = quality.Skip;
            lightDirection = light.Direction;
            lightColor = light.Color;
            shading = light.Shading;
            this.countSamples = countSamples;
            this.sceneDepth = sceneDepth != null ? sceneDepth : null; // a destroyed one is none
        }

        /// <summary>Whether something may hide the volume; its contents may change at any time.</summary>
        public bool HaveSceneDepth => sceneDepth is object;

        public bool Equals(PictureInputs other) => ReferenceEquals(volume, other.volume) && pipelineVersion == other.pipelineVersion
            && ReferenceEquals(sceneDepth, other.sceneDepth)
            && countSamples == other.countSamples && march.Equals(other.march) && skip.Equals(other.skip) && lightDirection.Equals(other.lightDirection)
            && lightColor.Equals(other.lightColor) && shading.Equals(other.shading) && rays.Equals(other.rays);

        public override bool Equals(object obj) => obj is PictureInputs other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(pipelineVersion, rays);
    }
}
