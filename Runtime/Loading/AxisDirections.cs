using System;

namespace AnatomyCarve
{
    /// <summary>Says in words what an orientation code such as LPS means.</summary>
    static class AxisDirections
    {
        /// <summary>A sentence.</summary>
        /// <param name="code">Three of the letters L, R, P, A, S, I: the direction that each axis of the grid runs to.</param>
        /// <exception cref="ArgumentException">It is no such code.</exception>
        public static string Sentence(string code)
        {
            if (code == null || code.Length != 3)
                throw new ArgumentException($"'{code}' is no orientation code; expected three letters.", nameof(code));
            return $"The first axis runs to the patient's {Name(code, 0)}, the second to the {Name(code, 1)}, the third to the {Name(code, 2)}.";
        }

        static string Name(string code, int axis)
        {
            switch (code[axis])
            {
                case 'L':
                    return "left";
                case 'R':
                    return "right";
                case 'P':
                    return "back";
                case 'A':
                    return "front";
                case 'S':
                    return "head";
                case 'I':
                    return "feet";
                default:
                    throw new ArgumentException($"'{code}' is no orientation code; expected the letters L or R, P or A, S or I.", nameof(code));
            }
        }
    }
}
