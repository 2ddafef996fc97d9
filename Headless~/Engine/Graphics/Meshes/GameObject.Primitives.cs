using System;

namespace UnityEngine
{
    /// <summary>Shapes that GameObject.CreatePrimitive makes.</summary>
    public enum PrimitiveType
    {
        Sphere = 0,
        Capsule = 1,
        Cylinder = 2,
        Cube = 3,
        Plane = 4,
        Quad = 5,
    }

    public sealed partial class GameObject
    {
        /// <summary>An object with a mesh and the pipeline's default material. It has no collider: this host has no physics.</summary>
        public static GameObject CreatePrimitive(PrimitiveType type)
        {
            var mesh = type switch
            {
                PrimitiveType.Sphere => BuiltinAssets.Sphere,
                PrimitiveType.Capsule => BuiltinAssets.Capsule,
                PrimitiveType.Cylinder => BuiltinAssets.Cylinder,
                PrimitiveType.Cube => BuiltinAssets.Cube,
                PrimitiveType.Plane => BuiltinAssets.Plane,
                PrimitiveType.Quad => BuiltinAssets.Quad,
                _ => throw new ArgumentOutOfRangeException(nameof(type), type, "no primitive"),
            };
            var made = new GameObject(type.ToString());
            made.AddComponent<MeshFilter>().sharedMesh = BuiltinAssets.Mesh(mesh);
            var pipeline = RenderPipelines.Asset;
            var material = pipeline != null ? pipeline.defaultMaterial : null;
            made.AddComponent<MeshRenderer>().sharedMaterial = material != null ? material : BuiltinAssets.Material(BuiltinAssets.DefaultMaterial);
            return made;
        }
    }
}
