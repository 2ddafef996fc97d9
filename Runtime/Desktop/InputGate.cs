using UnityEngine;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// Says when mouse and keys belong to something else, a user interface as a rule. A project that has one derives a class from this, puts it in the
    /// scene and wires it to the components of this package, which need not know the user interface then. A gesture that began before goes on.
    /// </summary>
    /// <example><code>
    /// public sealed class UiGate : InputGate
    /// {
    ///     public override bool BlocksPointer =&gt; EventSystem.current != null &amp;&amp; EventSystem.current.IsPointerOverGameObject();
    ///     public override bool BlocksKeys =&gt; EventSystem.current != null &amp;&amp; EventSystem.current.currentSelectedGameObject != null;
    /// }
    /// </code></example>
    public abstract class InputGate : MonoBehaviour
    {
        /// <summary>Whether the mouse is over something else: no drag, click or turn of the wheel begins.</summary>
        public abstract bool BlocksPointer { get; }

        /// <summary>Whether what is typed goes to something else: no key does anything.</summary>
        public abstract bool BlocksKeys { get; }

        internal static bool IsPointerBlocked(InputGate gate) => gate != null && gate.isActiveAndEnabled && gate.BlocksPointer;

        internal static bool AreKeysBlocked(InputGate gate) => gate != null && gate.isActiveAndEnabled && gate.BlocksKeys;
    }
}
