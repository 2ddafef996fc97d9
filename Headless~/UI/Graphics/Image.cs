namespace UnityEngine.UI
{
    /// <summary>A picture or a coloured area.</summary>
    public class Image : MaskableGraphic
    {
        /// <summary>Kept as data.</summary>
        [SerializeField]
        internal Object m_Sprite;

        [SerializeField]
        Type m_Type = Type.Simple;

        [SerializeField]
        bool m_PreserveAspect;

        [SerializeField]
        bool m_FillCenter = true;

        [SerializeField]
        FillMethod m_FillMethod = FillMethod.Radial360;

        [SerializeField]
        float m_FillAmount = 1f;

        [SerializeField]
        bool m_FillClockwise = true;

        [SerializeField]
        int m_FillOrigin;

        [SerializeField]
        bool m_UseSpriteMesh;

        [SerializeField]
        float m_PixelsPerUnitMultiplier = 1f;

        protected Image()
        {
        }

        /// <summary>How the picture fills its area.</summary>
        public enum Type
        {
            Simple,
            Sliced,
            Tiled,
            Filled,
        }

        /// <summary>From where a filled picture is filled.</summary>
        public enum FillMethod
        {
            Horizontal,
            Vertical,
            Radial90,
            Radial180,
            Radial360,
        }

        public Type type { get => m_Type; set => m_Type = value; }

        public bool preserveAspect { get => m_PreserveAspect; set => m_PreserveAspect = value; }

        public bool fillCenter { get => m_FillCenter; set => m_FillCenter = value; }

        public FillMethod fillMethod { get => m_FillMethod; set => m_FillMethod = value; }

        /// <summary>0 to 1.</summary>
        public float fillAmount { get => m_FillAmount; set => m_FillAmount = Mathf.Clamp01(value); }

        public bool fillClockwise { get => m_FillClockwise; set => m_FillClockwise = value; }

        public int fillOrigin { get => m_FillOrigin; set => m_FillOrigin = value; }

        public bool useSpriteMesh { get => m_UseSpriteMesh; set => m_UseSpriteMesh = value; }

        public float pixelsPerUnitMultiplier { get => m_PixelsPerUnitMultiplier; set => m_PixelsPerUnitMultiplier = Mathf.Max(0.01f, value); }
    }
}
