using System;
using System.IO;
using Spectre.Console;

namespace AnatomyCarve.Headless.Cli
{
    /// <summary>Tables for people and progress bars, on whatever the command writes to.</summary>
    static class Terminal
    {
        const int WidthWhenNoTerminal = 160;

        /// <summary>A console on a writer; colours and moving bars only where the writer is a terminal.</summary>
        public static IAnsiConsole On(TextWriter writer)
        {
            var isOutput = ReferenceEquals(writer, Console.Out) && !Console.IsOutputRedirected;
            var isError = ReferenceEquals(writer, Console.Error) && !Console.IsErrorRedirected;
            var isTerminal = isOutput || isError;
            var console = AnsiConsole.Create(new AnsiConsoleSettings
            {
                Ansi = isTerminal ? AnsiSupport.Detect : AnsiSupport.No,
                ColorSystem = isTerminal ? ColorSystemSupport.Detect : ColorSystemSupport.NoColors,
                Interactive = isTerminal ? InteractionSupport.Detect : InteractionSupport.No,
                Out = new AnsiConsoleOutput(writer),
            });
            if (!isTerminal) console.Profile.Width = WidthWhenNoTerminal;
            return console;
        }

        /// <summary>A table with a title row, its cells taken literally.</summary>
        public static void WriteTable(TextWriter writer, string[] titles, params string[][] rows)
        {
            var table = new Table().Border(TableBorder.Rounded);
            foreach (var title in titles) table.AddColumn(Markup.Escape(title));
            foreach (var row in rows) table.AddRow(Array.ConvertAll(row, Markup.Escape));
            On(writer).Write(table);
        }
    }
}
