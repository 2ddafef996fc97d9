using System;
using System.Collections.Generic;
using UnityEngine.Shaders;

namespace UnityEngine.Rendering
{
    public partial class CommandBuffer
    {
        public void SetRenderTarget(RenderTargetIdentifier rt) => Record(() => Set(rt, rt.Mip, rt.Face, rt.Slice));

        public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel) => SetRenderTarget(rt, mipLevel, CubemapFace.Unknown);

        public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel, CubemapFace cubemapFace) => SetRenderTarget(rt, mipLevel, cubemapFace, 0);

        public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel, CubemapFace cubemapFace, int depthSlice) =>
            Record(() => Set(rt, mipLevel, cubemapFace, depthSlice));

        /// <summary>What is loaded and stored is the device's matter; here both always are.</summary>
        public void SetRenderTarget(RenderTargetIdentifier rt, RenderBufferLoadAction loadAction, RenderBufferStoreAction storeAction) => SetRenderTarget(rt);

        public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth) =>
            Record(() => Set(new[] { color }, depth, color.Mip, color.Face, color.Slice));

        public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth, int mipLevel) =>
            SetRenderTarget(color, depth, mipLevel, CubemapFace.Unknown);

        public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth, int mipLevel, CubemapFace cubemapFace) =>
            SetRenderTarget(color, depth, mipLevel, cubemapFace, 0);

        public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth, int mipLevel, CubemapFace cubemapFace, int depthSlice) =>
            Record(() => Set(new[] { color }, depth, mipLevel, cubemapFace, depthSlice));

        public void SetRenderTarget(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth)
        {
            var copy = Copy(colors);
            Record(() => Set(copy, depth, depth.Mip, depth.Face, depth.Slice));
        }

        public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor) =>
            ClearRenderTarget(clearDepth, clearColor, backgroundColor, 1f);

        public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor, float depth) =>
            ClearRenderTarget(clearDepth, clearColor, backgroundColor, depth, 0);

        /// <summary>Clears the target within the viewport. The colour is written as it is; 1 is the far depth.</summary>
        public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor, float depth = 1f, uint stencil = 0) =>
            Record(() => DrawTargets.Clear(clearColor, clearDepth, clearDepth, backgroundColor, depth, stencil));

        public void ClearRenderTarget(RTClearFlags clearFlags, Color backgroundColor, float depth = 1f, uint stencil = 0) =>
            Record(() => DrawTargets.Clear((clearFlags & RTClearFlags.Color) != 0, (clearFlags & RTClearFlags.Depth) != 0,
                (clearFlags & RTClearFlags.Stencil) != 0, backgroundColor, depth, stencil));

        public void SetViewport(Rect pixelRect) => Record(() => DrawTargets.Viewport = pixelRect);

        public void EnableScissorRect(Rect scissor) => Record(() => DrawTargets.Scissor = scissor);

        public void DisableScissorRect() => Record(() => DrawTargets.Scissor = null);

        public void SetInvertCulling(bool invertCulling) => Record(() => DrawTargets.InvertCulling = invertCulling);

        public void SetViewMatrix(Matrix4x4 view) => Record(() => ImmediateDrawing.View = view);

        public void SetProjectionMatrix(Matrix4x4 proj) => Record(() => ImmediateDrawing.Projection = proj);

        /// <summary>Both as a camera has them.</summary>
        public void SetViewProjectionMatrices(Matrix4x4 view, Matrix4x4 proj) => Record(() => ImmediateDrawing.Set(view, proj));

        public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material) => DrawMesh(mesh, matrix, material, 0);

        public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex) => DrawMesh(mesh, matrix, material, submeshIndex, -1);

        public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex, int shaderPass) =>
            DrawMesh(mesh, matrix, material, submeshIndex, shaderPass, null);

        /// <param name="mesh">The mesh.</param>
        /// <param name="matrix">Object to world.</param>
        /// <param name="material">The material.</param>
        /// <param name="submeshIndex">The part.</param>
        /// <param name="shaderPass">-1 for all passes.</param>
        /// <param name="properties">Copied now.</param>
        public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex, int shaderPass, MaterialPropertyBlock properties)
        {
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh));
            if (submeshIndex < 0 || submeshIndex >= mesh.subMeshCount)
                Debug.LogWarning($"submeshIndex out of range. Mesh '{mesh.NameForMessages}' has {mesh.subMeshCount} submeshes");
            Draw(new DrawItem { Mesh = mesh, SubMesh = submeshIndex, ObjectToWorld = matrix, Block = properties?.Copy() }, material, shaderPass);
        }

        public void DrawRenderer(Renderer renderer, Material material) => DrawRenderer(renderer, material, 0);

        public void DrawRenderer(Renderer renderer, Material material, int submeshIndex) => DrawRenderer(renderer, material, submeshIndex, -1);

        /// <summary>Draws what a renderer shows, where it is when the buffer runs.</summary>
        public void DrawRenderer(Renderer renderer, Material material, int submeshIndex, int shaderPass)
        {
            if (renderer == null)
                throw new ArgumentNullException(nameof(renderer));
            if (material == null)
                throw new ArgumentNullException(nameof(material));
            Record(() =>
            {
                if (renderer == null || material == null || renderer.MeshFor(Camera.current) is not { } mesh)
                    return;
                var item = new DrawItem { Mesh = mesh, SubMesh = submeshIndex, ObjectToWorld = renderer.MeshToWorld, Block = renderer.BlockOf(submeshIndex) };
                Run(item, material, shaderPass);
            });
        }

        public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount) =>
            DrawProcedural(matrix, material, shaderPass, topology, vertexCount, 1);

        public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount, int instanceCount) =>
            DrawProcedural(matrix, material, shaderPass, topology, vertexCount, instanceCount, null);

        /// <summary>Draws vertices that have nothing but their number (SV_VertexID).</summary>
        public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount, int instanceCount,
            MaterialPropertyBlock properties)
        {
            if (topology == MeshTopology.Quads)
                throw new NotSupportedException("Quads without a mesh are not supported by this host.");
            Draw(new DrawItem
            {
                VertexCount = vertexCount,
                Instances = instanceCount,
                Topology = topology,
                ObjectToWorld = matrix,
                Block = properties?.Copy(),
            }, material, shaderPass);
        }

        public void Blit(Texture source, RenderTargetIdentifier dest) => Blit(new RenderTargetIdentifier(source), dest);

        public void Blit(Texture source, RenderTargetIdentifier dest, Material mat) => Blit(new RenderTargetIdentifier(source), dest, mat, -1);

        public void Blit(Texture source, RenderTargetIdentifier dest, Material mat, int pass) => Blit(new RenderTargetIdentifier(source), dest, mat, pass);

        public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest) => Record(() =>
        {
            Set(dest, dest.Mip, dest.Face, dest.Slice);
            Blitter.Draw(source.Resolve(), null, -1, new Vector4(1, 1, 0, 0));
        });

        public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest, Material mat) => Blit(source, dest, mat, -1);

        public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest, Material mat, int pass) => Record(() =>
        {
            Set(dest, dest.Mip, dest.Face, dest.Slice);
            Blitter.Draw(source.IsNone ? null : source.Resolve(), mat, pass, new Vector4(1, 1, 0, 0));
        });

        public void GetTemporaryRT(int nameID, RenderTextureDescriptor desc) => GetTemporaryRT(nameID, desc, FilterMode.Point);

        /// <summary>A texture that shaders see under that name until <see cref="ReleaseTemporaryRT"/>.</summary>
        public void GetTemporaryRT(int nameID, RenderTextureDescriptor desc, FilterMode filter) => Record(() =>
        {
            var texture = RenderTexture.GetTemporary(desc);
            texture.filterMode = filter;
            Shader.SetGlobalTexture(nameID, texture);
        });

        public void GetTemporaryRT(int nameID, int width, int height) => GetTemporaryRT(nameID, width, height, 0);

        public void GetTemporaryRT(int nameID, int width, int height, int depthBuffer) =>
            GetTemporaryRT(nameID, new RenderTextureDescriptor(width, height, RenderTextureFormat.Default, depthBuffer, Texture.GenerateAllMips,
                RenderTextureReadWrite.Default));

        public void ReleaseTemporaryRT(int nameID) => Record(() =>
        {
            var texture = Shader.GetGlobalTexture(nameID) as RenderTexture;
            Shader.SetGlobalTexture(nameID, null);
            RenderTexture.ReleaseTemporary(texture);
        });

        public void EnableShaderKeyword(string keyword) => Record(() => Shader.EnableKeyword(keyword));

        public void DisableShaderKeyword(string keyword) => Record(() => Shader.DisableKeyword(keyword));

        public void EnableKeyword(Material material, in LocalKeyword keyword) => SetKeyword(material, keyword, true);

        public void DisableKeyword(Material material, in LocalKeyword keyword) => SetKeyword(material, keyword, false);

        public void SetKeyword(Material material, in LocalKeyword keyword, bool value)
        {
            var copy = keyword;
            Record(() => material.SetKeyword(copy, value));
        }

        public void SetGlobalColor(string name, Color value) => SetGlobalColor(Shader.PropertyToID(name), value);

        public void SetGlobalColor(int nameID, Color value) => Record(() => Shader.SetGlobalColor(nameID, value));

        static void Set(RenderTargetIdentifier rt, int mip, CubemapFace face, int slice)
        {
            RefuseFaces(face);
            DrawTargets.Set(rt.ResolveTarget(), mip, slice);
        }

        static void Set(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth, int mip, CubemapFace face, int slice)
        {
            RefuseFaces(face);
            var targets = new List<RenderTexture>();
            foreach (var color in colors)
                targets.Add(color.ResolveTarget());
            DrawTargets.Set(targets.ToArray(), depth.IsNone ? null : depth.ResolveTarget(), mip, slice);
        }

        static void RefuseFaces(CubemapFace face)
        {
            if (face != CubemapFace.Unknown)
                throw new NotSupportedException("This host has no cube maps.");
        }

        void Draw(DrawItem item, Material material, int shaderPass)
        {
            if (material == null)
                throw new ArgumentNullException(nameof(material));
            Record(() => Run(item, material, shaderPass));
        }

        static void Run(DrawItem item, Material material, int shaderPass)
        {
            // It may have been destroyed since.
            if (material == null)
                return;
            item.Material = material;
            IReadOnlyList<PassProgram> passes = material.Passes;
            if (shaderPass >= passes.Count)
                Debug.LogError($"Trying to access pass {shaderPass}, but material '{material.NameForMessages}' with shader '{material.shader.NameForMessages}' "
                    + $"has {passes.Count}");
            for (var i = 0; i < passes.Count; i++)
                if (shaderPass < 0 || i == shaderPass)
                    Drawer.Draw(item, passes[i]);
        }
    }
}
