using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;
using AnatomyCarve.Desktop;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Layout
{
    /// <summary>What users see of the components: menu entries, help pages, tooltips, ranges, Inspectors of their own.</summary>
    public partial class InspectorTests
    {
        /// <summary>Numbers that may be any.</summary>
        static readonly string[] Unlimited =
        [
            "TransferFunctionPoint.value", "SegmentAppearance.label", "VolumeAssetSegment.label", "VolumeAssetSegment.voxels",
        ];

        static readonly PackageTree Tree = PackageTree.OfRepository();
        static readonly Assembly Main = typeof(CarvedVolumeRenderer).Assembly;
        static readonly Type[] Types = new[] { Main, typeof(OrbitView).Assembly }.SelectMany(a => a.GetTypes()).ToArray();

        [TestCaseSource(nameof(Components))]
        public void Component_IsInTheMenu(Type type) =>
            Assert.That(type.GetCustomAttribute<AddComponentMenu>()?.componentMenu, Does.Match("^AnatomyCarve/[A-Z][A-Za-z ]+$"));

        [TestCaseSource(nameof(Components))]
        public void Component_HasAPageOfTheManual(Type type)
        {
            string url = type.GetCustomAttribute<HelpURLAttribute>()?.URL;
            Assert.That(url, Does.StartWith("file://").And.EndsWith(".md"));
            string page = "Documentation~/" + Path.GetFileName(new Uri(url).LocalPath);
            Assert.That(File.Exists(Tree.Full(page)), Is.True, page);
        }

        [TestCaseSource(nameof(Components))]
        public void Component_OnAGameObject_IsTheOnlyOneOfItsKind(Type type) =>
            Assert.That(type.GetCustomAttribute<DisallowMultipleComponent>(), Is.Not.Null);

        [TestCaseSource(nameof(Fields))]
        public void Field_HasATooltip(FieldInfo field)
        {
            string tooltip = field.GetCustomAttribute<TooltipAttribute>()?.tooltip;
            Assert.That(tooltip, Is.Not.Null.And.Not.Empty);
            Assert.That(tooltip, Does.Not.EndWith("."), "tooltips are no full sentences");
        }

        [TestCaseSource(nameof(Fields))]
        public void Field_ThatIsANumber_HasItsRange(FieldInfo field)
        {
            if (!IsNumber(field.FieldType) || Unlimited.Contains(Name(field)))
                return;
            Assert.That(field.GetCustomAttribute<UnityEngine.RangeAttribute>() != null || field.GetCustomAttribute<MinAttribute>() != null, Is.True);
        }

        [Test]
        public void Fields_WithoutLimits_Exist() => Assert.That(Unlimited, Is.SubsetOf(Fields().Select(f => Name((FieldInfo)f.Arguments[0]))));

        [Test]
        public void Components_OfTheMainAssembly_HaveInspectors()
        {
            IEnumerable<string> inspected = Tree.Files.Where(f => f.StartsWith("Editor/") && f.EndsWith(".cs"))
                .SelectMany(f => CustomEditor().Matches(Tree.Read(f)).Select(m => m.Groups[1].Value));
            Assert.That(Components().Select(t => (Type)t.Arguments[0]).Where(t => t.Assembly == Main).Select(t => t.Name).Except(inspected), Is.Empty);
        }

        /// <summary>An Inspector that asks for a field that was renamed gets null, and fails only when somebody looks at it.</summary>
        [Test]
        public void Inspectors_Properties_AreFields()
        {
            HashSet<string> fields = Fields().Select(f => ((FieldInfo)f.Arguments[0]).Name).ToHashSet();
            var unknown = new List<string>();
            foreach (string file in Tree.Files.Where(f => f.StartsWith("Editor/Inspectors/") && f.EndsWith(".cs")))
                foreach (Match match in Property().Matches(Tree.Read(file)))
                    if (!fields.Contains(match.Groups[1].Value))
                        unknown.Add($"{file}: {match.Groups[1].Value}");
            Assert.That(unknown, Is.Empty);
        }

        static IEnumerable<TestCaseData> Components() => Types
            .Where(t => typeof(MonoBehaviour).IsAssignableFrom(t) && !t.IsAbstract).Select(t => new TestCaseData(t).SetArgDisplayNames(t.Name));

        /// <summary>What Inspectors show: the saved fields of components and of the settings in them.</summary>
        static IEnumerable<TestCaseData> Fields() => Types
            .Where(t => typeof(MonoBehaviour).IsAssignableFrom(t) || IsSettings(t))
            .SelectMany(t => t.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
            .Where(IsSaved).Select(f => new TestCaseData(f).SetArgDisplayNames(Name(f)));

        static bool IsSettings(Type type) => type.IsDefined(typeof(SerializableAttribute), false) && (type.IsClass || type.IsValueType) && !type.IsEnum
            && !typeof(Delegate).IsAssignableFrom(type) && !typeof(Exception).IsAssignableFrom(type) && !type.IsDefined(typeof(CompilerGeneratedAttribute));

        static bool IsSaved(FieldInfo field) =>
            !field.IsInitOnly && !field.IsDefined(typeof(NonSerializedAttribute)) && (field.IsPublic || field.GetCustomAttribute<SerializeField>() != null);

        static bool IsNumber(Type type) => type == typeof(float) || type == typeof(double) || type == typeof(int) || type == typeof(long);

        static string Name(FieldInfo field) => field.DeclaringType.Name + "." + field.Name;

        [GeneratedRegex(@"\[CustomEditor\(typeof\((\w+)\)\)\]")]
        private static partial Regex CustomEditor();

        [GeneratedRegex(@"FindProperty(?:Relative)?\(""(\w+)""\)")]
        private static partial Regex Property();
    }
}
