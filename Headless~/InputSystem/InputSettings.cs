namespace UnityEngine.InputSystem
{
    /// <summary>How input is taken in.</summary>
    public class InputSettings : ScriptableObject
    {
        [SerializeField]
        UpdateMode m_UpdateMode = UpdateMode.ProcessEventsInDynamicUpdate;

        [SerializeField]
        BackgroundBehavior m_BackgroundBehavior = BackgroundBehavior.ResetAndDisableNonBackgroundDevices;

        [SerializeField]
        EditorInputBehaviorInPlayMode m_EditorInputBehaviorInPlayMode;

        [SerializeField]
        ScrollDeltaBehavior m_ScrollDeltaBehavior = ScrollDeltaBehavior.UniformAcrossAllPlatforms;

        [SerializeField]
        float m_DefaultDeadzoneMin = 0.125f;

        [SerializeField]
        float m_DefaultDeadzoneMax = 0.925f;

        [SerializeField]
        float m_DefaultButtonPressPoint = 0.5f;

        [SerializeField]
        float m_ButtonReleaseThreshold = 0.75f;

        /// <summary>When in a frame input is taken in.</summary>
        public enum UpdateMode
        {
            ProcessEventsInDynamicUpdate = 1,
            ProcessEventsInFixedUpdate,
            ProcessEventsManually,
        }

        /// <summary>What happens while another program has the focus; the host always has it.</summary>
        public enum BackgroundBehavior
        {
            ResetAndDisableNonBackgroundDevices = 0,
            ResetAndDisableAllDevices = 1,
            IgnoreFocus = 2,
        }

        /// <summary>Which input the Editor's game view gets; the host is no Editor.</summary>
        public enum EditorInputBehaviorInPlayMode
        {
            PointersAndKeyboardsRespectGameViewFocus,
            AllDevicesRespectGameViewFocus,
            AllDeviceInputAlwaysGoesToGameView,
        }

        /// <summary>Whether a notch of the wheel is 1 everywhere, or what the platform says: 120 on Windows.</summary>
        public enum ScrollDeltaBehavior
        {
            UniformAcrossAllPlatforms = 0,
            KeepPlatformSpecificInputRange = 1,
        }

        /// <exception cref="System.NotSupportedException">Updates in FixedUpdate are not implemented headless.</exception>
        public UpdateMode updateMode
        {
            get => m_UpdateMode;
            set => m_UpdateMode = value != UpdateMode.ProcessEventsInFixedUpdate
                ? value
                : throw new System.NotSupportedException("Input updates in FixedUpdate are not implemented headless");
        }

        public BackgroundBehavior backgroundBehavior { get => m_BackgroundBehavior; set => m_BackgroundBehavior = value; }

        public EditorInputBehaviorInPlayMode editorInputBehaviorInPlayMode
        {
            get => m_EditorInputBehaviorInPlayMode;
            set => m_EditorInputBehaviorInPlayMode = value;
        }

        public ScrollDeltaBehavior scrollDeltaBehavior { get => m_ScrollDeltaBehavior; set => m_ScrollDeltaBehavior = value; }

        public float defaultDeadzoneMin { get => m_DefaultDeadzoneMin; set => m_DefaultDeadzoneMin = value; }

        public float defaultDeadzoneMax { get => m_DefaultDeadzoneMax; set => m_DefaultDeadzoneMax = value; }

        /// <summary>From where on a button is pressed.</summary>
        public float defaultButtonPressPoint { get => m_DefaultButtonPressPoint; set => m_DefaultButtonPressPoint = Mathf.Max(value, 0.0001f); }

        /// <summary>Share of the press point below which a pressed button is released again.</summary>
        public float buttonReleaseThreshold { get => m_ButtonReleaseThreshold; set => m_ButtonReleaseThreshold = value; }
    }
}
