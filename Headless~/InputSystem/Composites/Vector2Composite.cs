using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem.Composites
{
    /// <summary>Two axes of four buttons, such as WASD, which is called 2DVector in files.</summary>
    [DisplayStringFormat("{up}/{left}/{down}/{right}")]
    public class Vector2Composite : InputBindingComposite<Vector2>
    {
        public int up;
        public int down;
        public int left;
        public int right;
        public Mode mode;

        /// <summary>Whether diagonals are longer, and whether buttons may be pressed halfway.</summary>
        public enum Mode
        {
            Analog = 2,
            DigitalNormalized = 0,
            Digital = 1,
        }

        public override Vector2 ReadValue(ref InputBindingCompositeContext context)
        {
            if (mode == Mode.Analog)
                return new Vector2(
                    context.ReadValue<float>(right) - context.ReadValue<float>(left), context.ReadValue<float>(up) - context.ReadValue<float>(down));
            var vector = new Vector2(
                Number(context.ReadValueAsButton(right)) - Number(context.ReadValueAsButton(left)),
                Number(context.ReadValueAsButton(up)) - Number(context.ReadValueAsButton(down)));
            return mode == Mode.DigitalNormalized ? vector.normalized : vector;
        }

        public override float EvaluateMagnitude(ref InputBindingCompositeContext context) => ReadValue(ref context).magnitude;

        static float Number(bool pressed) => pressed ? 1f : 0f;
    }
}
