using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>One row of a <see cref="SegmentTable"/>: an anatomical structure with its label, name, colour and opacity. Immutable.</summary>
    public sealed class Segment
    {
        /// <summary>Makes a segment.</summary>
        /// <param name="index">Its row in the table, from 0; what the voxels of a <see cref="LabelMap"/> hold.</param>
        /// <param name="label">Its value in the file; any whole number.</param>
        /// <param name="name">The name to show; not null.</param>
        /// <param name="color">Its colour.</param>
        /// <param name="opacity">0 (invisible) to 1; multiplies the transfer function.</param>
        /// <exception cref="ArgumentException">A negative index, a null name, an opacity outside 0..1.</exception>
        public Segment(int index, long label, string name, SegmentColor color, float opacity = 1f)
        {
            if (index < 0)
                throw new ArgumentException(FormattableString.Invariant($"A segment's index is 0 or more, not {index}."), nameof(index));

            // Written so that NaN fails too.
            if (!(opacity >= 0f && opacity <= 1f))
                throw new ArgumentException(FormattableString.Invariant($"A segment's opacity is 0 to 1, not {opacity}."), nameof(opacity));
            Index = index;
            Label = label;
            Name = name ?? throw new ArgumentNullException(nameof(name));
            Color = color;
            Opacity = opacity;
        }

        /// <summary>Its row in the table, from 0; what the voxels of a <see cref="LabelMap"/> hold.</summary>
        public int Index { get; }

        /// <summary>Its value in the file.</summary>
        public long Label { get; }

        /// <summary>The name to show.</summary>
        public string Name { get; }

        /// <summary>Its colour, sRGB.</summary>
        public SegmentColor Color { get; }

        /// <summary>0 (invisible) to 1; multiplies the transfer function.</summary>
        public float Opacity { get; }

        /// <summary>The same segment with another opacity, 0 to 1.</summary>
        /// <exception cref="ArgumentException">The opacity is outside 0..1.</exception>
        public Segment WithOpacity(float opacity) => new Segment(Index, Label, Name, Color, opacity);

        /// <summary>The same segment with another colour.</summary>
        public Segment WithColor(SegmentColor color) => new Segment(Index, Label, Name, color, Opacity);

        /// <summary>The same segment with another name.</summary>
        /// <exception cref="ArgumentNullException">The name is null.</exception>
        public Segment WithName(string name) => new Segment(Index, Label, name, Color, Opacity);

        /// <summary>Name and label.</summary>
        public override string ToString() => FormattableString.Invariant($"{Name} (label {Label})");
    }
}
