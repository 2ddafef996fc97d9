using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>
    /// The one place that knows which of the engine's classes the host has, and how each is read from a file: class number -> type, reader. What is
    /// not here, but in the table of classes, is loaded as data only.
    /// </summary>
    static class NativeReaders
    {
        static readonly Dictionary<int, (Type Type, Action<Object, NativeFields> Read)> s_Readers = new()
        {
            [NativeClass.GameObject] = Entry<GameObject>(ReadGameObject),
            [NativeClass.Transform] = Entry<Transform>(ReadTransform),
            [NativeClass.RectTransform] = Entry<RectTransform>(ReadRectTransform),
            [20] = Entry<Camera>(ReadCamera),
            [NativeClass.Material] = Entry<Material>(MaterialReader.Read),
            [23] = Entry<MeshRenderer>(RendererReaders.ReadRenderer),
            [33] = Entry<MeshFilter>(RendererReaders.ReadMeshFilter),
            [108] = Entry<Light>(RendererReaders.ReadLight),
            [222] = Entry<CanvasRenderer>(CanvasReaders.ReadCanvasRenderer),
            [223] = Entry<Canvas>(CanvasReaders.ReadCanvas),
            [225] = Entry<CanvasGroup>(CanvasReaders.ReadCanvasGroup),
        };

        /// <summary>The type that stands for a class; null if the host has none.</summary>
        internal static Type TypeOf(int classId) => s_Readers.TryGetValue(classId, out var entry) ? entry.Type : null;

        internal static void Read(Object target, int classId, NativeFields fields) => s_Readers[classId].Read(target, fields);

        static (Type, Action<Object, NativeFields>) Entry<T>(Action<T, NativeFields> read) where T : Object => (typeof(T), (o, f) => read((T)o, f));

        static void ReadGameObject(GameObject g, NativeFields f)
        {
            g.layer = f.Get("m_Layer", 0);
            g.isStatic = f.Get("m_StaticEditorFlags", 0u) != 0;
            try
            {
                g.tag = f.Get("m_TagString", "Untagged");
            }
            catch (UnityException e)
            {
                throw f.Document.Error(f.Body, $"m_TagString: {e.Message}");
            }
        }

        static void ReadTransform(Transform t, NativeFields f) => t.SetLocalPose(
            f.Get("m_LocalPosition", t.localPosition), f.Get("m_LocalRotation", t.localRotation), f.Get("m_LocalScale", t.localScale));

        static void ReadRectTransform(RectTransform t, NativeFields f)
        {
            ReadTransform(t, f);
            t.SetLayout(f.Get("m_AnchorMin", t.anchorMin), f.Get("m_AnchorMax", t.anchorMax), f.Get("m_AnchoredPosition", t.anchoredPosition),
                f.Get("m_SizeDelta", t.sizeDelta), f.Get("m_Pivot", t.pivot));
        }

        static void ReadCamera(Camera c, NativeFields f)
        {
            c.clearFlags = f.Get("m_ClearFlags", c.clearFlags);
            c.backgroundColor = f.Get("m_BackGroundColor", c.backgroundColor);
            c.rect = f.Get("m_NormalizedViewPortRect", c.rect);
            c.nearClipPlane = f.Get("near clip plane", c.nearClipPlane);
            c.farClipPlane = f.Get("far clip plane", c.farClipPlane);
            c.fieldOfView = f.Get("field of view", c.fieldOfView);
            c.orthographic = f.Get("orthographic", c.orthographic);
            c.orthographicSize = f.Get("orthographic size", c.orthographicSize);
            c.depth = f.Get("m_Depth", c.depth);
            c.cullingMask = f.Get("m_CullingMask", (LayerMask)c.cullingMask);
            c.targetTexture = f.Get("m_TargetTexture", c.targetTexture);
            c.allowHDR = f.Get("m_HDR", c.allowHDR);
            c.allowMSAA = f.Get("m_AllowMSAA", c.allowMSAA);
            c.useOcclusionCulling = f.Get("m_OcclusionCulling", c.useOcclusionCulling);
            c.stereoTargetEye = f.Get("m_TargetEye", c.stereoTargetEye);
            c.stereoConvergence = f.Get("m_StereoConvergence", c.stereoConvergence);
            c.stereoSeparation = f.Get("m_StereoSeparation", c.stereoSeparation);
        }
    }
}
