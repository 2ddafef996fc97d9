using UnityEngine;
using UnityEngine.UI;

namespace AnatomyCarve.Desktop
{
    /// <summary>Shows the name of the segment under the mouse in the Text on its GameObject: green if it stays, red if the active sphere clips it.</summary>
    [AddComponentMenu("AnatomyCarve/Pointer Label")]
    [RequireComponent(typeof(Text))]
    [DisallowMultipleComponent]
    [ManualPage("components")]
    public sealed class PointerLabel : MonoBehaviour
    {
        [SerializeField, Tooltip("What points; empty = the one on this GameObject")]
        MousePointer pointer;

        [SerializeField, Tooltip("The name of a segment that stays")]
        Color staysColor = new Color(0.45f, 0.9f, 0.5f);

        [SerializeField, Tooltip("The name of a segment that the active sphere clips")]
        Color clippedColor = new Color(1f, 0.5f, 0.45f);

        Text text;
        MousePointer shown;

        /// <summary>What points: the one that was set, or else the one on this GameObject. Taken when the component is enabled.</summary>
        public MousePointer Pointer
        {
            get => this.WiredOrSibling(pointer);
            set => pointer = value;
        }

        void OnEnable()
        {
            text = GetComponent<Text>();
            shown = Pointer;
            if (shown != null)
                shown.Changed += Show;
            Show();
        }

        void Start() => enabled = this.Has(Pointer, nameof(Pointer));

        void OnDisable()
        {
            if (shown != null)
                shown.Changed -= Show;
            shown = null;
            Show();
        }

        void Show()
        {
            text.text = shown != null ? shown.Label : "";
            text.color = shown != null && shown.WillBeClipped ? clippedColor : staysColor;
        }
    }
}
