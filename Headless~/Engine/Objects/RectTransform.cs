using System;

namespace UnityEngine
{
    /// <summary>A transform with a rectangle, laid out between anchors in its parent's rectangle.</summary>
    public sealed class RectTransform : Transform
    {
        Vector2 m_AnchorMin = new(0.5f, 0.5f);
        Vector2 m_AnchorMax = new(0.5f, 0.5f);
        Vector2 m_AnchoredPosition;
        Vector2 m_SizeDelta = new(100f, 100f);
        Vector2 m_Pivot = new(0.5f, 0.5f);

        public RectTransform()
        {
        }

        /// <summary>The axis along which a size is set.</summary>
        public enum Axis
        {
            Horizontal = 0,
            Vertical = 1,
        }

        /// <summary>The lower left anchor, in shares of the parent's rectangle.</summary>
        public Vector2 anchorMin
        {
            get { Use("get_anchorMin"); return m_AnchorMin; }
            set { Use("set_anchorMin"); m_AnchorMin = value; Lay(); }
        }

        /// <summary>The upper right anchor.</summary>
        public Vector2 anchorMax
        {
            get { Use("get_anchorMax"); return m_AnchorMax; }
            set { Use("set_anchorMax"); m_AnchorMax = value; Lay(); }
        }

        /// <summary>The pivot's place relative to the anchors' reference point.</summary>
        public Vector2 anchoredPosition
        {
            get { Use("get_anchoredPosition"); return m_AnchoredPosition; }
            set { Use("set_anchoredPosition"); m_AnchoredPosition = value; Lay(); }
        }

        public Vector3 anchoredPosition3D
        {
            get => new(anchoredPosition.x, anchoredPosition.y, localPosition.z);
            set
            {
                anchoredPosition = value;
                localPosition = new Vector3(localPosition.x, localPosition.y, value.z);
            }
        }

        /// <summary>How much larger the rectangle is than the anchors' distance.</summary>
        public Vector2 sizeDelta
        {
            get { Use("get_sizeDelta"); return m_SizeDelta; }
            set { Use("set_sizeDelta"); m_SizeDelta = value; Lay(); }
        }

        /// <summary>The point that the position means, in shares of the rectangle.</summary>
        public Vector2 pivot
        {
            get { Use("get_pivot"); return m_Pivot; }
            set { Use("set_pivot"); m_Pivot = value; Lay(); }
        }

        /// <summary>The lower left corner relative to the lower left anchor.</summary>
        public Vector2 offsetMin
        {
            get => anchoredPosition - Vector2.Scale(sizeDelta, pivot);
            set
            {
                var change = value - offsetMin;
                sizeDelta -= change;
                anchoredPosition += Vector2.Scale(change, Vector2.one - pivot);
            }
        }

        /// <summary>The upper right corner relative to the upper right anchor.</summary>
        public Vector2 offsetMax
        {
            get => anchoredPosition + Vector2.Scale(sizeDelta, Vector2.one - pivot);
            set
            {
                var change = value - offsetMax;
                sizeDelta += change;
                anchoredPosition += Vector2.Scale(change, pivot);
            }
        }

        /// <summary>The rectangle in local space.</summary>
        public Rect rect
        {
            get
            {
                Use("get_rect");
                var size = m_SizeDelta + Vector2.Scale(m_AnchorMax - m_AnchorMin, ParentSize);
                return new Rect(-size.x * m_Pivot.x, -size.y * m_Pivot.y, size.x, size.y);
            }
        }

        Vector2 ParentSize => ParentOrNull is RectTransform p ? new Vector2(p.rect.width, p.rect.height) : Vector2.zero;

        public void SetSizeWithCurrentAnchors(Axis axis, float size)
        {
            var i = (int)axis;
            var delta = sizeDelta;
            delta[i] = size - ParentSize[i] * (m_AnchorMax[i] - m_AnchorMin[i]);
            sizeDelta = delta;
        }

        /// <summary>Lower left, upper left, upper right, lower right.</summary>
        public void GetLocalCorners(Vector3[] fourCornersArray)
        {
            if (fourCornersArray == null || fourCornersArray.Length < 4)
            {
                Debug.LogError("Calling GetLocalCorners with an array that is null or has less than 4 elements.");
                return;
            }

            var r = rect;
            fourCornersArray[0] = new Vector3(r.x, r.y, 0f);
            fourCornersArray[1] = new Vector3(r.x, r.yMax, 0f);
            fourCornersArray[2] = new Vector3(r.xMax, r.yMax, 0f);
            fourCornersArray[3] = new Vector3(r.xMax, r.y, 0f);
        }

        public void GetWorldCorners(Vector3[] fourCornersArray)
        {
            if (fourCornersArray == null || fourCornersArray.Length < 4)
            {
                Debug.LogError("Calling GetWorldCorners with an array that is null or has less than 4 elements.");
                return;
            }

            GetLocalCorners(fourCornersArray);
            for (var i = 0; i < 4; i++)
                fourCornersArray[i] = TransformPoint(fourCornersArray[i]);
        }

        /// <summary>Sets the layout as a file gives it; the local position stands in the file too.</summary>
        internal void SetLayout(Vector2 anchorMin, Vector2 anchorMax, Vector2 anchoredPosition, Vector2 sizeDelta, Vector2 pivot) =>
            (m_AnchorMin, m_AnchorMax, m_AnchoredPosition, m_SizeDelta, m_Pivot) = (anchorMin, anchorMax, anchoredPosition, sizeDelta, pivot);

        internal override void CopyNativeState(Component source, Func<Object, Object> remap)
        {
            base.CopyNativeState(source, remap);
            if (source is RectTransform other)
                SetLayout(other.m_AnchorMin, other.m_AnchorMax, other.m_AnchoredPosition, other.m_SizeDelta, other.m_Pivot);
        }

        /// <summary>Puts the pivot where the layout wants it; below something without a rectangle it stands relative to that's origin.</summary>
        void Lay()
        {
            var parent = ParentOrNull is RectTransform p ? p.rect : new Rect(0f, 0f, 0f, 0f);
            var reference = m_AnchorMin + Vector2.Scale(m_AnchorMax - m_AnchorMin, m_Pivot);
            var corner = new Vector2(parent.x, parent.y) + Vector2.Scale(new Vector2(parent.width, parent.height), reference);
            localPosition = new Vector3(corner.x + m_AnchoredPosition.x, corner.y + m_AnchoredPosition.y, localPosition.z);
        }
    }
}
