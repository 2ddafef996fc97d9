using System.Collections.Generic;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>Several actions.</summary>
    public interface IInputActionCollection : IEnumerable<InputAction>
    {
        InputBinding? bindingMask { get; set; }

        ReadOnlyArray<InputDevice>? devices { get; set; }

        ReadOnlyArray<InputControlScheme> controlSchemes { get; }

        bool Contains(InputAction action);

        void Enable();

        void Disable();
    }

    /// <summary>Several actions that one can look for.</summary>
    public interface IInputActionCollection2 : IInputActionCollection
    {
        IEnumerable<InputBinding> bindings { get; }

        InputAction FindAction(string actionNameOrId, bool throwIfNotFound = false);

        int FindBinding(InputBinding mask, out InputAction action);
    }
}
