using UnityEngine.InputSystem.Layouts;

namespace UnityEngine.InputSystem.Controls
{
    /// <summary>A movement since the frame before, which goes back to zero by itself.</summary>
    public class DeltaControl : Vector2Control
    {
        [InputControl(useStateFrom = "y", parameters = "clamp=1,clampMin=0,clampMax=3.402823E+38", synthetic = true, displayName = "Up")]
        public AxisControl up { get; set; }

        [InputControl(useStateFrom = "y", parameters = "clamp=1,clampMin=-3.402823E+38,clampMax=0,invert", synthetic = true, displayName = "Down")]
        public AxisControl down { get; set; }

        [InputControl(useStateFrom = "x", parameters = "clamp=1,clampMin=-3.402823E+38,clampMax=0,invert", synthetic = true, displayName = "Left")]
        public AxisControl left { get; set; }

        [InputControl(useStateFrom = "x", parameters = "clamp=1,clampMin=0,clampMax=3.402823E+38", synthetic = true, displayName = "Right")]
        public AxisControl right { get; set; }

        protected override void FinishSetup()
        {
            up = GetChildControl<AxisControl>("up");
            down = GetChildControl<AxisControl>("down");
            left = GetChildControl<AxisControl>("left");
            right = GetChildControl<AxisControl>("right");
            base.FinishSetup();
        }
    }
}
