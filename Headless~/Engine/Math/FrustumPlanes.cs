using System;

namespace UnityEngine
{
    /// <summary>The six planes of a projection by their distances.</summary>
    [Serializable]
    public struct FrustumPlanes
    {
        public float left;
        public float right;
        public float bottom;
        public float top;
        public float zNear;
        public float zFar;
    }
}
