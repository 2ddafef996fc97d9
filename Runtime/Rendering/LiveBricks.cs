using System.Collections.Generic;
using AnatomyCarve.Carving;

namespace AnatomyCarve
{
    /// <summary>The bricks that kernels work on when a whole volume is computed: those in which, or beside which, anything is visible before carving.</summary>
    sealed class LiveBricks
    {
        readonly bool[] wasNearMatter;
        readonly List<int> visible = new List<int>(), nearMatter = new List<int>(), emptied = new List<int>();

        public LiveBricks(int brickCount) => wasNearMatter = new bool[brickCount];

        /// <summary>Bricks with a visible segment: where opacity can be above 0.</summary>
        public IReadOnlyList<int> Visible => visible;

        /// <summary>Those and all around them: where anti-aliased opacity and normals can be.</summary>
        public IReadOnlyList<int> NearMatter => nearMatter;

        /// <summary>Takes over what is visible now.</summary>
        /// <param name="all">Whether nothing has been computed or emptied yet.</param>
        /// <returns>The bricks that are to be emptied. They include those beside visible ones, whose opacity nobody else writes.</returns>
        public IReadOnlyList<int> Take(VisibleContents contents, bool all)
        {
            visible.Clear();
            nearMatter.Clear();
            emptied.Clear();
            for (int brick = 0; brick < wasNearMatter.Length; brick++)
            {
                bool isVisible = contents[brick].Length > 0, isNear = contents.IsNearMatter(brick);
                if (isVisible)
                    visible.Add(brick);
                else if (all || wasNearMatter[brick])
                    emptied.Add(brick);
                if (isNear)
                    nearMatter.Add(brick);
                wasNearMatter[brick] = isNear;
            }
            return emptied;
        }
    }
}
