using System;

namespace UnityEngine
{
    /// <summary>AddComponent adds these components first.</summary>
    [AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
    public sealed class RequireComponent : Attribute
    {
        public Type m_Type0;
        public Type m_Type1;
        public Type m_Type2;

        public RequireComponent(Type requiredComponent) => m_Type0 = requiredComponent;

        public RequireComponent(Type requiredComponent, Type requiredComponent2) : this(requiredComponent) => m_Type1 = requiredComponent2;

        public RequireComponent(Type requiredComponent, Type requiredComponent2, Type requiredComponent3) : this(requiredComponent, requiredComponent2) =>
            m_Type2 = requiredComponent3;
    }

    /// <summary>A GameObject takes one such component only.</summary>
    [AttributeUsage(AttributeTargets.Class, Inherited = false)]
    public sealed class DisallowMultipleComponent : Attribute
    {
    }

    /// <summary>Messages of classes with a lower order come first; the default is 0.</summary>
    [AttributeUsage(AttributeTargets.Class)]
    public class DefaultExecutionOrder : Attribute
    {
        public DefaultExecutionOrder(int order) => this.order = order;

        public int order { get; }
    }

    /// <summary>Runs in edit mode too.</summary>
    public sealed class ExecuteAlways : Attribute
    {
    }

    /// <summary>Runs in edit mode too, though not in prefab mode.</summary>
    public sealed class ExecuteInEditMode : Attribute
    {
    }

    /// <summary>Position of a callback in <see cref="Application.onBeforeRender"/>.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class BeforeRenderOrderAttribute : Attribute
    {
        public BeforeRenderOrderAttribute(int order) => this.order = order;

        public int order { get; }
    }
}
