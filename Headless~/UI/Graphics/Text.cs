using System;

namespace UnityEngine.UI
{
    /// <summary>Letters.</summary>
    public class Text : MaskableGraphic
    {
        [SerializeField]
        protected string m_Text = "";

        [SerializeField]
        FontData m_FontData = FontData.defaultFontData;

        protected Text()
        {
        }

        /// <summary>Null is taken as empty.</summary>
        public virtual string text { get => m_Text; set => m_Text = value ?? ""; }

        public bool supportRichText { get => m_FontData.richText; set => m_FontData.richText = value; }

        public bool resizeTextForBestFit { get => m_FontData.bestFit; set => m_FontData.bestFit = value; }

        public int resizeTextMinSize { get => m_FontData.minSize; set => m_FontData.minSize = value; }

        public int resizeTextMaxSize { get => m_FontData.maxSize; set => m_FontData.maxSize = value; }

        public TextAnchor alignment { get => m_FontData.alignment; set => m_FontData.alignment = value; }

        public bool alignByGeometry { get => m_FontData.alignByGeometry; set => m_FontData.alignByGeometry = value; }

        public int fontSize { get => m_FontData.fontSize; set => m_FontData.fontSize = value; }

        public FontStyle fontStyle { get => m_FontData.fontStyle; set => m_FontData.fontStyle = value; }

        public float lineSpacing { get => m_FontData.lineSpacing; set => m_FontData.lineSpacing = value; }

        public HorizontalWrapMode horizontalOverflow { get => m_FontData.horizontalOverflow; set => m_FontData.horizontalOverflow = value; }

        public VerticalWrapMode verticalOverflow { get => m_FontData.verticalOverflow; set => m_FontData.verticalOverflow = value; }
    }

    /// <summary>How letters look.</summary>
    [Serializable]
    public class FontData
    {
        /// <summary>Kept as data.</summary>
        [SerializeField]
        internal Object m_Font;

        [SerializeField]
        int m_FontSize;

        [SerializeField]
        FontStyle m_FontStyle;

        [SerializeField]
        bool m_BestFit;

        [SerializeField]
        int m_MinSize;

        [SerializeField]
        int m_MaxSize;

        [SerializeField]
        TextAnchor m_Alignment;

        [SerializeField]
        bool m_AlignByGeometry;

        [SerializeField]
        bool m_RichText;

        [SerializeField]
        HorizontalWrapMode m_HorizontalOverflow;

        [SerializeField]
        VerticalWrapMode m_VerticalOverflow;

        [SerializeField]
        float m_LineSpacing;

        /// <summary>A new one with uGUI's own values.</summary>
        public static FontData defaultFontData => new() { fontSize = 14, lineSpacing = 1f, minSize = 10, maxSize = 40, richText = true };

        public int fontSize { get => m_FontSize; set => m_FontSize = value; }

        public FontStyle fontStyle { get => m_FontStyle; set => m_FontStyle = value; }

        public bool bestFit { get => m_BestFit; set => m_BestFit = value; }

        public int minSize { get => m_MinSize; set => m_MinSize = value; }

        public int maxSize { get => m_MaxSize; set => m_MaxSize = value; }

        public TextAnchor alignment { get => m_Alignment; set => m_Alignment = value; }

        public bool alignByGeometry { get => m_AlignByGeometry; set => m_AlignByGeometry = value; }

        public bool richText { get => m_RichText; set => m_RichText = value; }

        public HorizontalWrapMode horizontalOverflow { get => m_HorizontalOverflow; set => m_HorizontalOverflow = value; }

        public VerticalWrapMode verticalOverflow { get => m_VerticalOverflow; set => m_VerticalOverflow = value; }

        public float lineSpacing { get => m_LineSpacing; set => m_LineSpacing = value; }
    }
}
