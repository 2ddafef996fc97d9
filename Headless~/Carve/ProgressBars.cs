using System;
using System.IO;
using Spectre.Console;

namespace AnatomyCarve.Headless.Cli
{
    /// <summary>One bar per step of a long command, on the terminal's error stream; nothing where that is no terminal.</summary>
    sealed class ProgressBars
    {
        readonly ProgressContext context;

        ProgressBars(ProgressContext context) => this.context = context;

        /// <summary>Runs <paramref name="work"/> on the calling thread while the bars are shown.</summary>
        public static T Show<T>(TextWriter error, bool wanted, Func<ProgressBars, T> work)
        {
            var console = Terminal.On(error);
            if (!wanted || !console.Profile.Capabilities.Interactive) return work(new ProgressBars(null));
            return console.Progress()
                .AutoClear(true)
                .Columns(new TaskDescriptionColumn { Alignment = Justify.Left }, new ProgressBarColumn(), new PercentageColumn(), new ElapsedTimeColumn())
                .Start(context => work(new ProgressBars(context)));
        }

        /// <summary>Runs one step; it reports its progress as 0 to 1.</summary>
        public T Step<T>(string title, Func<IProgress<float>, T> step)
        {
            var bar = context?.AddTask(Markup.Escape(title), maxValue: 1);
            var result = step(new Bar(bar));
            bar?.Value(1).StopTask();
            return result;
        }

        // Progress<T> would post to the engine's synchronisation context; a bar may be set from any thread.
        sealed class Bar(ProgressTask task) : IProgress<float>
        {
            public void Report(float value) => task?.Value(value);
        }
    }
}
