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
        readonly Shader shader;
        Mesh box;
        Material material;
        object boundTo; // a pipeline's identity
        int boundVersion;
        Vector4 march, skip, shading;
        Vector3 lightDirection;
        Color lightColor;

        /// <exception cref="AnatomyCarveException">The shader is missing, or the device cannot run it.</exception>
        public VolumeDrawing(AnatomyCarveShaders shaders, VolumeGeometry geometry)
        {
            Geometry = geometry;
            shader = shaders.CarvedVolume;
            if (shader == null)
                throw new AnatomyCarveException("The shader CarvedVolume is missing in AnatomyCarveShaders.asset: reimport the package.");
            if (!shader.isSupported)
                throw new AnatomyCarveException(
                    $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) cannot run the shader {shader.name}.");
        }

        /// <summary>The grid whose box it is.</summary>
        public VolumeGeometry Geometry { get; }

        /// <summary>Has a surface show box and material. Before values are bound nothing is seen.</summary>
        public void Place(VolumeSurface surface)
        {
            if (box == null)
                box = VolumeBox.MakeMesh(Geometry);
            if (material == null)
            {
                material = new Material(shader) { name = "AnatomyCarve volume", hideFlags = HideFlags.HideAndDontSave };
                boundTo = null;
            }
            surface.Show(box, material);
        }

        public void Dispose()
        {
            GpuObjects.Destroy(box);
            GpuObjects.Destroy(material);
            box = null;
            material = null;
        }

        /// <summary>Sets the material's values, if any has changed.</summary>
        public void Bind(CarvePipeline pipeline, RenderQuality quality, LightSettings light)
        {
            if (boundTo == pipeline.Identity && boundVersion == pipeline.Version && march == quality.March && skip == quality.Skip
                && shading == light.Shading && lightDirection == light.Direction
                && lightColor == light.Color)
                return;
            if (boundTo != pipeline.Identity)
                material.SetKeyword(new LocalKeyword(shader, ShaderIds.PortableLayout), pipeline.Layout == TextureLayout.Portable);
            var values = new MaterialValues(material);
            pipeline.BindForRays(values);
            light.Bind(values);
            values.SetVector(ShaderIds.March, quality.March);
            values.SetVector(ShaderIds.Skip, quality.Skip);
            values.SetVector(ShaderIds.LightDirection, light.UnitDirection);
            boundTo = pipeline.Identity;
            boundVersion = pipeline.Version;
            march = quality.March;
            skip = quality.Skip;
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
