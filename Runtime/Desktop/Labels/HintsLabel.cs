using System.Text;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.UI;

namespace AnatomyCarve.Desktop
{
    /// <summary>Shows what mouse and keys do, in two columns, until the key for that hides them.</summary>
    [AddComponentMenu("AnatomyCarve/Hints Label")]
    [DisallowMultipleComponent]
    [ManualPage("components")]
    public sealed class HintsLabel : MonoBehaviour
    {
        [SerializeField, Tooltip("The column of keys and buttons")]
        Text keys;

        [SerializeField, Tooltip("The column of what they do")]
        Text deeds;

        [SerializeField, Tooltip("What is hidden and shown; not this component's own GameObject")]
        GameObject panel;

        [SerializeField, Tooltip("Other controls: a map 'Desktop' with the actions of the package's own; empty = those")]
        InputActionAsset controls;

        [SerializeField, Tooltip("Says when the keys belong to something else; empty = never")]
        InputGate gate;

        ControlSet input;
        InputAction toggle;

        /// <summary>The column of keys and buttons.</summary>
        public Text Keys { get => keys; set => keys = value; }

        /// <summary>The column of what they do.</summary>
        public Text Deeds { get => deeds; set => deeds = value; }

        /// <summary>What is hidden and shown; null = nothing is.</summary>
        public GameObject Panel { get => panel; set => panel = value; }

        /// <summary>Other controls than the package's; taken when the component is enabled. Null = the package's.</summary>
        public InputActionAsset Controls { get => controls; set => controls = value; }

        /// <summary>Says when the keys belong to something else; null = never.</summary>
        public InputGate Gate { get => gate; set => gate = value; }

        /// <summary>Writes the hints anew, after controls were bound to other keys.</summary>
        public void Refresh()
        {
            var left = new StringBuilder();
            var right = new StringBuilder();
            foreach (string line in DesktopHints.Describe(controls).Split('\n'))
            {
                int tab = line.IndexOf('\t');
                left.Append(tab < 0 ? "" : line.Substring(0, tab)).Append('\n');
                right.Append(line.Substring(tab + 1)).Append('\n');
            }
            if (keys != null)
                keys.text = left.ToString().TrimEnd();
            if (deeds != null)
                deeds.text = right.ToString().TrimEnd();
        }

        void OnEnable()
        {
            input = new ControlSet(controls, this);
            toggle = input.Button("Toggle Hints");
            if (input.Enable())
                Refresh();
            else
                enabled = false;
        }

        void OnDisable() => input?.Release();

        void Update()
        {
            if (panel != null && toggle.WasPerformedThisFrame() && !InputGate.AreKeysBlocked(gate))
                panel.SetActive(!panel.activeSelf);
        }
    }
}
