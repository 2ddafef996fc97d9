using System;

namespace UnityEngine
{
    /// <summary>Serialises a non-public field.</summary>
    public sealed class SerializeField : Attribute
    {
    }

    /// <summary>Serialises by reference instead of by value.</summary>
    [AttributeUsage(AttributeTargets.Field)]
    public sealed class SerializeReference : Attribute
    {
    }

    /// <summary>Keeps a field out of the Inspector; it is serialised all the same.</summary>
    public sealed class HideInInspector : Attribute
    {
    }

    /// <summary>Asks for binary asset files.</summary>
    [AttributeUsage(AttributeTargets.Class)]
    public sealed class PreferBinarySerialization : Attribute
    {
    }

    /// <summary>Called before an object is written and after it was read, at times off the main thread.</summary>
    public interface ISerializationCallbackReceiver
    {
        void OnBeforeSerialize();

        void OnAfterDeserialize();
    }
}

namespace UnityEngine.Serialization
{
    /// <summary>A former name of a field, which older files still carry.</summary>
    [AttributeUsage(AttributeTargets.Field, AllowMultiple = true, Inherited = false)]
    public class FormerlySerializedAsAttribute : Attribute
    {
        public FormerlySerializedAsAttribute(string oldName) => this.oldName = oldName;

        public string oldName { get; }
    }
}
