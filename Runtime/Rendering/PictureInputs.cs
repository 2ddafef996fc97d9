using System;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>Everything that a picture depends on, by value; a picture whose inputs have not changed is not made again.</summary>
    readonly struct PictureInputs : IEquatable<PictureInputs>
    {
        readonly CarvePipeline pipeline;
        readonly int pipelineVersion;
        readonly PictureRayBundle rays;
        readonly Vector3 march;
        readonly Vector3 lightDirection;
        readonly Color lightColor;
        readonly Vector4 shading;
        readonly bool countSamples;

        public PictureInputs(CarvePipeline pipeline, in PictureRayBundle rays, RenderQuality quality, LightSettings light, bool countSamples)
        {
            this.pipeline = pipeline;
            pipelineVersion = pipeline.Version;
            this.rays = rays;
            march = new Vector3(quality.Step, quality.OpaqueAlpha, quality.FirstVisibleAlpha);
            lightDirection = light.Direction;
            lightColor = light.Color;
            shading = new Vector4(light.Ambient, light.Diffuse, light.Specular, light.Shininess);
            this.countSamples = countSamples;
        }

        public bool Equals(PictureInputs other) => ReferenceEquals(pipeline, other.pipeline) && pipelineVersion == other.pipelineVersion
            && countSamples == other.countSamples && march.Equals(other.march) && lightDirection.Equals(other.lightDirection)
            && lightColor.Equals(other.lightColor) && shading.Equals(other.shading) && rays.Equals(other.rays);

        public override bool Equals(object obj) => obj is PictureInputs other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(pipelineVersion, rays);
    }
}
