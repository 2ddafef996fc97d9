using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem.Composites
{
    /// <summary>A button that counts while another one is held.</summary>
    [DisplayStringFormat("{modifier}+{button}")]
    public class ButtonWithOneModifier : InputBindingComposite<float>
    {
        public int modifier;
        public int button;

        public override float ReadValue(ref InputBindingCompositeContext context) =>
            context.ReadValueAsButton(modifier) ? context.ReadValue<float>(button) : 0f;

        public override float EvaluateMagnitude(ref InputBindingCompositeContext context) => ReadValue(ref context);
    }

    /// <summary>A button that counts while two others are held.</summary>
    [DisplayStringFormat("{modifier1}+{modifier2}+{button}")]
    public class ButtonWithTwoModifiers : InputBindingComposite<float>
    {
        public int modifier1;
        public int modifier2;
        public int button;

        public override float ReadValue(ref InputBindingCompositeContext context) =>
            context.ReadValueAsButton(modifier1) && context.ReadValueAsButton(modifier2) ? context.ReadValue<float>(button) : 0f;

        public override float EvaluateMagnitude(ref InputBindingCompositeContext context) => ReadValue(ref context);
    }
}
