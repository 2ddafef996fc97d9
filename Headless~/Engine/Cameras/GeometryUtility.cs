using System;

namespace UnityEngine
{
    /// <summary>Tests of shapes against a camera's frustum.</summary>
    public sealed class GeometryUtility
    {
        public static Plane[] CalculateFrustumPlanes(Camera camera) => CalculateFrustumPlanes(camera.projectionMatrix * camera.worldToCameraMatrix);

        /// <summary>Left, right, bottom, top, near, far; their normals point inwards.</summary>
        public static Plane[] CalculateFrustumPlanes(Matrix4x4 worldToProjectionMatrix)
        {
            var planes = new Plane[6];
            CalculateFrustumPlanes(worldToProjectionMatrix, planes);
            return planes;
        }

        public static void CalculateFrustumPlanes(Camera camera, Plane[] planes) =>
            CalculateFrustumPlanes(camera.projectionMatrix * camera.worldToCameraMatrix, planes);

        /// <exception cref="ArgumentException">There are not six planes.</exception>
        public static void CalculateFrustumPlanes(Matrix4x4 worldToProjectionMatrix, Plane[] planes)
        {
            if (planes == null)
                throw new ArgumentNullException(nameof(planes));
            if (planes.Length != 6)
                throw new ArgumentException("Planes array must be of length 6.", nameof(planes));
            var w = worldToProjectionMatrix.GetRow(3);
            for (var i = 0; i < 6; i++)
            {
                // Inside is -w <= x,y,z <= w.
                var row = worldToProjectionMatrix.GetRow(i / 2);
                var p = i % 2 == 0 ? w + row : w - row;
                var length = ((Vector3)p).magnitude;
                planes[i] = new Plane((Vector3)p / length, p.w / length);
            }
        }

        /// <summary>False only if the box lies wholly outside one of the planes.</summary>
        public static bool TestPlanesAABB(Plane[] planes, Bounds bounds)
        {
            if (planes == null)
                throw new ArgumentNullException(nameof(planes));
            foreach (var plane in planes)
            {
                var n = plane.normal;
                var reach = Vector3.Dot(bounds.extents, new Vector3(Mathf.Abs(n.x), Mathf.Abs(n.y), Mathf.Abs(n.z)));
                if (plane.GetDistanceToPoint(bounds.center) < -reach)
                    return false;
            }

            return true;
        }
    }
}
