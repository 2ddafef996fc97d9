namespace UnityEngine
{
    /// <summary>Reads the engine's part of user interfaces.</summary>
    static class CanvasReaders
    {
        internal static void ReadCanvas(Canvas c, NativeFields f)
        {
            c.renderMode = f.Get("m_RenderMode", c.renderMode);
            c.worldCamera = f.Get("m_Camera", c.worldCamera);
            c.planeDistance = f.Get("m_PlaneDistance", c.planeDistance);
            c.pixelPerfect = f.Get("m_PixelPerfect", c.pixelPerfect);
            c.overrideSorting = f.Get("m_OverrideSorting", c.overrideSorting);
            c.sortingOrder = f.Get("m_SortingOrder", c.sortingOrder);
            c.targetDisplay = f.Get("m_TargetDisplay", c.targetDisplay);
        }

        internal static void ReadCanvasGroup(CanvasGroup g, NativeFields f)
        {
            g.alpha = f.Get("m_Alpha", g.alpha);
            g.interactable = f.Get("m_Interactable", g.interactable);
            g.blocksRaycasts = f.Get("m_BlocksRaycasts", g.blocksRaycasts);
            g.ignoreParentGroups = f.Get("m_IgnoreParentGroups", g.ignoreParentGroups);
        }

        internal static void ReadCanvasRenderer(CanvasRenderer r, NativeFields f) =>
            r.cullTransparentMesh = f.Get("m_CullTransparentMesh", r.cullTransparentMesh);
    }
}
