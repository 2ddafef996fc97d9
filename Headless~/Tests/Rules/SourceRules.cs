using System;
using System.Collections.Generic;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace AnatomyCarve.Headless.Tests.Rules
{
    /// <summary>What the package's run-time sources may not do, because it breaks in players, on devices, or without domain reload.</summary>
    static class SourceRules
    {
        /// <summary>Type, member (null = all of them), reason.</summary>
        static readonly (string Type, string Member, string Reason)[] Forbidden =
        [
            ("UnityEngine.Shader", "Find", "a player holds only shaders that something refers to"),
            ("UnityEngine.Camera", "main", "it looks for a tag; cameras are passed in"),
            ("UnityEngine.GameObject", "Find", "objects are passed in"),
            ("UnityEngine.GameObject", "FindWithTag", "objects are passed in"),
            ("UnityEngine.GameObject", "FindGameObjectWithTag", "objects are passed in"),
            ("UnityEngine.Object", "FindObjectOfType", "objects are passed in"),
            ("UnityEngine.Object", "FindFirstObjectByType", "objects are passed in"),
            ("UnityEngine.Object", "FindAnyObjectByType", "objects are passed in"),
            ("System.Linq.Expressions.Expression", "Compile", "IL2CPP interprets it"),
            ("System.Linq.Expressions.LambdaExpression", "Compile", "IL2CPP interprets it"),
            ("System.Linq.Expressions.Expression<TDelegate>", "Compile", "IL2CPP interprets it"),
            ("System.Activator", "CreateInstance", "stripping removes what only reflection names"),
        ];

        static readonly string[] FileTypes = ["System.IO.File", "System.IO.FileStream", "System.IO.FileInfo", "System.IO.Directory", "System.IO.DirectoryInfo", "System.IO.StreamReader"];

        /// <summary>One line for each breach: file(line): what and why.</summary>
        public static IEnumerable<string> Breaches(CSharpCompilation compilation)
        {
            foreach (SyntaxTree tree in compilation.SyntaxTrees)
            {
                SemanticModel model = compilation.GetSemanticModel(tree);
                SyntaxNode root = tree.GetRoot();
                bool namesStreamingAssets = root.DescendantNodes().OfType<IdentifierNameSyntax>().Any(n => n.Identifier.Text == "streamingAssetsPath");
                foreach (SyntaxNode node in root.DescendantNodes(descendIntoTrivia: true))
                    foreach (string breach in Of(node, model, namesStreamingAssets))
                        yield return $"{tree.FilePath}({node.GetLocation().GetLineSpan().StartLinePosition.Line + 1}): {breach}";
            }
        }

        static IEnumerable<string> Of(SyntaxNode node, SemanticModel model, bool namesStreamingAssets)
        {
            switch (node)
            {
                case IfDirectiveTriviaSyntax directive when directive.Condition.ToString().Contains("UNITY_EDITOR"):
                    yield return "UNITY_EDITOR: the Editor's code lives in Editor/";
                    break;
                case IdentifierNameSyntax { Identifier.Text: "UnityEditor" or "UnityEditorInternal" }:
                    yield return "UnityEditor outside Editor/";
                    break;
                case IdentifierNameSyntax { Identifier.Text: "dynamic" } name when model.GetTypeInfo(name).Type?.TypeKind == TypeKind.Dynamic:
                    yield return "dynamic: IL2CPP cannot run it";
                    break;
                case SimpleNameSyntax name:
                    foreach (string breach in OfSymbol(model.GetSymbolInfo(name).Symbol, namesStreamingAssets))
                        yield return breach;
                    break;
                case FieldDeclarationSyntax field when IsMutableStatic(field.Modifiers):
                    yield return $"the static field '{field.Declaration.Variables[0].Identifier}' keeps its value when Play is entered without domain reload";
                    break;
                case EventFieldDeclarationSyntax { Modifiers: var modifiers } when modifiers.Any(SyntaxKind.StaticKeyword):
                    yield return "a static event keeps its listeners when Play is entered without domain reload";
                    break;
                case PropertyDeclarationSyntax property when property.Modifiers.Any(SyntaxKind.StaticKeyword)
                    && property.AccessorList?.Accessors.Any(a => a.IsKind(SyntaxKind.SetAccessorDeclaration) && a.Body == null && a.ExpressionBody == null) == true:
                    yield return $"the static property '{property.Identifier}' keeps its value when Play is entered without domain reload";
                    break;
            }
        }

        static IEnumerable<string> OfSymbol(ISymbol symbol, bool namesStreamingAssets)
        {
            if (symbol == null)
                yield break;
            string space = symbol.ContainingNamespace?.ToDisplayString() ?? "";
            string type = (symbol as INamedTypeSymbol ?? symbol.ContainingType)?.OriginalDefinition.ToDisplayString() ?? "";
            if (space == "System.Reflection.Emit" && symbol is INamedTypeSymbol)
                yield return $"{type}: IL2CPP cannot emit code";
            if (namesStreamingAssets && FileTypes.Contains(type) && symbol is INamedTypeSymbol)
                yield return $"{type} where StreamingAssets is named: on Android it lies inside the application's package";
            foreach ((string forbiddenType, string member, string reason) in Forbidden)
                if (type == forbiddenType && symbol is not INamedTypeSymbol && (member == null || symbol.Name == member))
                    yield return $"{type}.{symbol.Name}: {reason}";
        }

        static bool IsMutableStatic(SyntaxTokenList modifiers) =>
            modifiers.Any(SyntaxKind.StaticKeyword) && !modifiers.Any(SyntaxKind.ReadOnlyKeyword) && !modifiers.Any(SyntaxKind.ConstKeyword);
    }
}
