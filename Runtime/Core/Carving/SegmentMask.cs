using System;
using System.Collections.Generic;
using System.Globalization;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>Which segments a clip sphere clips: one bit per segment, 1 = clipped. Immutable; equal when size and bits are equal.</summary>
    public sealed class SegmentMask : IEquatable<SegmentMask>
    {
        const int BitsPerWord = 32;

        readonly uint[] words;

        SegmentMask(int segmentCount, uint[] words)
        {
            SegmentCount = segmentCount;
            this.words = words;
            ClippedCount = CountBits(words);
        }

        /// <summary>The number of segments, label 0 included: 1 to <see cref="SegmentTable.MaximumCount"/>.</summary>
        public int SegmentCount { get; }

        /// <summary>The number of segments that are clipped: 0 to <see cref="SegmentCount"/>.</summary>
        public int ClippedCount { get; }

        /// <summary>Whether every segment is clipped.</summary>
        public bool IsAll => ClippedCount == SegmentCount;

        /// <summary>Whether no segment is clipped.</summary>
        public bool IsNone => ClippedCount == 0;

        /// <summary>The number of 32-bit words that <see cref="CopyWordsTo"/> writes: (SegmentCount + 31) / 32.</summary>
        public int WordCount => words.Length;

        /// <summary>Whether the segment is clipped.</summary>
        /// <param name="segment">Dense segment index, 0 to SegmentCount - 1.</param>
        /// <exception cref="ArgumentOutOfRangeException">The mask has no such segment.</exception>
        public bool this[int segment]
        {
            get
            {
                CheckSegment(segment, SegmentCount);
                return (words[segment / BitsPerWord] & Bit(segment)) != 0;
            }
        }

        /// <summary>Whether any of the segments is clipped. They are not checked.</summary>
        internal bool HoldsAny(ReadOnlySpan<ushort> segments)
        {
            foreach (ushort segment in segments)
                if ((words[segment / BitsPerWord] & Bit(segment)) != 0)
                    return true;
            return false;
        }

        /// <summary>Whether all of the segments are clipped. They are not checked.</summary>
        internal bool HoldsAll(ReadOnlySpan<ushort> segments)
        {
            if (IsAll)
                return true;
            foreach (ushort segment in segments)
                if ((words[segment / BitsPerWord] & Bit(segment)) == 0)
                    return false;
            return true;
        }

        /// <summary>The segments that one of two masks clips and the other does not.</summary>
        internal SegmentMask DifferenceFrom(SegmentMask other)
        {
            var different = new uint[words.Length];
            for (int w = 0; w < different.Length; w++)
                different[w] = words[w] ^ other.words[w];
            return new SegmentMask(SegmentCount, different);
        }

        /// <summary>Whether the segments that this mask clips are all clipped by another one too.</summary>
        internal bool IsWithin(SegmentMask other, ReadOnlySpan<ushort> segments)
        {
            foreach (ushort segment in segments)
                if ((words[segment / BitsPerWord] & ~other.words[segment / BitsPerWord] & Bit(segment)) != 0)
                    return false;
            return true;
        }

        /// <summary>A mask that clips every one of the segments.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The number is not 1 to <see cref="SegmentTable.MaximumCount"/>.</exception>
        public static SegmentMask All(int segmentCount)
        {
            uint[] words = NewWords(segmentCount);
            for (int w = 0; w < words.Length; w++)
                words[w] = uint.MaxValue;
            int used = segmentCount % BitsPerWord;
            if (used != 0)
                words[words.Length - 1] = (1u << used) - 1;
            return new SegmentMask(segmentCount, words);
        }

        /// <summary>A mask that clips none of the segments.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The number is not 1 to <see cref="SegmentTable.MaximumCount"/>.</exception>
        public static SegmentMask None(int segmentCount) => new SegmentMask(segmentCount, NewWords(segmentCount));

        /// <summary>A mask that clips the named segments and no other; naming one twice changes nothing.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="segments"/> is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException">A number or an index lies outside its range.</exception>
        public static SegmentMask FromIndices(int segmentCount, IEnumerable<int> segments)
        {
            if (segments == null)
                throw new ArgumentNullException(nameof(segments));
            uint[] words = NewWords(segmentCount);
            foreach (int segment in segments)
            {
                CheckSegment(segment, segmentCount);
                words[segment / BitsPerWord] |= Bit(segment);
            }
            return new SegmentMask(segmentCount, words);
        }

        /// <summary>This mask with one bit set as given; this mask itself where it is so already.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The mask has no such segment.</exception>
        public SegmentMask With(int segment, bool clipped)
        {
            if (this[segment] == clipped)
                return this;
            uint[] changed = (uint[])words.Clone();
            changed[segment / BitsPerWord] ^= Bit(segment);
            return new SegmentMask(SegmentCount, changed);
        }

        /// <summary>This mask with one bit turned over.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The mask has no such segment.</exception>
        public SegmentMask Toggled(int segment) => With(segment, !this[segment]);

        /// <summary>The reset rule: if every bit is on, all off; otherwise all on.</summary>
        public SegmentMask Reset() => IsAll ? None(SegmentCount) : All(SegmentCount);

        /// <summary>The indices of the clipped segments, ascending.</summary>
        public IEnumerable<int> ClippedSegments()
        {
            for (int segment = 0; segment < SegmentCount; segment++)
                if ((words[segment / BitsPerWord] & Bit(segment)) != 0)
                    yield return segment;
        }

        /// <summary>Writes the bits as the kernels read them: segment s is bit s % 32 of word s / 32; bits past the last segment are 0.</summary>
        /// <param name="destination">Takes <see cref="WordCount"/> words.</param>
        /// <param name="offset">Index of the first word written.</param>
        /// <exception cref="ArgumentNullException"><paramref name="destination"/> is null.</exception>
        /// <exception cref="ArgumentException">The words do not fit.</exception>
        public void CopyWordsTo(uint[] destination, int offset)
        {
            if (destination == null)
                throw new ArgumentNullException(nameof(destination));
            if (offset < 0 || offset > destination.Length - words.Length)
                throw new ArgumentException(FormattableString.Invariant(
                    $"{words.Length} words do not fit at offset {offset} of {destination.Length}."), nameof(offset));
            Array.Copy(words, 0, destination, offset, words.Length);
        }

        /// <inheritdoc/>
        public bool Equals(SegmentMask other)
        {
            if (ReferenceEquals(this, other))
                return true;
            if (other is null || other.SegmentCount != SegmentCount || other.ClippedCount != ClippedCount)
                return false;
            return words.AsSpan().SequenceEqual(other.words);
        }

        /// <inheritdoc/>
        public override bool Equals(object obj) => Equals(obj as SegmentMask);

        /// <inheritdoc/>
        public override int GetHashCode()
        {
            int hash = SegmentCount;
            foreach (uint word in words)
                hash = unchecked((hash * 16777619) ^ (int)word);
            return hash;
        }

        /// <summary>For messages: "3 of 117 segments".</summary>
        public override string ToString() =>
            string.Format(CultureInfo.InvariantCulture, "{0} of {1} segments", ClippedCount, SegmentCount);

        static uint Bit(int segment) => 1u << (segment % BitsPerWord);

        static uint[] NewWords(int segmentCount)
        {
            if (segmentCount < 1 || segmentCount > SegmentTable.MaximumCount)
                throw new ArgumentOutOfRangeException(nameof(segmentCount), segmentCount,
                    FormattableString.Invariant($"A mask has 1 to {SegmentTable.MaximumCount} segments, label 0 included."));
            return new uint[(segmentCount + BitsPerWord - 1) / BitsPerWord];
        }

        static void CheckSegment(int segment, int segmentCount)
        {
            if (segment < 0 || segment >= segmentCount)
                throw new ArgumentOutOfRangeException(nameof(segment), segment,
                    FormattableString.Invariant($"The segments are 0 to {segmentCount - 1}."));
        }

        static int CountBits(uint[] words)
        {
            int count = 0;
            foreach (uint word in words)
                for (uint rest = word; rest != 0; rest &= rest - 1)
                    count++;
            return count;
        }
    }
}
