using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>What a rendering is made of and where it goes; null where the user left something out.</summary>
    sealed record RenderRequest
    {
        public string VolumePath { get; init; }

        /// <summary>Instead of files.</summary>
        public PhantomSize? Phantom { get; init; }

        /// <summary>MiB on the GPU; 0 = as the device says.</summary>
        public int BudgetMiB { get; init; }

        public string LabelsPath { get; init; }

        public string TransferFunctionText { get; init; }

        public string CarvingPath { get; init; }

        /// <summary>As the user gave it: a file or angles.</summary>
        public string CameraText { get; init; }

        public required PictureSize Size { get; init; }

        public required string QualityName { get; init; }

        public CutMode? Cut { get; init; }

        public float? AntiAliasing { get; init; }

        public required SegmentColor Background { get; init; }

        public required string OutputPath { get; init; }

        public string DepthPath { get; init; }

        public string SegmentsPath { get; init; }

        public string ReportPath { get; init; }

        /// <summary>What a camera draws.</summary>
        public string DrawnPath { get; init; }

        public string DrawnDepthPath { get; init; }

        public bool IsDrawn => DrawnPath != null || DrawnDepthPath != null;

        /// <summary>The Unity project that is pretended.</summary>
        public RenderProject Project { get; init; } = new();

        public IEnumerable<string> InputPaths => new[] { VolumePath, LabelsPath, CarvingPath }.Where(path => path != null);

        public IEnumerable<string> OutputPaths => new[] { OutputPath, DepthPath, SegmentsPath, ReportPath, DrawnPath, DrawnDepthPath }
            .Where(path => path != null);
    }
}
