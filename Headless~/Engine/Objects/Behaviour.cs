namespace UnityEngine
{
    /// <summary>A component that can be switched on and off.</summary>
    public class Behaviour : Component
    {
        bool m_Enabled = true;
        bool m_Running;

        public bool enabled
        {
            get { Use("get_enabled"); return m_Enabled; }
            set
            {
                Use("set_enabled");
                if (m_Enabled == value)
                    return;
                m_Enabled = value;
                if (value)
                    ActivateIfNeeded();
                else
                    DeactivateIfNeeded();
            }
        }

        public bool isActiveAndEnabled
        {
            get { Use("get_isActiveAndEnabled"); return m_Running; }
        }

        /// <summary>True between OnEnable and OnDisable.</summary>
        internal bool IsRunning => m_Running;

        internal bool EnabledFlag { get => m_Enabled; set => m_Enabled = value; }

        internal virtual int ExecutionOrder => 0;

        /// <summary>Wakes the behaviour if its GameObject is active, and runs it if it is enabled too.</summary>
        internal void ActivateIfNeeded()
        {
            if (!IsAlive(this) || !Owner.IsActive || Owner.IsAsset)
                return;
            if (!WakeUp() || !IsAlive(this) || !Owner.IsActive || !m_Enabled || m_Running)
                return;
            m_Running = true;
            OnRunningChanged(true);
        }

        internal void DeactivateIfNeeded()
        {
            if (!m_Running)
                return;
            m_Running = false;
            OnRunningChanged(false);
        }

        /// <summary>Called before the first run.</summary>
        /// <returns>False if the behaviour must not run.</returns>
        internal virtual bool WakeUp() => true;

        internal virtual void OnRunningChanged(bool running)
        {
        }
    }
}
