using System;

namespace UnityEngine
{
    public partial class Transform
    {
        Vector3 m_LocalPosition;
        Quaternion m_LocalRotation = Quaternion.identity;
        Vector3 m_LocalScale = Vector3.one;

        public Vector3 localPosition
        {
            get { Use("get_localPosition"); return m_LocalPosition; }
            set { Use("set_localPosition"); m_LocalPosition = CheckedPosition(value); MarkChanged(); }
        }

        public Quaternion localRotation
        {
            get { Use("get_localRotation"); return m_LocalRotation; }
            set { Use("set_localRotation"); m_LocalRotation = value.normalized; MarkChanged(); }
        }

        public Vector3 localScale
        {
            get { Use("get_localScale"); return m_LocalScale; }
            set { Use("set_localScale"); m_LocalScale = value; MarkChanged(); }
        }

        /// <summary>Degrees.</summary>
        public Vector3 localEulerAngles
        {
            get => localRotation.eulerAngles;
            set => localRotation = Quaternion.Euler(value);
        }

        public Vector3 position
        {
            get { Use("get_position"); return WorldPosition(); }
            set => localPosition = m_Parent is null ? value : m_Parent.InverseTransformPoint(value);
        }

        public Quaternion rotation
        {
            get { Use("get_rotation"); return WorldRotation(); }
            set { Use("set_rotation"); localRotation = LocalRotationFor(value); }
        }

        /// <summary>Degrees.</summary>
        public Vector3 eulerAngles
        {
            get => rotation.eulerAngles;
            set => rotation = Quaternion.Euler(value);
        }

        public Vector3 right { get => rotation * Vector3.right; set => rotation = Quaternion.FromToRotation(Vector3.right, value); }

        public Vector3 up { get => rotation * Vector3.up; set => rotation = Quaternion.FromToRotation(Vector3.up, value); }

        public Vector3 forward { get => rotation * Vector3.forward; set => rotation = Quaternion.LookRotation(value); }

        /// <summary>The scale in world space, as far as one can be told (skew is left out).</summary>
        public Vector3 lossyScale
        {
            get
            {
                Use("get_lossyScale");
                var m = Matrix4x4.Rotate(Quaternion.Inverse(WorldRotation())) * LocalToWorld();
                return new Vector3(m.m00, m.m11, m.m22);
            }
        }

        public Matrix4x4 localToWorldMatrix
        {
            get { Use("get_localToWorldMatrix"); return LocalToWorld(); }
        }

        public Matrix4x4 worldToLocalMatrix
        {
            get { Use("get_worldToLocalMatrix"); return LocalToWorld().inverse; }
        }

        public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }

        public void SetLocalPositionAndRotation(Vector3 localPosition, Quaternion localRotation)
        {
            this.localPosition = localPosition;
            this.localRotation = localRotation;
        }

        public void GetPositionAndRotation(out Vector3 position, out Quaternion rotation)
        {
            position = this.position;
            rotation = this.rotation;
        }

        public void GetLocalPositionAndRotation(out Vector3 localPosition, out Quaternion localRotation)
        {
            localPosition = this.localPosition;
            localRotation = this.localRotation;
        }

        /// <summary>Sets the local pose as a file gives it.</summary>
        internal void SetLocalPose(Vector3 position, Quaternion rotation, Vector3 scale)
        {
            m_LocalPosition = position;
            m_LocalRotation = rotation.normalized;
            m_LocalScale = scale;
        }

        internal override void CopyNativeState(Component source, Func<Object, Object> remap)
        {
            var other = (Transform)source;
            m_LocalPosition = other.m_LocalPosition;
            m_LocalRotation = other.m_LocalRotation;
            m_LocalScale = other.m_LocalScale;
        }

        Matrix4x4 LocalToWorld()
        {
            var local = Matrix4x4.TRS(m_LocalPosition, m_LocalRotation, m_LocalScale);
            return m_Parent is null ? local : m_Parent.LocalToWorld() * local;
        }

        Vector3 WorldPosition() => m_Parent is null ? m_LocalPosition : m_Parent.LocalToWorld().MultiplyPoint3x4(m_LocalPosition);

        Quaternion WorldRotation()
        {
            var q = m_LocalRotation;
            for (var t = m_Parent; t is not null; t = t.m_Parent)
                q = t.m_LocalRotation * Mirrored(q, t.m_LocalScale);
            return q;
        }

        Quaternion LocalRotationFor(Quaternion world)
        {
            if (m_Parent is null)
                return world;
            return Mirrored(Quaternion.Inverse(m_Parent.m_LocalRotation) * m_Parent.LocalRotationFor(world), m_Parent.m_LocalScale);
        }

        /// <summary>The rotation seen through a mirroring scale; a scale without negative signs changes nothing.</summary>
        static Quaternion Mirrored(Quaternion q, Vector3 scale)
        {
            float x = Mathf.Sign(scale.x), y = Mathf.Sign(scale.y), z = Mathf.Sign(scale.z);
            return new Quaternion(q.x * y * z, q.y * x * z, q.z * x * y, q.w);
        }

        (Vector3 Position, Quaternion Rotation, Matrix4x4 Matrix) WorldPose() => (WorldPosition(), WorldRotation(), LocalToWorld());

        void SetWorldPose((Vector3 Position, Quaternion Rotation, Matrix4x4 Matrix) world)
        {
            m_LocalPosition = m_Parent is null ? world.Position : m_Parent.LocalToWorld().inverse.MultiplyPoint3x4(world.Position);
            m_LocalRotation = LocalRotationFor(world.Rotation).normalized;
            m_LocalScale = Vector3.one;
            var scale = LocalToWorld().inverse * world.Matrix;
            m_LocalScale = new Vector3(scale.m00, scale.m11, scale.m22);
        }

        void MarkChanged()
        {
            hasChanged = true;
            foreach (var child in m_Children)
                child.MarkChanged();
        }

        Vector3 CheckedPosition(Vector3 value)
        {
            if (float.IsNaN(value.x + value.y + value.z) || float.IsInfinity(value.x) || float.IsInfinity(value.y) || float.IsInfinity(value.z))
            {
                Debug.LogError($"transform.position assign attempt for '{NameForMessages}' is not valid. Input position is "
                    + $"{{ {value.x}, {value.y}, {value.z} }}.");
                return m_LocalPosition;
            }

            return value;
        }
    }
}
