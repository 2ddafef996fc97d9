using System;
using System.Collections.Generic;
using Unity.Profiling;

namespace UnityEngine.Rendering
{
    /// <summary>
    /// A recorded list of work. Values are captured when they are recorded, textures and buffers by reference. What it sets on a
    /// ComputeShader when it runs stays set there.
    /// </summary>
    public partial class CommandBuffer : IDisposable
    {
        // What Unity reports for an empty buffer is not known; this counts commands.
        const int BytesPerCommand = 64;

        readonly List<Action> m_Commands = new();
        readonly Stack<string> m_Samples = new();
        string m_Name = "Unnamed command buffer";
        bool m_Released;

        public string name
        {
            get => m_Name;
            set => m_Name = value ?? "";
        }

        /// <summary>Grows with what is recorded.</summary>
        public int sizeInBytes => m_Commands.Count * BytesPerCommand;

        /// <summary>Forgets all commands.</summary>
        public void Clear()
        {
            Check();
            m_Commands.Clear();
            m_Samples.Clear();
        }

        public void Release() => Dispose();

        public void Dispose()
        {
            m_Released = true;
            m_Commands.Clear();
        }

        /// <summary>Begins a named stretch; ends must balance and nest.</summary>
        public void BeginSample(string name)
        {
            m_Samples.Push(name);
            var marker = new ProfilerMarker(name);
            Record(() => marker.Begin());
        }

        public void EndSample(string name)
        {
            if (m_Samples.Count == 0 || m_Samples.Pop() != name)
                Debug.LogError($"CommandBuffer: EndSample of '{name}' does not match the last BeginSample ({m_Name}).");
            var marker = new ProfilerMarker(name);
            Record(() => marker.End());
        }

        public void BeginSample(ProfilerMarker marker) => Record(() => marker.Begin());

        public void EndSample(ProfilerMarker marker) => Record(() => marker.End());

        public void CopyTexture(RenderTargetIdentifier src, RenderTargetIdentifier dst) =>
            Record(() => Graphics.CopyTexture(Existing(src), Existing(dst)));

        public void CopyTexture(RenderTargetIdentifier src, int srcElement, RenderTargetIdentifier dst, int dstElement) =>
            Record(() => Graphics.CopyTexture(Existing(src), srcElement, Existing(dst), dstElement));

        public void CopyTexture(RenderTargetIdentifier src, int srcElement, int srcMip, RenderTargetIdentifier dst, int dstElement, int dstMip) =>
            Record(() => Graphics.CopyTexture(Existing(src), srcElement, srcMip, Existing(dst), dstElement, dstMip));

        public void CopyTexture(RenderTargetIdentifier src, int srcElement, int srcMip, int srcX, int srcY, int srcWidth, int srcHeight,
            RenderTargetIdentifier dst, int dstElement, int dstMip, int dstX, int dstY) =>
            Record(() => Graphics.CopyTexture(Existing(src), srcElement, srcMip, srcX, srcY, srcWidth, srcHeight, Existing(dst), dstElement, dstMip,
                dstX, dstY));

        public void CopyBuffer(GraphicsBuffer source, GraphicsBuffer dest) => Record(() => Graphics.CopyBuffer(source, dest));

        /// <summary>Sets a texture that all shaders see unless they have their own.</summary>
        public void SetGlobalTexture(string name, RenderTargetIdentifier value) => SetGlobalTexture(Shader.PropertyToID(name), value);

        public void SetGlobalTexture(int nameID, RenderTargetIdentifier value) => Record(() => Shader.SetGlobalTexture(nameID, value.Resolve()));

        public void SetGlobalBuffer(string name, GraphicsBuffer value) => SetGlobalBuffer(Shader.PropertyToID(name), value);

        public void SetGlobalBuffer(int nameID, GraphicsBuffer value) => Record(() => Shader.SetGlobalBuffer(nameID, value));

        public void SetGlobalFloat(string name, float value) => SetGlobalFloat(Shader.PropertyToID(name), value);

        public void SetGlobalFloat(int nameID, float value) => Record(() => Shader.SetGlobalFloat(nameID, value));

        public void SetGlobalVector(string name, Vector4 value) => SetGlobalVector(Shader.PropertyToID(name), value);

        public void SetGlobalVector(int nameID, Vector4 value) => Record(() => Shader.SetGlobalVector(nameID, value));

        public void SetGlobalMatrix(string name, Matrix4x4 value) => SetGlobalMatrix(Shader.PropertyToID(name), value);

        public void SetGlobalMatrix(int nameID, Matrix4x4 value) => Record(() => Shader.SetGlobalMatrix(nameID, value));

        /// <summary>Runs everything in order. A command that throws is logged, and the next one runs.</summary>
        internal void Execute()
        {
            Check();
            if (m_Samples.Count > 0)
                Debug.LogError($"CommandBuffer: BeginSample of '{m_Samples.Peek()}' has no EndSample ({m_Name}).");
            foreach (var command in m_Commands.ToArray())
                LogRouter.Guard(command);
        }

        /// <summary>What is recorded now.</summary>
        internal Action[] Snapshot()
        {
            Check();
            return m_Commands.ToArray();
        }

        static Texture Existing(RenderTargetIdentifier id)
        {
            var texture = id.Resolve();
            return texture != null ? texture : throw new ArgumentException("CommandBuffer: there is no texture behind " + id);
        }

        void Record(Action command)
        {
            Check();
            m_Commands.Add(command);
        }

        void Check()
        {
            MainThread.Check("CommandBuffer");
            if (m_Released)
                throw new NullReferenceException($"The CommandBuffer '{m_Name}' was released and cannot be used any more.");
        }
    }
}
