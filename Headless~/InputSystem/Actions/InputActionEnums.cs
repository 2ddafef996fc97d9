namespace UnityEngine.InputSystem
{
    /// <summary>How an action reacts to its controls.</summary>
    public enum InputActionType
    {
        /// <summary>Follows the most actuated control, from the control's value at the time it is enabled on.</summary>
        Value,

        /// <summary>Performs when a control is pressed.</summary>
        Button,

        /// <summary>Performs with every change of any control.</summary>
        PassThrough,
    }

    /// <summary>What an action is doing.</summary>
    public enum InputActionPhase
    {
        Disabled,
        Waiting,
        Started,
        Performed,
        Canceled,
    }

    /// <summary>Questions about phases.</summary>
    public static class InputExtensions
    {
        public static bool IsInProgress(this InputActionPhase phase) => phase is InputActionPhase.Started or InputActionPhase.Performed;
    }
}
