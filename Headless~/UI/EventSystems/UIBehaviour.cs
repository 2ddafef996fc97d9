namespace UnityEngine.EventSystems
{
    /// <summary>Base of uGUI's scripts.</summary>
    public abstract class UIBehaviour : MonoBehaviour
    {
        protected UIBehaviour()
        {
        }

        public virtual bool IsActive() => isActiveAndEnabled;

        public bool IsDestroyed() => this == null;

        protected virtual void Awake()
        {
        }

        protected virtual void OnEnable()
        {
        }

        protected virtual void Start()
        {
        }

        protected virtual void OnDisable()
        {
        }

        protected virtual void OnDestroy()
        {
        }
    }
}
