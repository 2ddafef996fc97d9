using System;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public partial class Graphics
    {
        /// <summary>The present colour target.</summary>
        public static RenderBuffer activeColorBuffer => new(DrawTargets.Color, false);

        public static RenderBuffer activeDepthBuffer => new(DrawTargets.Color, true);

        /// <summary>Draws a mesh with all cameras of this frame, or with one.</summary>
        public static void RenderMesh(in RenderParams rparams, Mesh mesh, int submeshIndex, Matrix4x4 objectToWorld,
            Matrix4x4? prevObjectToWorld = null) =>
            FrameMeshes.Add(rparams, mesh, submeshIndex, objectToWorld);

        public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Material material, int layer) =>
            DrawMesh(mesh, Matrix4x4.TRS(position, rotation, Vector3.one), material, layer);

        public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Material material, int layer, Camera camera) =>
            DrawMesh(mesh, Matrix4x4.TRS(position, rotation, Vector3.one), material, layer, camera);

        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer) => DrawMesh(mesh, matrix, material, layer, null);

        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera camera) =>
            DrawMesh(mesh, matrix, material, layer, camera, 0);

        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera camera, int submeshIndex) =>
            DrawMesh(mesh, matrix, material, layer, camera, submeshIndex, null);

        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera camera, int submeshIndex,
            MaterialPropertyBlock properties) =>
            DrawMesh(mesh, matrix, material, layer, camera, submeshIndex, properties, ShadowCastingMode.On);

        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera camera, int submeshIndex,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows) =>
            DrawMesh(mesh, matrix, material, layer, camera, submeshIndex, properties, castShadows, true);

        /// <summary>The older form of <see cref="RenderMesh"/>.</summary>
        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera camera, int submeshIndex,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows, bool receiveShadows) =>
            RenderMesh(new RenderParams(material)
            {
                layer = layer,
                camera = camera,
                matProps = properties,
                shadowCastingMode = castShadows,
                receiveShadows = receiveShadows,
            }, mesh, submeshIndex, matrix);

        public static void DrawMeshNow(Mesh mesh, Vector3 position, Quaternion rotation) => DrawMeshNow(mesh, position, rotation, -1);

        public static void DrawMeshNow(Mesh mesh, Vector3 position, Quaternion rotation, int materialIndex) =>
            DrawMeshNow(mesh, Matrix4x4.TRS(position, rotation, Vector3.one), materialIndex);

        public static void DrawMeshNow(Mesh mesh, Matrix4x4 matrix) => DrawMeshNow(mesh, matrix, -1);

        /// <summary>Draws now into the present target, with the pass that Material.SetPass chose and GL's matrices.</summary>
        public static void DrawMeshNow(Mesh mesh, Matrix4x4 matrix, int materialIndex)
        {
            MainThread.Check("Graphics.DrawMeshNow");
            ImmediateDrawing.Draw(mesh, matrix, materialIndex);
        }

        public static void SetRenderTarget(RenderTexture rt) => SetRenderTarget(rt, 0);

        public static void SetRenderTarget(RenderTexture rt, int mipLevel) => SetRenderTarget(rt, mipLevel, CubemapFace.Unknown);

        public static void SetRenderTarget(RenderTexture rt, int mipLevel, CubemapFace face) => SetRenderTarget(rt, mipLevel, face, 0);

        /// <param name="rt">Null for the screen.</param>
        /// <param name="mipLevel">The level that is drawn into.</param>
        /// <param name="face">Unknown: there are no cube maps here.</param>
        /// <param name="depthSlice">The slice of an array; -1 for all of them.</param>
        public static void SetRenderTarget(RenderTexture rt, int mipLevel, CubemapFace face, int depthSlice)
        {
            MainThread.Check("Graphics.SetRenderTarget");
            RefuseFaces(face);
            DrawTargets.Set(rt != null ? rt : null, mipLevel, depthSlice);
        }

        public static void SetRenderTarget(RenderBuffer colorBuffer, RenderBuffer depthBuffer) => SetRenderTarget(colorBuffer, depthBuffer, 0);

        public static void SetRenderTarget(RenderBuffer colorBuffer, RenderBuffer depthBuffer, int mipLevel) =>
            SetRenderTarget(colorBuffer, depthBuffer, mipLevel, CubemapFace.Unknown);

        public static void SetRenderTarget(RenderBuffer colorBuffer, RenderBuffer depthBuffer, int mipLevel, CubemapFace face) =>
            SetRenderTarget(colorBuffer, depthBuffer, mipLevel, face, 0);

        public static void SetRenderTarget(RenderBuffer colorBuffer, RenderBuffer depthBuffer, int mipLevel, CubemapFace face, int depthSlice)
        {
            MainThread.Check("Graphics.SetRenderTarget");
            RefuseFaces(face);
            DrawTargets.Set(new[] { colorBuffer.Owner }, depthBuffer.Owner, mipLevel, depthSlice);
        }

        /// <summary>Several colours at once: SV_Target0, SV_Target1 and so on.</summary>
        public static void SetRenderTarget(RenderBuffer[] colorBuffers, RenderBuffer depthBuffer)
        {
            MainThread.Check("Graphics.SetRenderTarget");
            if (colorBuffers == null || colorBuffers.Length == 0 || colorBuffers.Length > SystemInfo.supportedRenderTargetCount)
                throw new ArgumentException($"There can be 1 to {SystemInfo.supportedRenderTargetCount} colour buffers", nameof(colorBuffers));
            DrawTargets.Set(Array.ConvertAll(colorBuffers, b => b.Owner), depthBuffer.Owner, 0, 0);
        }

        static void RefuseFaces(CubemapFace face)
        {
            if (face != CubemapFace.Unknown)
                throw new NotSupportedException("This host has no cube maps.");
        }
    }
}
