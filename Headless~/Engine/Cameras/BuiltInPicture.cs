namespace UnityEngine
{
    /// <summary>A picture as the Built-in pipeline draws it.</summary>
    static class BuiltInPicture
    {
        internal static void Draw(CameraPicture picture, VisibleMeshes visible)
        {
            if (visible.IsEmpty && EmptyPictures.TrySkip(picture))
                return;
            var restore = DrawTargets.Remember();
            var depth = (picture.Camera.depthTextureMode & DepthTextureMode.Depth) != 0 ? CameraDepth.Draw(picture, visible, PassRules.ShadowCasters) : null;
            CameraDepth.Publish(depth);
            picture.Begin();
            picture.Clear();
            CameraPicture.Draw(visible.Opaque, PassRules.BuiltIn);
            CameraPicture.Draw(visible.Transparent, PassRules.BuiltIn);
            CameraPicture.End();
            restore();
            CameraDepth.Release(depth);
        }
    }
}
