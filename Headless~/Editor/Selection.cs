using System;
using System.Linq;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>What is selected.</summary>
    public sealed class Selection
    {
        public static Action selectionChanged;

        static Object[] s_Objects = Array.Empty<Object>();

        public Selection()
        {
        }

        public static Object[] objects
        {
            get => s_Objects.Where(Object.IsAlive).ToArray();
            set
            {
                s_Objects = (value ?? Array.Empty<Object>()).Where(Object.IsAlive).ToArray();
                LogRouter.Guard(() => selectionChanged?.Invoke());
            }
        }

        public static Object activeObject
        {
            get => objects.FirstOrDefault();
            set => objects = new[] { value };
        }

        public static GameObject activeGameObject
        {
            get => activeObject as GameObject;
            set => activeObject = value;
        }

        public static Transform activeTransform
        {
            get => activeGameObject is { IsAsset: false } g ? g.transform : null;
            set => activeObject = Object.IsAlive(value) ? value.gameObject : null;
        }

        public static GameObject[] gameObjects => objects.OfType<GameObject>().ToArray();

        public static Transform[] transforms => gameObjects.Where(g => !g.IsAsset).Select(g => g.transform).ToArray();

        public static int count => objects.Length;

        public static bool Contains(Object obj) => objects.Contains(obj);

        internal static void Forget()
        {
            s_Objects = Array.Empty<Object>();
            selectionChanged = null;
        }
    }
}
