using System;
using System.Collections;

namespace UnityEngine
{
    /// <summary>Waits for scaled time: at least one frame.</summary>
    public sealed class WaitForSeconds : YieldInstruction
    {
        public WaitForSeconds(float seconds) => Seconds = seconds;

        internal float Seconds { get; }
    }

    /// <summary>Waits for the next fixed step.</summary>
    public sealed class WaitForFixedUpdate : YieldInstruction
    {
    }

    /// <summary>Waits until this frame's cameras are done.</summary>
    public sealed class WaitForEndOfFrame : YieldInstruction
    {
    }

    /// <summary>A wait of one's own: goes on when <see cref="keepWaiting"/> is false, asked once per frame.</summary>
    public abstract class CustomYieldInstruction : IEnumerator
    {
        public abstract bool keepWaiting { get; }

        public object Current => null;

        public bool MoveNext() => keepWaiting;

        public virtual void Reset()
        {
        }
    }

    /// <summary>Which clock a time-out goes by.</summary>
    public enum WaitTimeoutMode
    {
        Realtime = 0,
        InGameTime = 1,
    }

    /// <summary>Waits until a condition holds.</summary>
    public sealed class WaitUntil : CustomYieldInstruction
    {
        readonly Func<bool> m_Predicate;
        readonly WaitTimeout m_Timeout;

        public WaitUntil(Func<bool> predicate) => m_Predicate = predicate;

        public WaitUntil(Func<bool> predicate, TimeSpan timeout, Action onTimeout, WaitTimeoutMode timeoutMode = WaitTimeoutMode.Realtime) : this(predicate) =>
            m_Timeout = new WaitTimeout(timeout, onTimeout, timeoutMode);

        public override bool keepWaiting => m_Timeout is not { IsOver: true } && !m_Predicate();
    }

    /// <summary>The end of patience of a wait, announced once.</summary>
    sealed class WaitTimeout
    {
        readonly WaitTimeoutMode m_Mode;
        readonly double m_Until;
        readonly Action m_OnTimeout;
        bool m_Over;

        internal WaitTimeout(TimeSpan timeout, Action onTimeout, WaitTimeoutMode mode)
        {
            if (timeout <= TimeSpan.Zero)
                throw new ArgumentException("Timeout must be greater than zero", nameof(timeout));
            m_OnTimeout = onTimeout ?? throw new ArgumentNullException(nameof(onTimeout), "Timeout callback must be specified");
            m_Mode = mode;
            m_Until = Now + timeout.TotalSeconds;
        }

        internal bool IsOver
        {
            get
            {
                if (!m_Over && Now >= m_Until)
                {
                    m_Over = true;
                    m_OnTimeout();
                }

                return m_Over;
            }
        }

        double Now => m_Mode == WaitTimeoutMode.Realtime ? Time.realtimeSinceStartupAsDouble : Time.timeAsDouble;
    }
}
