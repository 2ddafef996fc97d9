namespace AnatomyCarve.Formats
{
    /// <summary>An entry of a packed volume's directory: one block's bytes.</summary>
    readonly struct PackedBlock
    {
        /// <summary>The method, one byte; the length, a number of at least one byte; the checksum, eight bytes.</summary>
        internal const int SmallestEntryBytes = 10;

        internal PackedBlock(BlockMethod method, int start, int length, ulong checksum)
        {
            Method = method;
            Start = start;
            Length = length;
            Checksum = checksum;
        }

        internal BlockMethod Method { get; }

        /// <summary>Where its bytes begin in the file.</summary>
        internal int Start { get; }

        internal int Length { get; }

        /// <summary><see cref="Checksum64"/> of its bytes.</summary>
        internal ulong Checksum { get; }
    }
}
