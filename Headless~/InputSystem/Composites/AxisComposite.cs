using UnityEngine.InputSystem.Processors;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem.Composites
{
    /// <summary>An axis of two buttons, which is called 1DAxis in files.</summary>
    [DisplayStringFormat("{negative}/{positive}")]
    public class AxisComposite : InputBindingComposite<float>
    {
        public int negative = 0;
        public int positive = 0;
        public float minValue = -1;
        public float maxValue = 1;
        public WhichSideWins whichSideWins = WhichSideWins.Neither;

        /// <summary>What counts when both are actuated.</summary>
        public enum WhichSideWins
        {
            Neither = 0,
            Positive = 1,
            Negative = 2,
        }

        public float midPoint => (maxValue + minValue) / 2;

        public override float ReadValue(ref InputBindingCompositeContext context)
        {
            var low = Mathf.Abs(context.ReadValue<float>(negative));
            var high = Mathf.Abs(context.ReadValue<float>(positive));
            var takesLow = low > Mathf.Epsilon;
            if (takesLow == high > Mathf.Epsilon)
            {
                if (whichSideWins == WhichSideWins.Neither)
                    return midPoint;
                takesLow = whichSideWins == WhichSideWins.Negative;
            }

            return takesLow ? midPoint - (midPoint - minValue) * low : midPoint + (maxValue - midPoint) * high;
        }

        public override float EvaluateMagnitude(ref InputBindingCompositeContext context)
        {
            var value = ReadValue(ref context);
            return NormalizeProcessor.Normalize(Mathf.Abs(value - midPoint), 0, Mathf.Abs(value < midPoint ? minValue : maxValue), 0);
        }
    }
}
