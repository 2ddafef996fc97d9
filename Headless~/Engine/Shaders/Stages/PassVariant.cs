using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine.Shaders
{
    /// <summary>An attribute of vertices that a program reads.</summary>
    readonly struct VertexInput
    {
        internal VertexInput(string semantic, uint location, NumberKind number)
        {
            Semantic = semantic;
            Location = location;
            Number = number;
        }

        internal readonly string Semantic;
        internal readonly uint Location;
        internal readonly NumberKind Number;
    }

    /// <summary>A pass with one choice of keywords: both stages, compiled when they are first asked for, and linked by their semantics.</summary>
    sealed class PassVariant
    {
        const uint VertexSet = 0;
        const uint FragmentSet = 1;

        readonly PassSource m_Source;
        readonly IReadOnlyList<string> m_Keywords;
        bool m_Compiled;
        DrawProgram m_Program;

        internal PassVariant(PassSource source, IReadOnlyList<string> keywords)
        {
            m_Source = source;
            m_Keywords = keywords;
        }

        /// <summary>Why it cannot run; null if it can.</summary>
        internal string Error { get; private set; }

        internal string VertexEntry => m_Source.VertexEntry;

        internal string FragmentEntry => m_Source.FragmentEntry;

        internal byte[] VertexCode { get; private set; }

        internal byte[] FragmentCode { get; private set; }

        internal IReadOnlyList<KernelBinding> VertexBindings { get; private set; }

        internal IReadOnlyList<KernelBinding> FragmentBindings { get; private set; }

        internal IReadOnlyList<VertexInput> VertexInputs { get; private set; }

        /// <summary>How many colours it writes: one more than the largest index of SV_Target.</summary>
        internal int TargetCount { get; private set; }

        internal bool Has(string keyword) => m_Keywords.Contains(keyword);

        /// <summary>The defines that Unity gives a stage on a graphics API, and those of the keywords.</summary>
        internal static List<string> Defines(PassSource source, IReadOnlyList<string> keywords, string api, string stage)
        {
            var defines = new List<string>
            {
                api + "=1", stage + "=1", "SHADER_TARGET=" + source.Target.ToString(System.Globalization.CultureInfo.InvariantCulture), "UNITY_VERSION=600000",
            };
            if (!ColorSpaces.IsLinear)
                defines.Add("UNITY_COLORSPACE_GAMMA=1");
            defines.AddRange(keywords.Select(k => k + "=1"));
            return defines;
        }

        /// <summary>Compiles if need be; logs the error the first time.</summary>
        internal bool Compile()
        {
            if (m_Compiled)
                return Error == null;
            m_Compiled = true;
            try
            {
                Link(Module("vert", m_Source.VertexEntry, "SHADER_STAGE_VERTEX"), Module("frag", m_Source.FragmentEntry, "SHADER_STAGE_FRAGMENT"));
            }
            catch (Exception e) when (e is ShaderCompileException or FormatException or NotSupportedException)
            {
                Error = e is ShaderCompileException ? e.Message : $"Shader error in {Subject}: {e.Message}";
                Debug.LogError(Error);
            }
            return Error == null;
        }

        /// <summary>The program on the present device.</summary>
        internal DrawProgram Program(GpuContext context)
        {
            if (m_Program == null || m_Program.Context != context)
            {
                m_Program = new DrawProgram(context, this);
                context.Own(m_Program);
            }
            return m_Program;
        }

        string Subject => $"'{m_Source.File.Name}', pass {(m_Source.Pass.Name.Length > 0 ? m_Source.Pass.Name : "of line " + m_Source.Pass.Line)}"
            + (m_Keywords.Count > 0 ? $" [{string.Join(" ", m_Keywords)}]" : "");

        SpirvModule Module(string stage, string entry, string stageDefine) => SpirvModule.Parse(HlslCompiler.Compile(new HlslJob
        {
            Subject = Subject + ", " + entry,
            Path = m_Source.File.Path,
            Text = m_Source.Text,
            Stage = stage,
            Entry = entry,
            Defines = Defines(m_Source, m_Keywords, "SHADER_API_VULKAN", stageDefine),
        }));

        void Link(SpirvModule vertex, SpirvModule fragment)
        {
            var (v, f) = (new StageInterface(vertex), new StageInterface(fragment));
            var (vertexLocations, fragmentLocations) = (new Dictionary<uint, uint>(), new Dictionary<uint, uint>());
            Place(v.Inputs.Where(i => i.Semantic != StageRewriter.ViewSemantic), vertexLocations);
            Place(v.Outputs, vertexLocations);
            foreach (var input in f.Inputs.Where(i => i.Semantic != StageRewriter.ViewSemantic))
            {
                var output = v.Outputs.FirstOrDefault(o => o.Semantic == input.Semantic)
                    ?? throw new NotSupportedException($"the fragment stage reads {input.Semantic}, which the vertex stage does not write");
                if (output.Number != input.Number || output.Components < input.Components || output.Locations != input.Locations)
                    throw new NotSupportedException($"{input.Semantic} is of {output.Number} x {output.Components} in the vertex stage and of {input.Number} x "
                        + $"{input.Components} in the fragment stage");
                fragmentLocations[input.Id] = vertexLocations[output.Id];
            }
            VertexBindings = Bindings(vertex);
            FragmentBindings = Bindings(fragment);
            VertexInputs = v.Inputs.Where(i => vertexLocations.ContainsKey(i.Id))
                .Select(i => new VertexInput(i.Semantic, vertexLocations[i.Id], i.Number)).ToList();
            TargetCount = f.Outputs.Select(o => int.Parse(o.Semantic.Substring("SV_TARGET".Length), System.Globalization.CultureInfo.InvariantCulture) + 1)
                .DefaultIfEmpty(0).Max();
            VertexCode = PointSize.Add(StageRewriter.Rewrite(vertex, VertexSet, vertexLocations, View(v)));
            FragmentCode = StageRewriter.Rewrite(fragment, FragmentSet, fragmentLocations, View(f));
        }

        static uint View(StageInterface stage) => stage.Inputs.FirstOrDefault(i => i.Semantic == StageRewriter.ViewSemantic)?.Id ?? 0;

        static void Place(IEnumerable<StageVariable> variables, Dictionary<uint, uint> locations)
        {
            uint next = 0;
            foreach (var variable in variables)
            {
                locations[variable.Id] = next;
                next += (uint)variable.Locations;
            }
        }

        static IReadOnlyList<KernelBinding> Bindings(SpirvModule module)
        {
            var bindings = SpirvReflection.Reflect(module).Bindings;
            foreach (var binding in bindings)
            {
                if (binding.Kind is BindingKind.Texture or BindingKind.SampledTexture && binding.Dimension is not (TextureDimension.Tex2D
                    or TextureDimension.Tex2DArray or TextureDimension.Tex3D))
                    throw new NotSupportedException($"'{binding.Name}' is a texture of a dimension that this host does not have: {binding.Dimension}");
                if (binding.Kind == BindingKind.TexelBuffer)
                    throw new NotSupportedException(SpirvReflection.TypedBuffer(binding.Name));
                if (binding.Kind is BindingKind.RandomWriteBuffer or BindingKind.RandomWriteTexture)
                    throw new NotSupportedException($"'{binding.Name}' is written by a vertex or fragment stage, which this host does not support");
            }
            return bindings;
        }
    }
}
