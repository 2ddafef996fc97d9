namespace UnityEngine
{
    /// <summary>
    /// Pictures of nothing on the screen or in the headset. While there is no device, they are not worth one: their colour is kept for who looks at them
    /// later.
    /// </summary>
    static class EmptyPictures
    {
        static Color? s_Screen;
        static Color? s_Eyes;

        /// <summary>Whether the picture can be left out.</summary>
        internal static bool TrySkip(CameraPicture picture)
        {
            if (Gpu.IsStarted || picture.Camera.targetTexture != null || picture.Camera.rect != new Rect(0, 0, 1, 1))
                return false;
            if (!CameraPicture.ClearsColor(picture.Camera))
                return true;
            var color = ColorSpaces.ToShader(picture.Camera.backgroundColor);
            if (picture.Eye == Camera.MonoOrStereoscopicEye.Mono)
                s_Screen = color;
            else
                s_Eyes = color;
            return true;
        }

        /// <summary>Gives a new screen the colour that it was cleared to before it was made.</summary>
        internal static void ClearScreen()
        {
            Clear(s_Screen, null);
            s_Screen = null;
        }

        /// <summary>The same for the pictures in the headset.</summary>
        internal static void ClearEyes(RenderTexture eyes)
        {
            Clear(s_Eyes, eyes);
            s_Eyes = null;
        }

        internal static void Forget() => s_Screen = s_Eyes = null;

        static void Clear(Color? color, RenderTexture target)
        {
            if (color is not { } value)
                return;
            var restore = DrawTargets.Remember();
            DrawTargets.Set(target, 0, target is null ? 0 : DrawTargets.AllSlices);
            DrawTargets.Clear(true, true, true, value, 1f, 0);
            restore();
        }
    }
}
