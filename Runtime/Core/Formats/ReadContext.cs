using System;
using System.Threading;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>What goes along while one file is read: its name, what was odd in it, cancellation and progress.</summary>
    sealed class ReadContext
    {
        internal ReadContext(string source, string format, CancellationToken cancellation, IProgress<float> progress)
        {
            Source = source;
            Cancellation = cancellation;
            Progress = progress;
            Description = new VolumeDescription { Source = source, Format = format };
        }

        /// <summary>The file, or what the caller named the stream.</summary>
        internal string Source { get; }

        internal CancellationToken Cancellation { get; }

        /// <summary>May be null.</summary>
        internal IProgress<float> Progress { get; }

        /// <summary>Collects warnings, segments and key/values.</summary>
        internal VolumeDescription Description { get; }

        internal void Warn(FormattableString sentence) => Description.Warnings.Add(FormattableString.Invariant(sentence));

        /// <summary>The exception for something that can't be read: names the field, what stands there, and what was expected.</summary>
        internal VolumeFormatException Refusal(string field, FormattableString found, string expectation, Exception cause = null) =>
            new VolumeFormatException(Source, field, FormattableString.Invariant(found), expectation, cause);

        /// <summary>Makes the geometry, or refuses the file.</summary>
        /// <param name="field">The header's field that places the voxels.</param>
        internal VolumeGeometry MakeGeometry(int sizeI, int sizeJ, int sizeK, Affine ijkToLps, string field)
        {
            string problem = VolumeGeometry.FindProblem(ijkToLps);
            if (problem != null)
                throw Refusal(field, $"{ijkToLps}", "three independent axes of finite length (" + problem.TrimEnd('.') + ")");
            return new VolumeGeometry(sizeI, sizeJ, sizeK, ijkToLps);
        }
    }
}
