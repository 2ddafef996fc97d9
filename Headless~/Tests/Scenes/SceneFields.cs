using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Events;
using UnityEngine.Serialization;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    [Serializable]
    public sealed class Nested
    {
        public int kept = 5;
        public int set;
        public Vector3 vector = new(1f, 2f, 3f);
    }

    [Serializable]
    public sealed class NumberEvent : UnityEvent<float>
    {
    }

    /// <summary>A component with fields of every kind that scenes set.</summary>
    public sealed class SceneFields : MonoBehaviour
    {
        public int number = 3;
        public int untouched = 42;
        public string text;
        public float[] list;
        public List<Nested> items;
        public Nested nested = new() { kept = 9 };
        public Transform place;
        public GameObject thing;
        public Object anything;
        public SceneFields other;
        public ScriptableObject asset;
        public UnityEvent happened;
        public NumberEvent changed;

        [SerializeField, FormerlySerializedAs("oldHidden")]
        int hidden = 1;

        internal int Hidden => hidden;

        internal List<string> Calls { get; } = new();

        public void Note() => Calls.Add("Note");

        public void NoteText(string value) => Calls.Add(value);

        public void NoteNumber(float value) => Calls.Add(value.ToString(System.Globalization.CultureInfo.InvariantCulture));
    }

    /// <summary>A component that cannot be without another.</summary>
    [RequireComponent(typeof(SceneFields))]
    public sealed class Needy : MonoBehaviour
    {
    }
}
