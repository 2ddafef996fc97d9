using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering
{
    /// <summary>What a pipeline hands its work to. Commands wait for the camera they belong to, or for Submit.</summary>
    public struct ScriptableRenderContext : IEquatable<ScriptableRenderContext>
    {
        readonly List<Action> m_Waiting;

        ScriptableRenderContext(List<Action> waiting) => m_Waiting = waiting;

        internal static ScriptableRenderContext Create() => new(new List<Action>());

        /// <summary>Takes over what the buffer holds now; it may be cleared at once.</summary>
        public void ExecuteCommandBuffer(CommandBuffer commandBuffer)
        {
            if (commandBuffer == null)
                throw new ArgumentNullException(nameof(commandBuffer));
            Waiting.AddRange(commandBuffer.Snapshot());
        }

        /// <summary>Makes a camera's matrices those of all that follows.</summary>
        public void SetupCameraProperties(Camera camera, bool stereoSetup = false)
        {
            if (camera == null)
                throw new ArgumentNullException(nameof(camera));
            Waiting.Add(() => Drawer.View = CameraPicture.Of(camera)[0].View);
        }

        /// <summary>Runs all that was handed in.</summary>
        public void Submit() => Flush();

        internal readonly void Flush()
        {
            var waiting = Waiting.ToArray();
            Waiting.Clear();
            foreach (var command in waiting)
                LogRouter.Guard(command);
        }

        readonly List<Action> Waiting => m_Waiting ?? throw new InvalidOperationException(
            "The ScriptableRenderContext instance is not valid. This can happen if you construct it using the default constructor.");

        public override readonly bool Equals(object obj) => obj is ScriptableRenderContext other && Equals(other);

        public readonly bool Equals(ScriptableRenderContext other) => ReferenceEquals(m_Waiting, other.m_Waiting);

        public override readonly int GetHashCode() => m_Waiting?.GetHashCode() ?? 0;

        public static bool operator ==(ScriptableRenderContext left, ScriptableRenderContext right) => left.Equals(right);

        public static bool operator !=(ScriptableRenderContext left, ScriptableRenderContext right) => !left.Equals(right);
    }
}
