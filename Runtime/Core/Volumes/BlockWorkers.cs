using System;
using System.Runtime.ExceptionServices;
using System.Threading;
using System.Threading.Tasks;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// Shares numbered pieces of work among the calling thread and a few of the pool's. The caller works too and never waits for a thread that has not
    /// started, so a busy pool costs time but can't block; progress is told on the caller's thread alone.
    /// </summary>
    sealed class BlockWorkers
    {
        /// <summary>Headsets have two or three cores to spare; memory bandwidth ends the gain of more.</summary>
        const int MostThreads = 4;

        readonly object gate = new object();
        readonly Func<Action<int>> makeWorker;
        readonly int count;
        readonly CancellationToken cancellation;
        int next;
        int done;
        int working;
        bool closed;
        ExceptionDispatchInfo failure;

        BlockWorkers(int count, Func<Action<int>> makeWorker, CancellationToken cancellation)
        {
            this.count = count;
            this.makeWorker = makeWorker;
            this.cancellation = cancellation;
        }

        /// <summary>All processors but one, for whoever draws the picture: 1 to 4.</summary>
        internal static int DefaultThreads => Math.Max(1, Math.Min(MostThreads, Environment.ProcessorCount - 1));

        /// <summary>Does all pieces; returns when they are done, and no thread is at work any more.</summary>
        /// <param name="count">Pieces are numbered from 0.</param>
        /// <param name="threads">How many threads work, the caller's included.</param>
        /// <param name="makeWorker">Called once on each of them; what it gives does a piece.</param>
        /// <param name="progress">Told the share done, ascending; may be null.</param>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        internal static void Run(int count, int threads, Func<Action<int>> makeWorker, CancellationToken cancellation, IProgress<float> progress)
        {
            var workers = new BlockWorkers(count, makeWorker, cancellation);
            for (int n = 1; n < Math.Min(threads, count); n++)
                _ = Task.Run(workers.Help, CancellationToken.None);
            workers.Work(progress);
            workers.Finish();
        }

        void Help()
        {
            lock (gate)
            {
                if (closed)
                    return;
                working++;
            }

            Work(null);
            lock (gate)
            {
                working--;
                Monitor.PulseAll(gate);
            }
        }

        /// <summary>Takes pieces until none is left, or something failed; never throws.</summary>
        void Work(IProgress<float> progress)
        {
            try
            {
                Action<int> work = makeWorker();
                for (int piece = Interlocked.Increment(ref next) - 1; piece < count && Volatile.Read(ref failure) == null; piece = Interlocked.Increment(ref next) - 1)
                {
                    cancellation.ThrowIfCancellationRequested();
                    work(piece);
                    int finished = Interlocked.Increment(ref done);
                    progress?.Report((float)finished / count);
                }
            }
            catch (Exception problem)
            {
                // Carried to the caller's thread, where it is thrown again.
                Interlocked.CompareExchange(ref failure, ExceptionDispatchInfo.Capture(problem), null);
            }
        }

        void Finish()
        {
            lock (gate)
            {
                closed = true;
                while (working > 0)
                    Monitor.Wait(gate);
            }

            failure?.Throw();
            cancellation.ThrowIfCancellationRequested();
        }
    }
}
