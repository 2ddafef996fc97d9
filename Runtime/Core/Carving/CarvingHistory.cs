using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>The steps that can be undone and redone. A step is a pair of snapshots; moves of one gesture grow into one step.</summary>
    sealed class CarvingHistory
    {
        readonly List<Step> undo = new List<Step>();
        readonly List<Step> redo = new List<Step>();
        int limit;

        public CarvingHistory(int limit) => this.limit = limit;

        public bool CanUndo => undo.Count > 0;

        public bool CanRedo => redo.Count > 0;

        public int Limit
        {
            get => limit;
            set
            {
                limit = value;
                Trim();
            }
        }

        /// <summary>Takes a step in; what could be redone is forgotten. <paramref name="gesture"/> 0 = a step of its own.</summary>
        public void Push(CarvingChangeKind kind, int sphereIndex, CarvingSnapshot before, CarvingSnapshot after, int gesture)
        {
            redo.Clear();
            int last = undo.Count - 1;
            if (gesture != 0 && last >= 0 && undo[last].Gesture == gesture && undo[last].Kind == kind)
            {
                CarvingSnapshot start = undo[last].Before;
                if (start.SameAs(after))
                    undo.RemoveAt(last);
                else
                    undo[last] = new Step(kind, sphereIndex, start, after, gesture);
                return;
            }
            undo.Add(new Step(kind, sphereIndex, before, after, gesture));
            Trim();
        }

        public Step TakeUndo() => Take(undo, redo);

        public Step TakeRedo() => Take(redo, undo);

        static Step Take(List<Step> from, List<Step> to)
        {
            Step step = from[from.Count - 1];
            from.RemoveAt(from.Count - 1);
            to.Add(step);
            return step;
        }

        void Trim()
        {
            if (undo.Count > limit)
                undo.RemoveRange(0, undo.Count - limit);
            if (redo.Count > limit)
                redo.RemoveRange(0, redo.Count - limit);
        }

        public readonly struct Step
        {
            public Step(CarvingChangeKind kind, int sphereIndex, CarvingSnapshot before, CarvingSnapshot after, int gesture)
            {
                Kind = kind;
                SphereIndex = sphereIndex;
                Before = before;
                After = after;
                Gesture = gesture;
            }

            public CarvingChangeKind Kind { get; }

            public int SphereIndex { get; }

            public CarvingSnapshot Before { get; }

            public CarvingSnapshot After { get; }

            public int Gesture { get; }
        }
    }
}
