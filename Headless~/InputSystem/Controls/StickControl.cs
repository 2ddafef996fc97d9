using UnityEngine.InputSystem.Layouts;

namespace UnityEngine.InputSystem.Controls
{
    /// <summary>A thumbstick: two axes and the four buttons that they make.</summary>
    public class StickControl : Vector2Control
    {
        [InputControl(useStateFrom = "y", processors = "axisDeadzone", parameters = "clamp=2,clampMin=0,clampMax=1", synthetic = true, displayName = "Up")]
        [InputControl(name = "x", layout = "Axis", processors = "axisDeadzone")]
        [InputControl(name = "y", layout = "Axis", processors = "axisDeadzone")]
        public ButtonControl up { get; set; }

        [InputControl(useStateFrom = "y", processors = "axisDeadzone", parameters = "clamp=2,clampMin=-1,clampMax=0,invert", synthetic = true, displayName = "Down")]
        public ButtonControl down { get; set; }

        [InputControl(useStateFrom = "x", processors = "axisDeadzone", parameters = "clamp=2,clampMin=-1,clampMax=0,invert", synthetic = true, displayName = "Left")]
        public ButtonControl left { get; set; }

        [InputControl(useStateFrom = "x", processors = "axisDeadzone", parameters = "clamp=2,clampMin=0,clampMax=1", synthetic = true, displayName = "Right")]
        public ButtonControl right { get; set; }

        protected override void FinishSetup()
        {
            up = GetChildControl<ButtonControl>("up");
            down = GetChildControl<ButtonControl>("down");
            left = GetChildControl<ButtonControl>("left");
            right = GetChildControl<ButtonControl>("right");
            base.FinishSetup();
        }
    }
}
