namespace UnityEngine
{
    /// <summary>Which axes a movement is given in.</summary>
    public enum Space
    {
        World = 0,
        Self = 1,
    }

    public partial class Transform
    {
        /// <summary>From local to world space.</summary>
        public Vector3 TransformPoint(Vector3 position) => localToWorldMatrix.MultiplyPoint3x4(position);

        public Vector3 TransformPoint(float x, float y, float z) => TransformPoint(new Vector3(x, y, z));

        /// <summary>From world to local space.</summary>
        public Vector3 InverseTransformPoint(Vector3 position) => worldToLocalMatrix.MultiplyPoint3x4(position);

        public Vector3 InverseTransformPoint(float x, float y, float z) => InverseTransformPoint(new Vector3(x, y, z));

        /// <summary>Rotates only: the length stays.</summary>
        public Vector3 TransformDirection(Vector3 direction) => rotation * direction;

        public Vector3 TransformDirection(float x, float y, float z) => TransformDirection(new Vector3(x, y, z));

        public Vector3 InverseTransformDirection(Vector3 direction) => Quaternion.Inverse(rotation) * direction;

        public Vector3 InverseTransformDirection(float x, float y, float z) => InverseTransformDirection(new Vector3(x, y, z));

        /// <summary>Rotates and scales.</summary>
        public Vector3 TransformVector(Vector3 vector) => localToWorldMatrix.MultiplyVector(vector);

        public Vector3 TransformVector(float x, float y, float z) => TransformVector(new Vector3(x, y, z));

        public Vector3 InverseTransformVector(Vector3 vector) => worldToLocalMatrix.MultiplyVector(vector);

        public Vector3 InverseTransformVector(float x, float y, float z) => InverseTransformVector(new Vector3(x, y, z));

        public void Translate(Vector3 translation) => Translate(translation, Space.Self);

        public void Translate(Vector3 translation, Space relativeTo) =>
            position += relativeTo == Space.World ? translation : TransformDirection(translation);

        public void Translate(Vector3 translation, Transform relativeTo) =>
            position += relativeTo ? relativeTo.TransformDirection(translation) : translation;

        public void Translate(float x, float y, float z) => Translate(new Vector3(x, y, z), Space.Self);

        public void Translate(float x, float y, float z, Space relativeTo) => Translate(new Vector3(x, y, z), relativeTo);

        public void Rotate(Vector3 eulers) => Rotate(eulers, Space.Self);

        /// <summary>Turns by Euler angles in degrees.</summary>
        public void Rotate(Vector3 eulers, Space relativeTo)
        {
            var turn = Quaternion.Euler(eulers);
            if (relativeTo == Space.Self)
                localRotation *= turn;
            else
                rotation = turn * rotation;
        }

        public void Rotate(float xAngle, float yAngle, float zAngle) => Rotate(new Vector3(xAngle, yAngle, zAngle), Space.Self);

        public void Rotate(float xAngle, float yAngle, float zAngle, Space relativeTo) => Rotate(new Vector3(xAngle, yAngle, zAngle), relativeTo);

        public void Rotate(Vector3 axis, float angle) => Rotate(axis, angle, Space.Self);

        public void Rotate(Vector3 axis, float angle, Space relativeTo) =>
            rotation = Quaternion.AngleAxis(angle, relativeTo == Space.Self ? TransformDirection(axis) : axis) * rotation;

        public void RotateAround(Vector3 point, Vector3 axis, float angle)
        {
            var turn = Quaternion.AngleAxis(angle, axis);
            position = point + turn * (position - point);
            rotation = turn * rotation;
        }

        public void LookAt(Transform target) => LookAt(target, Vector3.up);

        public void LookAt(Transform target, Vector3 worldUp)
        {
            if (target)
                LookAt(target.position, worldUp);
        }

        public void LookAt(Vector3 worldPosition) => LookAt(worldPosition, Vector3.up);

        public void LookAt(Vector3 worldPosition, Vector3 worldUp)
        {
            var way = worldPosition - position;
            if (way != Vector3.zero)
                rotation = Quaternion.LookRotation(way, worldUp);
        }
    }
}
