using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>What makes a picture readable: the patient's directions at its edges, and a scale in millimetres.</summary>
    sealed class PreviewMarks
    {
        const float LetterHeight = 18f, LetterWidth = 40f, Inset = 4f, BarInset = 24f, BarHeight = 3f, LongestBar = 0.3f;

        GUIStyle letter;
        OrbitCamera named;
        string right, left, up, down;
        PictureRays scaled;
        float scaledWidth;
        ScaleBar bar;

        public void Paint(Rect rect, PreviewOrbit orbit, PictureRays rays)
        {
            letter ??= new GUIStyle(EditorStyles.whiteBoldLabel) { alignment = TextAnchor.MiddleCenter };
            Name(orbit);
            Vector2 c = rect.center;
            GUI.Label(Around(rect.xMax - 0.5f * LetterWidth - Inset, c.y), right, letter);
            GUI.Label(Around(rect.x + 0.5f * LetterWidth + Inset, c.y), left, letter);
            GUI.Label(Around(c.x, rect.y + 0.5f * LetterHeight + Inset), up, letter);
            GUI.Label(Around(c.x, rect.yMax - 0.5f * LetterHeight - Inset), down, letter);
            PaintBar(rect, rays);
        }

        void PaintBar(Rect rect, PictureRays rays)
        {
            if (rays != scaled || rect.width != scaledWidth)
            {
                scaled = rays;
                scaledWidth = rect.width;
                bar = new ScaleBar(PreviewOrbit.MmPerPixel(rays) * rays.Width / rect.width, rect.width * LongestBar);
            }
            var line = new Rect(rect.x + 2f * Inset, rect.yMax - BarInset, bar.Pixels, BarHeight);
            EditorGUI.DrawRect(line, Color.white);
            GUI.Label(new Rect(line.x, line.yMax, rect.width, LetterHeight), bar.Text, EditorStyles.whiteMiniLabel);
        }

        void Name(PreviewOrbit orbit)
        {
            if (orbit.Camera == named)
                return;
            named = orbit.Camera;
            VectorMm rightLps = orbit.RightLps, upLps = named.UpLps;
            right = OrientationLetters.Of(rightLps);
            left = OrientationLetters.Of(-rightLps);
            up = OrientationLetters.Of(upLps);
            down = OrientationLetters.Of(-upLps);
        }

        static Rect Around(float x, float y) => new Rect(x - 0.5f * LetterWidth, y - 0.5f * LetterHeight, LetterWidth, LetterHeight);
    }
}
