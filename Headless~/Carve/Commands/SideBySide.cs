using System;
using System.Linq;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>Pictures of the same size as one.</summary>
    static class SideBySide
    {
        /// <param name="pictures">row by row</param>
        /// <param name="rowLength">elements in a row of each</param>
        public static T[] Join<T>(T[][] pictures, int rowLength)
        {
            var joined = new T[pictures.Sum(picture => picture.Length)];
            for (var row = 0; row * rowLength < pictures[0].Length; row++)
            {
                for (var n = 0; n < pictures.Length; n++)
                {
                    Array.Copy(pictures[n], row * rowLength, joined, (row * pictures.Length + n) * rowLength, rowLength);
                }
            }

            return joined;
        }
    }
}
