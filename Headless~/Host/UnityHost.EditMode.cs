using System;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Headless
{
    public sealed partial class UnityHost
    {
        /// <summary>
        /// What the Editor does all the time: calls <see cref="EditorApplication.update"/> and what was put off, goes on with async methods, and
        /// runs a frame if <see cref="EditorApplication.QueuePlayerLoopUpdate"/> asked for one. In edit mode <see cref="Step"/> is the same with a
        /// frame in any case.
        /// </summary>
        /// <returns>Whether a frame was run.</returns>
        public bool Tick()
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            EditorApplication.Tick();
            if (EditorApplication.TakeQueuedPlayerLoop())
            {
                EngineLoop.Step(DefaultFrameSeconds);
                return true;
            }

            EngineLoop.Idle();
            return false;
        }

        /// <summary>
        /// Changes a serialised field as the Inspector does: the script is told by OnValidate in edit mode.
        /// </summary>
        /// <param name="target">A component or an asset.</param>
        /// <param name="path">The field's name; further ones behind dots lead into serialisable classes and structs.</param>
        /// <param name="value">What to put there.</param>
        /// <exception cref="ArgumentException">There is no such serialised field, or the value does not fit.</exception>
        public void SetSerializedField(UnityEngine.Object target, string path, object value)
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            SerializedFields.Set(target, path, value);
            Validation.Send(target);
        }
    }
}
