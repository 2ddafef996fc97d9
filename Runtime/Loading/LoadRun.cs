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
        bool hasCoarse;

        /// <param name="caller">The token of whoever asked for the load.</param>
        /// <param name="owner">The token of the component's end.</param>
        /// <param name="progress">Gets 0 to 1; may be null.</param>
        public LoadRun(CancellationToken caller, CancellationToken owner, IProgress<float> progress)
        {
            this.caller = caller;
            this.owner = owner;
            relay = new LoadProgress(progress);
        }

        /// <summary>Told of what the volume will take, before anything large is taken. It may cancel the load.</summary>
        public Action<MemoryForecast> Forecast { get; set; }

        /// <summary>Told of a coarse volume that can be shown while the rest loads, and of null when the rest will not come. Null = none is wanted.</summary>
        public Action<SegmentedVolume> Coarse { get; set; }

        /// <summary>Told of what went wrong; not of a cancellation, nor of failures after one.</summary>
        public Action<Exception> Failed { get; set; }

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

        /// <summary>Loads. Called on the main thread, and ends there; so is everybody told.</summary>
        /// <param name="open">Gives the way to the volume.</param>
        /// <param name="loader">Whose settings say what to do with large volumes.</param>
        public async Task<SegmentedVolume> Run(Func<VolumeOpening> open, VolumeLoader loader)
        {
            // Outside Play the exit's token is that of the last Play, which has ended.
            CancellationToken exit = Application.isPlaying ? Application.exitCancellationToken : CancellationToken.None;
            using var linked = CancellationTokenSource.CreateLinkedTokenSource(caller, owner, exit);
            source = linked;
            CancellationToken token = linked.Token;
            try
            {
                relay.Report(0f);
                var plan = new LoadPlan(loader, Coarse == null ? null : new Progress<SegmentedVolume>(ShowCoarse)); // comes to this thread
                using VolumeOpening opening = open();
                SegmentedVolume volume = await Load(opening, plan, token);
                if (hasCoarse)
                    await Task.Yield(); // until the next frame: the coarse volume is seen while the whole one goes to the GPU
                relay.Report(1f); // whoever is told may cancel
                token.ThrowIfCancellationRequested();
                return volume;
            }
            catch (Exception e)
            {
                bool isCurrent = source == linked; // else it was cancelled, and the loader may be at another load
                source = null; // whoever is told may load again
                if (hasCoarse && isCurrent)
                    Coarse(null);
                if (!(e is OperationCanceledException) && !token.IsCancellationRequested)
                    Failed?.Invoke(e);
                throw;
            }
            finally
            {
                source = null;
            }
        }

        async Task<SegmentedVolume> Load(VolumeOpening opening, LoadPlan plan, CancellationToken token)
        {
            MemoryForecast forecast = await opening.ForecastAsync(plan.Limits, token, relay);
            token.ThrowIfCancellationRequested();
            Forecast?.Invoke(forecast);
            token.ThrowIfCancellationRequested();
            try
            {
                return await opening.ReadAsync(plan, token, relay);
            }
            catch (OutOfMemoryException e)
            {
                throw new VolumeTooLargeException($"{forecast} Main memory cannot hold it.", e);
            }
        }

        void ShowCoarse(SegmentedVolume volume)
        {
            if (!IsRunning || source.IsCancellationRequested)
                return;
            hasCoarse = true;
            Coarse(volume);
        }
    }
}
