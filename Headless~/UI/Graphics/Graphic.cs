using System;
using UnityEngine.Events;
using UnityEngine.EventSystems;

namespace UnityEngine.UI
{
    /// <summary>A visible piece of user interface.</summary>
    [RequireComponent(typeof(CanvasRenderer))]
    public abstract class Graphic : UIBehaviour
    {
        /// <summary>Kept as data.</summary>
        [SerializeField]
        internal Object m_Material;

        [SerializeField]
        Color m_Color = Color.white;

        [SerializeField]
        bool m_RaycastTarget = true;

        [SerializeField]
        Vector4 m_RaycastPadding;

        protected Graphic()
        {
        }

        public virtual Color color { get => m_Color; set => m_Color = value; }

        /// <summary>Whether the pointer meets it.</summary>
        public virtual bool raycastTarget { get => m_RaycastTarget; set => m_RaycastTarget = value; }

        public Vector4 raycastPadding { get => m_RaycastPadding; set => m_RaycastPadding = value; }

        /// <summary>The canvas that it lies in; null if there is none.</summary>
        public Canvas canvas => GetComponentInParent<Canvas>();

        public CanvasRenderer canvasRenderer => GetComponent<CanvasRenderer>();
    }

    /// <summary>A graphic that a mask may hide.</summary>
    public abstract class MaskableGraphic : Graphic
    {
        [SerializeField]
        bool m_Maskable = true;

        [SerializeField]
        CullStateChangedEvent m_OnCullStateChanged = new();

        protected MaskableGraphic()
        {
        }

        public bool maskable { get => m_Maskable; set => m_Maskable = value; }

        public CullStateChangedEvent onCullStateChanged { get => m_OnCullStateChanged; set => m_OnCullStateChanged = value; }

        [Serializable]
        public class CullStateChangedEvent : UnityEvent<bool>
        {
        }
    }
}
