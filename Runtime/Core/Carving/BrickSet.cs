using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>A set of bricks by their numbers, whose work follows the bricks in it and not the volume's.</summary>
    sealed class BrickSet
    {
        readonly bool[] isIn;
        readonly List<int> indices = new List<int>();

        public BrickSet(int brickCount) => isIn = new bool[brickCount];

        /// <summary>The bricks, in the order in which they were added.</summary>
        public List<int> Indices => indices;

        public bool this[int brick] => isIn[brick];

        /// <summary>Adds a brick that is not in it.</summary>
        public void Add(int brick)
        {
            isIn[brick] = true;
            indices.Add(brick);
        }

        public void Clear()
        {
            foreach (int brick in indices)
                isIn[brick] = false;
            indices.Clear();
        }

        public void CopyFrom(BrickSet other)
        {
            Clear();
            foreach (int brick in other.indices)
                Add(brick);
        }

        public void Sort() => indices.Sort();
    }
}
