using System;
using System.Collections;
using System.Threading;

namespace UnityEngine
{
    /// <summary>Base of scripts. Their messages (Awake, Update ...) are found by name, private ones too.</summary>
    public class MonoBehaviour : Behaviour
    {
        readonly Messages m_Messages;
        CancellationTokenSource m_DestroyTokenSource;
        bool m_DidAwake;
        bool m_DidStart;

        public MonoBehaviour() => m_Messages = Messages.Of(GetType());

        public bool didAwake
        {
            get { Use("get_didAwake"); return m_DidAwake; }
        }

        public bool didStart
        {
            get { Use("get_didStart"); return m_DidStart; }
        }

        public bool useGUILayout { get; set; } = true;

        /// <summary>Cancelled when the component is destroyed.</summary>
        /// <exception cref="MissingReferenceException">It is destroyed already and nobody asked for the token before.</exception>
        public CancellationToken destroyCancellationToken
        {
            get
            {
                if (m_DestroyTokenSource == null && !IsAlive(this))
                    throw new MissingReferenceException("DestroyToken should be called atleast once before destroying the monobehaviour object");
                m_DestroyTokenSource ??= new CancellationTokenSource();
                return m_DestroyTokenSource.Token;
            }
        }

        internal Messages Messages => m_Messages;

        internal override int ExecutionOrder => m_Messages.ExecutionOrder;

        /// <summary>In edit mode only scripts that ask for it get messages; others are switched on and off in silence.</summary>
        internal bool HearsMessages => Application.isPlaying || m_Messages.RunsInEditMode;

        public static void print(object message) => Debug.Log(message);

        /// <summary>Runs the routine to its first yield before it returns.</summary>
        /// <returns>Null, with an error in the log, if the GameObject is inactive.</returns>
        public Coroutine StartCoroutine(IEnumerator routine)
        {
            if (routine == null)
                throw new NullReferenceException("routine is null");
            Use("StartCoroutine");
            return Coroutines.Start(this, routine);
        }

        public void StopCoroutine(IEnumerator routine)
        {
            if (routine == null)
                throw new NullReferenceException("routine is null");
            Use("StopCoroutine");
            Coroutines.Stop(this, routine);
        }

        public void StopCoroutine(Coroutine routine)
        {
            if (routine == null)
                throw new NullReferenceException("routine is null");
            Use("StopCoroutine");
            Coroutines.Stop(this, routine);
        }

        public void StopAllCoroutines()
        {
            Use("StopAllCoroutines");
            Coroutines.StopAll(this);
        }

        /// <summary>An Awake that throws disables the component, as in Unity.</summary>
        internal override bool WakeUp()
        {
            if (m_DidAwake || !HearsMessages)
                return true;
            m_DidAwake = true;
            if (m_Messages.Awake.Send(this))
                return true;
            EnabledFlag = false;
            return false;
        }

        internal override void OnRunningChanged(bool running)
        {
            if (!HearsMessages)
                return;
            if (!running)
            {
                ScriptLoop.Remove(this);
                m_Messages.OnDisable.Send(this);
                return;
            }

            ScriptLoop.Add(this);
            m_Messages.OnEnable.Send(this);
        }

        internal void StartIfNeeded()
        {
            if (m_DidStart || !IsRunning)
                return;
            m_DidStart = true;
            if (m_Messages.Start.SendRoutine(this) is { } routine && IsAlive(this) && Owner.IsActive)
                Coroutines.Start(this, routine);
        }

        /// <summary>The last message, which only an awakened script gets.</summary>
        internal void SendOnDestroy()
        {
            if (m_DestroyTokenSource is { } source)
                LogRouter.Guard(source.Cancel);
            if (m_DidAwake)
                m_Messages.OnDestroy.Send(this);
        }
    }
}
