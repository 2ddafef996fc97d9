using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace UnityEngine.Shaders
{
    /// <summary>A variable that a stage takes from or hands to its neighbour.</summary>
    sealed class StageVariable
    {
        /// <summary>The ID in the module.</summary>
        internal uint Id;

        /// <summary>In capitals, with its index: TEXCOORD0, SV_TARGET0.</summary>
        internal string Semantic;
        internal NumberKind Number;
        internal int Components;

        /// <summary>How many locations it takes: more than one for a matrix.</summary>
        internal int Locations;
    }

    /// <summary>Reads a stage's inputs and outputs by their semantics out of its SPIR-V. Those that Vulkan itself fills or takes are left out.</summary>
    sealed class StageInterface
    {
        const uint StorageInput = 1;
        const uint StorageOutput = 3;
        const uint DecorationBuiltIn = 11;
        const uint DecorationUserSemantic = 5635;

        readonly SpirvTypes m_Types = new();
        readonly Dictionary<uint, string> m_Semantics = new();
        readonly List<SpirvInstruction> m_Variables = new();

        internal StageInterface(SpirvModule module)
        {
            foreach (var instruction in module.Instructions())
            {
                if (instruction.Op == SpirvOp.Variable)
                    m_Variables.Add(instruction);
                else if (instruction.Op == SpirvOp.DecorateString && instruction[2] == DecorationUserSemantic)
                    m_Semantics[instruction[1]] = Normalized(instruction.Text(3));
                else
                    m_Types.Visit(instruction);
            }
            Inputs = Of(StorageInput);
            Outputs = Of(StorageOutput);
        }

        internal IReadOnlyList<StageVariable> Inputs { get; }

        internal IReadOnlyList<StageVariable> Outputs { get; }

        /// <summary>A semantic without an index has the index 0.</summary>
        internal static string Normalized(string semantic)
        {
            var upper = semantic.ToUpper(CultureInfo.InvariantCulture);
            return char.IsDigit(upper[upper.Length - 1]) ? upper : upper + "0";
        }

        List<StageVariable> Of(uint storage) => m_Variables.Where(v => v[3] == storage && m_Semantics.ContainsKey(v[2])
            && !m_Types.HasDecoration(v[2], DecorationBuiltIn)).Select(Variable).ToList();

        StageVariable Variable(SpirvInstruction variable)
        {
            var type = m_Types[m_Types[variable[1]][3]];
            var locations = 1;
            if (type.Op == SpirvOp.TypeMatrix)
            {
                locations = (int)type[3];
                type = m_Types[type[2]];
            }
            if (type.Op is SpirvOp.TypeArray or SpirvOp.TypeStruct)
                throw new NotSupportedException($"'{m_Semantics[variable[2]]}' is an array or a struct; between stages go numbers, vectors and matrices here.");
            return new StageVariable
            {
                Id = variable[2],
                Semantic = m_Semantics[variable[2]],
                Number = m_Types.Number(type[1]),
                Components = type.Op == SpirvOp.TypeVector ? (int)type[3] : 1,
                Locations = locations,
            };
        }
    }
}
