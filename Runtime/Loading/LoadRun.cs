using System;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>One load of a loader: its progress, and what stops it.</summary>
    sealed class LoadRun
    {
        readonly CancellationToken caller, owner;
        readonly LoadProgress relay;
        CancellationTokenSource source;

        /// <param name="caller">The token of whoever asked for the load.</param>
        /// <param name="owner">The token of the component's end.</param>
        /// <param name="progress">Gets 0 to 1; may be null.</param>
        public LoadRun(CancellationToken caller, CancellationToken owner, IProgress<float> progress)
        {
            this.caller = caller;
            this.owner = owner;
            relay = new LoadProgress(progress);
        }

        /// <summary>0 to 1.</summary>
        public float Progress => relay.Value;

        /// <summary>Whether it has begun and has not ended.</summary>
        public bool IsRunning => source != null;

        /// <summary>Stops it; it counts as ended at once.</summary>
        public void Cancel()
        {
            CancellationTokenSource running = source;
            source = null;
            running?.Cancel();
        }

        /// <summary>Loads. Called on the main thread, and ends there.</summary>
        /// <param name="open">One of the ways of <see cref="VolumeOpening"/>.</param>
        /// <param name="failed">Told of what went wrong; not of a cancellation, nor of failures after one.</param>
        public async Task<SegmentedVolume> Run(Func<CancellationToken, IProgress<float>, Task<SegmentedVolume>> open, Action<Exception> failed)
        {
            // Outside Play the exit's token is that of the last Play, which has ended.
            CancellationToken exit = Application.isPlaying ? Application.exitCancellationToken : CancellationToken.None;
            using var linked = CancellationTokenSource.CreateLinkedTokenSource(caller, owner, exit);
            source = linked;
            CancellationToken token = linked.Token;
            try
            {
                relay.Report(0f);
                SegmentedVolume volume = await open(token, relay);
                relay.Report(1f); // whoever is told may cancel
                token.ThrowIfCancellationRequested();
                return volume;
            }
            catch (Exception e) when (!(e is OperationCanceledException))
            {
                source = null; // whoever is told may load again
                if (!token.IsCancellationRequested)
                    failed(e);
                throw;
            }
            finally
            {
                source = null;
            }
        }
    }
}
