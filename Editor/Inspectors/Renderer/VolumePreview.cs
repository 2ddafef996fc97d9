using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// The volume in the preview below the Inspector: what the component itself renders, turned by dragging. It is rendered when something has changed, and
    /// read back so that it is drawn like any other image, whatever the project's colour space.
    /// </summary>
    sealed class VolumePreview : IDisposable
    {
        /// <summary>Pixels of the longer side: reading back and converting more would make dragging sluggish.</summary>
        const int Largest = 512;

        static readonly int Hint = "AnatomyCarve.VolumePreview".GetHashCode();

        readonly PreviewOrbit orbit = new PreviewOrbit();
        readonly PreviewMarks marks = new PreviewMarks();
        CarvedPicture picture;
        Texture2D image;
        int imageVersion;

        public void Reset() => orbit.Reset();

        public void Draw(Rect rect, CarvedVolumeRenderer renderer)
        {
            int id = GUIUtility.GetControlID(Hint, FocusType.Passive, rect);
            Event e = Event.current;
            bool over = rect.Contains(e.mousePosition);
            switch (e.GetTypeForControl(id))
            {
                case EventType.Repaint:
                    Paint(rect, renderer);
                    break;
                case EventType.MouseDown when over && e.button == 0:
                    GUIUtility.hotControl = id;
                    e.Use();
                    break;
                case EventType.MouseDrag when GUIUtility.hotControl == id:
                    orbit.Drag(e.delta, Mathf.Min(rect.width, rect.height));
                    e.Use();
                    break;
                case EventType.MouseUp when GUIUtility.hotControl == id:
                    GUIUtility.hotControl = 0;
                    e.Use();
                    break;
                case EventType.ScrollWheel when over:
                    orbit.Scroll(e.delta.x + e.delta.y);
                    e.Use();
                    break;
            }
        }

        public void Dispose()
        {
            picture?.Dispose();
            picture = null;
            if (image != null)
                Object.DestroyImmediate(image);
            image = null;
        }

        void Paint(Rect rect, CarvedVolumeRenderer renderer)
        {
            if (renderer.Volume == null || rect.width < 2f || rect.height < 2f)
                return;
            float scale = Mathf.Min(EditorGUIUtility.pixelsPerPoint, Largest / Mathf.Max(rect.width, rect.height));
            PictureRays rays = orbit.Rays(renderer.Volume.Geometry, Mathf.Max(1, (int)(rect.width * scale)), Mathf.Max(1, (int)(rect.height * scale)));
            picture ??= new CarvedPicture("AnatomyCarve Inspector preview");
            string problem = renderer.Render(rays, picture) == null ? renderer.Problem ?? "The component is disabled." : TakeImage();
            EditorGUI.DrawRect(rect, TransferFunctionPainter.Background);
            if (problem != null)
            {
                EditorGUI.DropShadowLabel(rect, problem);
                return;
            }
            GUI.DrawTexture(rect, image, ScaleMode.StretchToFill, false);
            marks.Paint(rect, orbit, rays);
        }

        /// <summary>Reads the picture, unless it is the one that was read last.</summary>
        /// <returns>Why it cannot be read; null = it was.</returns>
        string TakeImage()
        {
            if (image != null && image.width == picture.Width && image.height == picture.Height && imageVersion == picture.Version)
                return null;
            byte[] pixels;
            try
            {
                pixels = picture.Read().ToSrgb(TransferFunctionPainter.Background);
            }
            catch (AnatomyCarveException e)
            {
                return e.Message;
            }
            if (image == null || image.width != picture.Width || image.height != picture.Height)
            {
                if (image != null)
                    Object.DestroyImmediate(image);
                image = new Texture2D(picture.Width, picture.Height, TextureFormat.RGBA32, false)
                {
                    name = "AnatomyCarve Inspector preview", hideFlags = HideFlags.HideAndDontSave, wrapMode = TextureWrapMode.Clamp,
                };
            }
            image.LoadRawTextureData(pixels);
            image.Apply(false);
            imageVersion = picture.Version;
            return null;
        }
    }
}
