using UnityEngine.InputSystem.Controls;
using UnityEngine.InputSystem.Layouts;

namespace UnityEngine.InputSystem
{
    /// <summary>Something whose place in the room is known.</summary>
    [InputControlLayout(displayName = "Tracked Device", isGenericTypeOfDevice = true)]
    public class TrackedDevice : InputDevice
    {
        [InputControl(synthetic = true)]
        public IntegerControl trackingState { get; protected set; }

        [InputControl(synthetic = true)]
        public ButtonControl isTracked { get; protected set; }

        [InputControl(noisy = true, dontReset = true)]
        public Vector3Control devicePosition { get; protected set; }

        [InputControl(noisy = true, dontReset = true)]
        public QuaternionControl deviceRotation { get; protected set; }

        protected override void FinishSetup()
        {
            trackingState = GetChildControl<IntegerControl>("trackingState");
            isTracked = GetChildControl<ButtonControl>("isTracked");
            devicePosition = GetChildControl<Vector3Control>("devicePosition");
            deviceRotation = GetChildControl<QuaternionControl>("deviceRotation");
            base.FinishSetup();
        }
    }
}

namespace UnityEngine.InputSystem.XR
{
    /// <summary>A controller in a hand, which its usage tells: LeftHand or RightHand.</summary>
    [InputControlLayout(commonUsages = new[] { "LeftHand", "RightHand" }, isGenericTypeOfDevice = true, displayName = "XR Controller")]
    public class XRController : TrackedDevice
    {
        public static XRController leftHand => InputManager.Instance.DeviceWithUsage<XRController>("LeftHand");

        public static XRController rightHand => InputManager.Instance.DeviceWithUsage<XRController>("RightHand");
    }
}
