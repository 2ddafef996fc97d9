using System;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace UnityEngine
{
    public sealed partial class Shader
    {
        public int GetPropertyCount() => File.Properties.Count;

        /// <summary>-1 if there is no such property.</summary>
        public int FindPropertyIndex(string propertyName)
        {
            if (propertyName == null)
                throw new ArgumentNullException(nameof(propertyName));
            return File.Properties.FindIndex(p => p.Name == propertyName);
        }

        public string GetPropertyName(int propertyIndex) => Property(propertyIndex).Name;

        public int GetPropertyNameId(int propertyIndex) => Property(propertyIndex).NameId;

        public string GetPropertyDescription(int propertyIndex) => Property(propertyIndex).Description;

        public ShaderPropertyType GetPropertyType(int propertyIndex) => Property(propertyIndex).Type;

        public ShaderPropertyFlags GetPropertyFlags(int propertyIndex) => Property(propertyIndex).Flags;

        public string[] GetPropertyAttributes(int propertyIndex) => Property(propertyIndex).Attributes.ToArray();

        public float GetPropertyDefaultFloatValue(int propertyIndex) =>
            Property(propertyIndex, ShaderPropertyType.Float, ShaderPropertyType.Range).Default.x;

        public int GetPropertyDefaultIntValue(int propertyIndex) => (int)Property(propertyIndex, ShaderPropertyType.Int).Default.x;

        public Vector4 GetPropertyDefaultVectorValue(int propertyIndex) =>
            Property(propertyIndex, ShaderPropertyType.Color, ShaderPropertyType.Vector).Default;

        public Vector2 GetPropertyRangeLimits(int propertyIndex) => Property(propertyIndex, ShaderPropertyType.Range).Range;

        public TextureDimension GetPropertyTextureDimension(int propertyIndex) => Property(propertyIndex, ShaderPropertyType.Texture).Dimension;

        public string GetPropertyTextureDefaultName(int propertyIndex) => Property(propertyIndex, ShaderPropertyType.Texture).DefaultTexture;

        internal ShaderLabProperty FindProperty(int nameId) => File.Properties.Find(p => p.NameId == nameId);

        ShaderLabProperty Property(int index, params ShaderPropertyType[] types)
        {
            if (index < 0 || index >= File.Properties.Count)
                throw new ArgumentOutOfRangeException(nameof(index), index, $"Shader '{File.Name}' has {File.Properties.Count} properties");
            var property = File.Properties[index];
            if (types.Length > 0 && Array.IndexOf(types, property.Type) < 0)
                throw new ArgumentException($"Property {property.Name} of shader '{File.Name}' is a {property.Type}");
            return property;
        }
    }
}
