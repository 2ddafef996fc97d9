using System;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// A volume in cameras' own pictures: its box on a MeshRenderer, with the shader <c>AnatomyCarve/Carved Volume</c>. Unity culls, sorts and draws it as any
    /// mesh, in every camera and for both eyes; here only its mesh and its material's values are kept up.
    /// </summary>
    sealed class VolumeDrawing : IDisposable
    {
        const int NothingBound = -1;

        readonly Shader shader;
        readonly CarvePipeline pipeline;
        Mesh box;
        Material material;
        int boundVersion;
        Vector4 march, shading;
        Vector3 lightDirection;
        Color lightColor;

        /// <exception cref="AnatomyCarveException">The shader is missing, or the device cannot run it.</exception>
        public VolumeDrawing(AnatomyCarveShaders shaders, CarvePipeline pipeline)
        {
            this.pipeline = pipeline;
            shader = shaders.CarvedVolume;
            if (shader == null)
                throw new AnatomyCarveException("The shader CarvedVolume is missing in AnatomyCarveShaders.asset: reimport the package.");
            if (!shader.isSupported)
                throw new AnatomyCarveException(
                    $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) cannot run the shader {shader.name}.");
        }

        /// <summary>Has cameras draw the volume as it is now.</summary>
        public void ShowOn(MeshFilter filter, MeshRenderer renderer, in VolumeInputs inputs)
        {
            if (box == null)
                box = VolumeBox.MakeMesh(inputs.Volume.Geometry);
            if (material == null)
                MakeMaterial();
            Bind(inputs.Quality, inputs.Light);
            if (filter.sharedMesh != box)
                filter.sharedMesh = box;
            if (renderer.sharedMaterial != material)
                renderer.sharedMaterial = material;
        }

        /// <summary>Has cameras draw nothing.</summary>
        public static void Clear(MeshFilter filter, MeshRenderer renderer)
        {
            if (filter != null && filter.sharedMesh is object)
                filter.sharedMesh = null;
            if (renderer != null && renderer.sharedMaterial is object)
                renderer.sharedMaterial = null;
        }

        public void Dispose()
        {
            GpuObjects.Destroy(box);
            GpuObjects.Destroy(material);
            box = null;
            material = null;
        }

        void MakeMaterial()
        {
            material = new Material(shader) { name = "AnatomyCarve volume", hideFlags = HideFlags.HideAndDontSave };
            material.SetKeyword(new LocalKeyword(shader, ShaderIds.PortableLayout), pipeline.Layout == TextureLayout.Portable);
            boundVersion = NothingBound;
        }

        /// <summary>Sets the material's values, if any has changed.</summary>
        void Bind(RenderQuality quality, LightSettings light)
        {
            if (boundVersion == pipeline.Version && march == quality.March && shading == light.Shading && lightDirection == light.Direction
                && lightColor == light.Color)
                return;
            var values = new MaterialValues(material);
            pipeline.BindForRays(values);
            light.Bind(values);
            Vector3 towardsLight = light.Direction.normalized;
            values.SetVector(ShaderIds.March, quality.March);
            values.SetVector(ShaderIds.LightDirection, towardsLight);
            boundVersion = pipeline.Version;
            march = quality.March;
            shading = light.Shading;
            lightDirection = light.Direction;
            lightColor = light.Color;
        }

        readonly struct MaterialValues : IShaderValues
        {
            readonly Material material;

            public MaterialValues(Material material) => this.material = material;

            public void SetVector(int id, Vector4 value) => material.SetVector(id, value);

            public void SetTexture(int id, Texture texture) => material.SetTexture(id, texture);
        }
    }
}
