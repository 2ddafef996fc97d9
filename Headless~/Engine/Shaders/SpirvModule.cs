using System;
using System.Collections.Generic;
using System.Text;

namespace UnityEngine.Shaders
{
    /// <summary>The opcodes of SPIR-V that are looked at here.</summary>
    enum SpirvOp : ushort
    {
        Name = 5,
        Extension = 10,
        MemberName = 6,
        EntryPoint = 15,
        ExecutionMode = 16,
        Capability = 17,
        TypeVoid = 19,
        TypeBool = 20,
        TypeInt = 21,
        TypeFloat = 22,
        TypeVector = 23,
        TypeMatrix = 24,
        TypeImage = 25,
        TypeSampler = 26,
        TypeSampledImage = 27,
        TypeArray = 28,
        TypeRuntimeArray = 29,
        TypeStruct = 30,
        TypePointer = 32,
        Constant = 43,
        Function = 54,
        FunctionCall = 57,
        Variable = 59,
        ImageTexelPointer = 60,
        Load = 61,
        Store = 62,
        AccessChain = 65,
        Decorate = 71,
        MemberDecorate = 72,
        CopyObject = 83,
        ImageRead = 98,
        ImageWrite = 99,
        FAdd = 129,
        FSub = 131,
        FMul = 133,
        Select = 169,
        Phi = 245,
        Label = 248,
        DecorateString = 5632,
        MemberDecorateString = 5633,
    }

    /// <summary>One instruction: opcode and operands, as a window on the module's words.</summary>
    readonly struct SpirvInstruction
    {
        readonly uint[] m_Words;

        internal SpirvInstruction(uint[] words, int position)
        {
            m_Words = words;
            Position = position;
        }

        /// <summary>Index of its first word.</summary>
        internal int Position { get; }

        internal SpirvOp Op => (SpirvOp)(m_Words[Position] & 0xFFFF);

        /// <summary>Words, the first one included.</summary>
        internal int Length => (int)(m_Words[Position] >> 16);

        /// <summary>Word 1 is the first operand.</summary>
        internal uint this[int word] => m_Words[Position + word];

        internal string Text(int word)
        {
            var bytes = new List<byte>();
            for (var i = word; i < Length; i++)
            {
                for (var shift = 0; shift < 32; shift += 8)
                {
                    var c = (byte)(this[i] >> shift);
                    if (c == 0)
                        return Encoding.UTF8.GetString(bytes.ToArray());
                    bytes.Add(c);
                }
            }
            return Encoding.UTF8.GetString(bytes.ToArray());
        }
    }

    /// <summary>A SPIR-V module as words.</summary>
    sealed class SpirvModule
    {
        internal const int HeaderLength = 5;

        const uint Magic = 0x07230203;

        internal SpirvModule(uint[] words) => Words = words;

        internal uint[] Words { get; }

        /// <summary>One more than the largest ID.</summary>
        internal uint Bound => Words[3];

        /// <exception cref="FormatException">Not SPIR-V in this machine's byte order.</exception>
        internal static SpirvModule Parse(byte[] content)
        {
            if (content.Length < HeaderLength * 4 || content.Length % 4 != 0 || BitConverter.ToUInt32(content, 0) != Magic)
                throw new FormatException("not a SPIR-V module");
            var words = new uint[content.Length / 4];
            Buffer.BlockCopy(content, 0, words, 0, content.Length);
            var module = new SpirvModule(words);
            for (var i = HeaderLength; i < words.Length; i += (int)(words[i] >> 16))
                if (words[i] >> 16 == 0 || i + (words[i] >> 16) > words.Length)
                    throw new FormatException($"broken SPIR-V instruction at word {i}");
            return module;
        }

        internal byte[] ToBytes()
        {
            var bytes = new byte[Words.Length * 4];
            Buffer.BlockCopy(Words, 0, bytes, 0, bytes.Length);
            return bytes;
        }

        internal IEnumerable<SpirvInstruction> Instructions()
        {
            for (var i = HeaderLength; i < Words.Length; i += (int)(Words[i] >> 16))
                yield return new SpirvInstruction(Words, i);
        }
    }
}
