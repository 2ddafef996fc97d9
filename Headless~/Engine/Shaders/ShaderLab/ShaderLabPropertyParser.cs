using System.Collections.Generic;
using System.Linq;
using System.Text;
using UnityEngine.Rendering;

namespace UnityEngine.Shaders
{
    /// <summary>Reads one line of a Properties block: [Attribute] _Name ("Description", Type) = default.</summary>
    static class ShaderLabPropertyParser
    {
        internal static ShaderLabProperty Parse(ShaderLabLexer lexer, List<ShaderLabProperty> others)
        {
            var property = new ShaderLabProperty();
            while (lexer.TryTake("["))
                property.Attributes.Add(Attribute(lexer));
            property.Line = lexer.Peek().Line;
            property.Name = lexer.Word("a property's name");
            property.NameId = Shader.PropertyToID(property.Name);
            if (others.Any(o => o.Name == property.Name))
                throw lexer.Error(property.Line, $"property {property.Name} is declared twice");
            lexer.Expect("(");
            property.Description = lexer.Text("a description");
            lexer.Expect(",");
            Type(lexer, property);
            lexer.Expect(")");
            lexer.Expect("=");
            Default(lexer, property);
            return property;
        }

        // [Enum(UnityEngine.Rendering.CullMode)] and the like are taken as they are: only the Inspector understands them.
        static string Attribute(ShaderLabLexer lexer)
        {
            var text = new StringBuilder();
            while (!lexer.TryTake("]"))
            {
                var token = lexer.Take();
                if (token.Kind == ShaderLabTokenKind.End)
                    throw lexer.Error(token.Line, "an attribute has no ']'");
                text.Append(token.Kind == ShaderLabTokenKind.Text ? "\"" + token.Text + "\"" : token.Text);
            }
            return text.ToString();
        }

        static void Type(ShaderLabLexer lexer, ShaderLabProperty property)
        {
            var token = lexer.Peek();
            var word = lexer.Word("a type");
            property.Type = ShaderPropertyType.Texture;
            switch (word.ToLowerInvariant())
            {
                case "color": property.Type = ShaderPropertyType.Color; break;
                case "vector": property.Type = ShaderPropertyType.Vector; break;
                // Int is a float by another name; Integer is the real one.
                case "float" or "int": property.Type = ShaderPropertyType.Float; break;
                case "integer": property.Type = ShaderPropertyType.Int; break;
                case "range": Range(lexer, property); break;
                case "2d": property.Dimension = TextureDimension.Tex2D; break;
                case "3d": property.Dimension = TextureDimension.Tex3D; break;
                case "cube": property.Dimension = TextureDimension.Cube; break;
                case "2darray": property.Dimension = TextureDimension.Tex2DArray; break;
                case "cubearray": property.Dimension = TextureDimension.CubeArray; break;
                default: throw lexer.Error(token.Line, $"property {property.Name} has an unknown type '{word}'");
            }
        }

        static void Range(ShaderLabLexer lexer, ShaderLabProperty property)
        {
            property.Type = ShaderPropertyType.Range;
            lexer.Expect("(");
            var min = lexer.Number("the lowest value");
            lexer.Expect(",");
            property.Range = new Vector2(min, lexer.Number("the highest value"));
            lexer.Expect(")");
        }

        static void Default(ShaderLabLexer lexer, ShaderLabProperty property)
        {
            switch (property.Type)
            {
                case ShaderPropertyType.Texture:
                    property.DefaultTexture = lexer.Text("a texture's name such as \"white\"");
                    if (lexer.TryTake("{"))
                        lexer.Expect("}");
                    break;
                case ShaderPropertyType.Color or ShaderPropertyType.Vector:
                    property.Default = Vector(lexer, property.Type == ShaderPropertyType.Color ? 1f : 0f);
                    break;
                default:
                    property.Default = new Vector4(lexer.Number("a number"), 0f, 0f, 0f);
                    break;
            }
        }

        static Vector4 Vector(ShaderLabLexer lexer, float w)
        {
            lexer.Expect("(");
            var vector = new Vector4(0f, 0f, 0f, w);
            for (var i = 0; i < 4; i++)
            {
                vector[i] = lexer.Number("a number");
                if (!lexer.TryTake(","))
                    break;
            }
            lexer.Expect(")");
            return vector;
        }
    }
}
