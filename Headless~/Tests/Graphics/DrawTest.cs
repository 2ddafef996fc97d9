using System.Collections.Generic;
using System.IO;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>What tests that draw share: shaders from the Fixtures folder, targets, cameras, meshes; all freed when a test ends.</summary>
    public abstract class DrawTest : GpuTest
    {
        protected const int Size = 32;

        readonly Dictionary<string, Shader> m_Shaders = new();

        [TearDown]
        public void ForgetShaders()
        {
            m_Shaders.Clear();
            UnityEngine.Graphics.SetRenderTarget(null);
        }

        protected Shader Shader(string name)
        {
            if (!m_Shaders.TryGetValue(name, out var shader))
                m_Shaders.Add(name, shader = Own(UnityEngine.Shader.Load(Path.Combine(FixtureFolder, name + ".shader"))));
            return shader;
        }

        protected Material Material(string shader) => Own(new Material(Shader(shader)));

        /// <summary>Linear, so that colours are read as shaders wrote them, with depth.</summary>
        protected RenderTexture Target(GraphicsFormat format = GraphicsFormat.R32G32B32A32_SFloat, int width = Size, int height = Size)
        {
            var target = Own(new RenderTexture(width, height, format, GraphicsFormat.D32_SFloat) { name = "test target" });
            Assert.That(target.Create(), Is.True);
            return target;
        }

        /// <summary>At (0, 0, -5), looking at the origin, 60 degrees, clears to black.</summary>
        protected Camera Camera(RenderTexture target)
        {
            var camera = Own(new GameObject("camera")).AddComponent<Camera>();
            camera.enabled = false;
            camera.transform.position = new Vector3(0, 0, -5);
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = new Color(0, 0, 0, 0);
            camera.nearClipPlane = 0.5f;
            camera.farClipPlane = 50f;
            camera.targetTexture = target;
            return camera;
        }

        protected GameObject Object(Mesh mesh, Material material, Vector3 position, float scale = 1f)
        {
            var o = Own(new GameObject("object"));
            o.transform.position = position;
            o.transform.localScale = Vector3.one * scale;
            o.AddComponent<MeshFilter>().sharedMesh = mesh;
            o.AddComponent<MeshRenderer>().sharedMaterial = material;
            return o;
        }

        protected static Mesh Cube => BuiltinAssets.Mesh(BuiltinAssets.Cube);

        protected static Mesh Quad => BuiltinAssets.Mesh(BuiltinAssets.Quad);

        /// <summary>Colours row by row from the bottom.</summary>
        protected static Color[] Pixels(RenderTexture target)
        {
            var values = Read<float>(target);
            var colors = new Color[values.Length / 4];
            for (var i = 0; i < colors.Length; i++)
                colors[i] = new Color(values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3]);
            return colors;
        }

        protected static Color Pixel(RenderTexture target, int x, int y) => Pixels(target)[y * target.width + x];

        /// <summary>The raw depth buffer row by row from the bottom.</summary>
        protected static float[] Depths(RenderTexture target)
        {
            var bytes = Gpu.Context.Readbacks.ReadNow(target.DepthNative, 0, new TexelBox(0, 0, 0, target.width, target.height, 1));
            var depths = new float[bytes.Length / 4];
            System.Buffer.BlockCopy(bytes, 0, depths, 0, bytes.Length);
            return depths;
        }

        /// <summary>The distance along the view that a value of a perspective camera's depth buffer means.</summary>
        protected static float EyeDistance(float depth, Camera camera)
        {
            var (near, far) = (camera.nearClipPlane, camera.farClipPlane);
            return 1f / (depth * (1f / near - 1f / far) + 1f / far);
        }
    }
}
