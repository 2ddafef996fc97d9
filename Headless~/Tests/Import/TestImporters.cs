using System;
using System.Collections.Generic;
using System.IO;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Import
{
    /// <summary>What <see cref="WordsImporter"/> makes of a text.</summary>
    public sealed class Words : ScriptableObject
    {
        public string[] words;
        public TextAsset text;
    }

    /// <summary>Imports .words files: the words, and the words of a file "NAME.more" beside it.</summary>
    [ScriptedImporter(1, "words", 10)]
    public sealed class WordsImporter : ScriptedImporter
    {
        [SerializeField]
        string separator = " ";

        [SerializeField]
        bool fails = false;

        internal static int Imports { get; set; }

        internal string Separator { get => separator; set => separator = value; }

        public override void OnImportAsset(AssetImportContext ctx)
        {
            Imports++;
            var content = File.ReadAllText(FileUtil.GetPhysicalPath(ctx.assetPath));
            var more = Path.ChangeExtension(ctx.assetPath, ".more");
            ctx.DependsOnSourceAsset(more);
            if (File.Exists(FileUtil.GetPhysicalPath(more)))
                content += separator + File.ReadAllText(FileUtil.GetPhysicalPath(more));
            else
                ctx.LogImportWarning("there is no more");
            var words = ScriptableObject.CreateInstance<Words>();
            words.words = content.Split(separator);
            words.text = new TextAsset(content) { name = "text" };
            ctx.AddObjectToAsset("words", words);
            ctx.AddObjectToAsset("text", words.text);
            ctx.SetMainObject(words);
            if (fails)
                throw new InvalidOperationException("the importer fails");
        }
    }

    /// <summary>An importer that can be chosen for .words files.</summary>
    [ScriptedImporter(1, new[] { "letters" }, new[] { "words" })]
    public sealed class LettersImporter : ScriptedImporter
    {
        public override void OnImportAsset(AssetImportContext ctx)
        {
            var words = ScriptableObject.CreateInstance<Words>();
            words.words = Array.ConvertAll(File.ReadAllText(FileUtil.GetPhysicalPath(ctx.assetPath)).ToCharArray(), c => c.ToString());
            ctx.AddObjectToAsset("words", words);
            ctx.SetMainObject(words);
        }
    }

    /// <summary>Claims what <see cref="WordsImporter"/> claims.</summary>
    [ScriptedImporter(1, "WORDS")]
    abstract class RivalImporter : ScriptedImporter
    {
    }

    /// <summary>Writes down what it hears, of .words files.</summary>
    sealed class WordsPostprocessor : AssetPostprocessor
    {
        internal static List<string> Heard { get; } = new();

        static void OnPostprocessAllAssets(string[] imported, string[] deleted, string[] moved, string[] movedFrom)
        {
            Heard.AddRange(Array.ConvertAll(Array.FindAll(imported, i => i.EndsWith(".words", StringComparison.Ordinal)), i => "+" + Path.GetFileName(i)));
            Heard.AddRange(Array.ConvertAll(Array.FindAll(deleted, i => i.EndsWith(".words", StringComparison.Ordinal)), i => "-" + Path.GetFileName(i)));
        }
    }
}
