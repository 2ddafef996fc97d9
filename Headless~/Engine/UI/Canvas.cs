namespace UnityEngine
{
    /// <summary>Where a canvas is drawn.</summary>
    public enum RenderMode
    {
        ScreenSpaceOverlay = 0,
        ScreenSpaceCamera = 1,
        WorldSpace = 2,
    }

    /// <summary>The area that user interface lies in. The host keeps its settings and draws none.</summary>
    public sealed class Canvas : Behaviour
    {
        public RenderMode renderMode { get; set; } = RenderMode.WorldSpace;

        public Camera worldCamera { get; set; }

        public float planeDistance { get; set; } = 100f;

        public bool pixelPerfect { get; set; }

        public bool overrideSorting { get; set; }

        public int sortingOrder { get; set; }

        public int targetDisplay { get; set; }

        public float scaleFactor { get; set; } = 1f;

        public float referencePixelsPerUnit { get; set; } = 100f;

        /// <summary>Whether no canvas lies above it.</summary>
        public bool isRootCanvas => rootCanvas == this;

        /// <summary>The topmost canvas above it, or itself.</summary>
        public Canvas rootCanvas
        {
            get
            {
                Use("get_rootCanvas");
                var root = this;
                for (var t = transform; t != null; t = t.parent)
                    if (t.TryGetComponent(out Canvas above))
                        root = above;
                return root;
            }
        }

        internal override void CopyNativeState(Component source, System.Func<Object, Object> remap)
        {
            var other = (Canvas)source;
            renderMode = other.renderMode;
            worldCamera = other.worldCamera is null ? null : (Camera)remap(other.worldCamera);
            planeDistance = other.planeDistance;
            pixelPerfect = other.pixelPerfect;
            overrideSorting = other.overrideSorting;
            sortingOrder = other.sortingOrder;
            targetDisplay = other.targetDisplay;
            scaleFactor = other.scaleFactor;
            referencePixelsPerUnit = other.referencePixelsPerUnit;
        }
    }

    /// <summary>What a group of user interface has in common.</summary>
    public sealed class CanvasGroup : Behaviour
    {
        public float alpha { get; set; } = 1f;

        public bool interactable { get; set; } = true;

        public bool blocksRaycasts { get; set; } = true;

        public bool ignoreParentGroups { get; set; }

        internal override void CopyNativeState(Component source, System.Func<Object, Object> remap)
        {
            var other = (CanvasGroup)source;
            alpha = other.alpha;
            interactable = other.interactable;
            blocksRaycasts = other.blocksRaycasts;
            ignoreParentGroups = other.ignoreParentGroups;
        }
    }

    /// <summary>What draws a piece of user interface. The host draws none.</summary>
    public sealed class CanvasRenderer : Component
    {
        public bool cullTransparentMesh { get; set; } = true;

        public bool cull { get; set; }

        internal override void CopyNativeState(Component source, System.Func<Object, Object> remap)
        {
            var other = (CanvasRenderer)source;
            cullTransparentMesh = other.cullTransparentMesh;
            cull = other.cull;
        }
    }
}
