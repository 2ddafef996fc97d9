using System.Collections.Generic;

namespace UnityEngine.EventSystems
{
    /// <summary>Knows what user interface the pointer is over and which is selected. The host lays none out: whoever drives it says what the pointer is over.</summary>
    public class EventSystem : UIBehaviour
    {
        static readonly List<EventSystem> s_Enabled = new();

        [SerializeField]
        GameObject m_FirstSelected;

        [SerializeField]
        bool m_sendNavigationEvents = true;

        [SerializeField]
        int m_DragThreshold = 10;

        GameObject m_Selected;

        protected EventSystem()
        {
        }

        /// <summary>The first one that is enabled; null if there is none.</summary>
        public static EventSystem current
        {
            get => s_Enabled.Count > 0 ? s_Enabled[0] : null;
            set
            {
                if (s_Enabled.Remove(value))
                    s_Enabled.Insert(0, value);
            }
        }

        public GameObject firstSelectedGameObject { get => m_FirstSelected; set => m_FirstSelected = value; }

        /// <summary>What the keyboard's input goes to.</summary>
        public GameObject currentSelectedGameObject => m_Selected;

        public bool sendNavigationEvents { get => m_sendNavigationEvents; set => m_sendNavigationEvents = value; }

        public int pixelDragThreshold { get => m_DragThreshold; set => m_DragThreshold = value; }

        public bool isFocused => Application.isFocused;

        /// <summary>What <see cref="IsPointerOverGameObject()"/> answers.</summary>
        internal bool IsPointerOver { get; set; }

        public bool IsPointerOverGameObject() => IsPointerOver;

        public bool IsPointerOverGameObject(int pointerId) => IsPointerOver;

        public void SetSelectedGameObject(GameObject selected) => m_Selected = selected;

        protected override void OnEnable()
        {
            base.OnEnable();
            s_Enabled.Add(this);
        }

        protected override void OnDisable()
        {
            s_Enabled.Remove(this);
            base.OnDisable();
        }
    }
}
