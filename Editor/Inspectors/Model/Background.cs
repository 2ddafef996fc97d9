using System;
using System.Threading;
using System.Threading.Tasks;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Something that is computed from a large object on another thread, so that an Inspector does not stand still meanwhile. Only the newest source's
    /// result is kept.
    /// </summary>
    sealed class Background<TSource, TResult> where TSource : class where TResult : class
    {
        readonly Func<TSource, TResult> compute;
        TSource source;
        Task<TResult> task;

        /// <param name="compute">Runs on any thread.</param>
        public Background(Func<TSource, TResult> compute) => this.compute = compute;

        /// <summary>Whether a result is on its way.</summary>
        public bool IsBusy => task != null && !task.IsCompleted;

        /// <summary>The result for a source; null while it is computed, and where there is no source.</summary>
        /// <exception cref="AggregateException">The computation failed.</exception>
        public TResult Of(TSource wanted)
        {
            if (!ReferenceEquals(wanted, source))
            {
                source = wanted;
                task = wanted == null ? null : Task.Factory.StartNew(
                    () => compute(wanted), CancellationToken.None, TaskCreationOptions.DenyChildAttach, TaskScheduler.Default);
            }
            return task != null && task.IsCompleted ? task.Result : null;
        }
    }
}
