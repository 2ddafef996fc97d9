using System;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>carve render: its options.</summary>
    static class RenderCommand
    {
        const string DefaultCamera = "30,15";

        public static Command Create()
        {
            var volume = new Argument<string>("VOLUME")
            {
                Description = "The intensities, CT or MRI: .nii, .nii.gz or .nrrd. Or --phantom.",
                Arity = ArgumentArity.ZeroOrOne,
            };
            var phantom = PhantomSize.Option();
            var labels =
                FileOption("--labels", "The segmentation on the same grid: .seg.nrrd, .nrrd, .nii or .nii.gz. Without it all is one unlabelled segment.");
            var transfer = new Option<string>("--tf")
            {
                HelpName = "FILE|value:opacity,...|PRESET",
                Description = "The opacity of intensities: a volume property file of 3D Slicer (.vp), or points with straight lines between them, "
                    + "such as \"-200:0,100:0,300:0.9\", or one of the package's presets, such as CT-Bone (a wrong name lists them). "
                    + "Opacity is per smallest voxel spacing. Without it: chosen from the values.",
            };
            var carving = FileOption("--carving", "The clip spheres, as ClipSphereStack saves them (JSON). Without it nothing is carved.");
            var camera = new Option<string>("--camera")
            {
                HelpName = "FILE|AZIMUTH,ELEVATION[,FOV]",
                DefaultValueFactory = _ => DefaultCamera,
                Description = "Where to look from. Degrees on an orbit around the volume, as near as shows all of it: 0,0 is in front of the face, 90,0 at the "
                    + "patient's left, 0,90 above; FOV is the vertical field of view (30). Or exactly, by a JSON file: {\"space\": \"LPS\" or \"RAS\", "
                    + "\"eyeMm\": [x, y, z], \"targetMm\": [x, y, z], \"up\": [x, y, z], \"verticalFovDegrees\": a}.",
            };
            camera.Validators.Add(CheckCamera);
            var size = new Option<PictureSize>("--size")
            {
                HelpName = "WIDTHxHEIGHT",
                CustomParser = PictureSize.Parse,
                DefaultValueFactory = _ => new PictureSize(512, 512),
                Description = "The picture's size in (square) pixels.",
            };
            var quality = new Option<string>("--quality")
            {
                DefaultValueFactory = _ => "balanced",
                Description =
                    "How finely rays are sampled, cuts smoothed and opacity filtered. " + string.Join("; ", RenderQuality.Names.Select(Describe)) + "; "
                    + "a step is counted in smallest voxel spacings. Balanced, the default, cuts whole voxels, exactly by Eq. 1 (binary); best lets cuts go "
                    + "through voxels (smooth), the demo is rendered with it.",
            };
            quality.AcceptOnlyFromAmong(RenderQuality.Names);
            var cut = new Option<string>("--cut")
            {
                Description = "Cut whole voxels (binary), or let a cut go through them (smooth). Without it as the quality has it.",
            };
            cut.AcceptOnlyFromAmong("binary", "smooth");
            var antiAliasing = new Option<float?>("--anti-aliasing")
            {
                HelpName = "0..1",
                CustomParser = ParseShare,
                Description = "How much of the 3D anti-aliasing of cuts is applied, from 0 (none) to 1. Without it as the quality has it.",
            };
            var background = new Option<SegmentColor>("--background")
            {
                HelpName = "#RRGGBB",
                CustomParser = ParseColor,
                DefaultValueFactory = _ => new SegmentColor(0x16, 0x18, 0x1C),
                Description = "The sRGB colour behind the volume.",
            };
            var output = FileOption("--output", "The picture to write: PNG, sRGB, 8 bits, the top row first.", ".png");
            output.Required = true;
            var depth = FileOption("--depth",
                "Also write the depth of the first visible segment: PFM (little-endian floats, the lowest row first, as that format "
                + "has it), millimetres along each pixel's ray from the eye, infinity where nothing is visible.", ".pfm");
            var segments = FileOption("--segments", "Also write the first visible segment: PGM, 16 bits, the top row first, the segment's dense index (see the "
                + "report), 65535 where nothing is visible.", ".pgm");
            var report = FileOption("--report",
                "Also write a report: visible pixels of each segment, voxels and samples of each stage, memory, times, device (JSON).", ".json");
            var budget = new Option<int>("--budget")
            {
                HelpName = "MIB",
                Description = "What the volume may take on the GPU; it is made coarser until it fits, with a warning. 0, the default: what the device says.",
            };
            budget.Validators.Add(result =>
            {
                if (result.GetValue(budget) < 0) result.AddError("--budget: expected 0 or more MiB.");
            });
            var drawn = new DrawnOptions();
            var noProgress = new Option<bool>("--no-progress") { Description = "No progress bars." };

            var command = new Command("render", "Renders a volume, carved, to a PNG. Files are written when all of it is done, or not at all.")
            {
                volume, labels, transfer, carving, camera, size, quality, cut, antiAliasing, background, output, depth, segments, report, phantom, budget,
                noProgress,
            };
            drawn.AddTo(command);
            command.Validators.Add(result =>
            {
                var isPhantom = result.GetResult(phantom) != null;
                if (result.GetValue(volume) == null == !isPhantom) result.AddError("render: expected either a VOLUME or --phantom.");
                if (isPhantom && result.GetValue(labels) != null) result.AddError("--labels: the phantom has its own.");
            });
            command.SetAction((parsed, cancellation) =>
            {
                var request = new RenderRequest
                {
                    VolumePath = parsed.GetValue(volume),
                    Phantom = parsed.GetValue(phantom),
                    BudgetMiB = parsed.GetValue(budget),
                    LabelsPath = parsed.GetValue(labels),
                    TransferFunctionText = parsed.GetValue(transfer),
                    CarvingPath = parsed.GetValue(carving),
                    CameraText = parsed.GetValue(camera),
                    Size = parsed.GetValue(size),
                    QualityName = parsed.GetValue(quality),
                    Cut = parsed.GetValue(cut) switch { "binary" => CutMode.Binary, "smooth" => CutMode.Smooth, _ => null },
                    AntiAliasing = parsed.GetValue(antiAliasing),
                    Background = parsed.GetValue(background),
                    OutputPath = parsed.GetValue(output),
                    DepthPath = parsed.GetValue(depth),
                    SegmentsPath = parsed.GetValue(segments),
                    ReportPath = parsed.GetValue(report),
                    DrawnPath = parsed.GetValue(drawn.Picture),
                    DrawnDepthPath = parsed.GetValue(drawn.Depth),
                    Project = drawn.Project(parsed, parsed.GetValue(size)),
                };
                var configuration = parsed.InvocationConfiguration;
                RenderJob.Run(request, configuration.Output, configuration.Error, !parsed.GetValue(noProgress), cancellation);
                return Task.FromResult(0);
            });
            return command;
        }

        internal static Option<string> FileOption(string name, string description, string extension = null)
        {
            var option = new Option<string>(name) { HelpName = "FILE", Description = description };
            if (extension == null) return option;
            option.Validators.Add(result =>
            {
                var path = result.GetValueOrDefault<string>();
                if (!string.Equals(Path.GetExtension(path), extension, StringComparison.OrdinalIgnoreCase))
                {
                    result.AddError($"{name} \"{path}\": expected a name that ends in {extension}.");
                }
            });
            return option;
        }

        static string Describe(string preset)
        {
            var quality = RenderQuality.Named(preset);
            return string.Create(CultureInfo.InvariantCulture,
                $"{preset}: step {quality.Step}, {quality.CutMode.ToString().ToLowerInvariant()} cuts, {quality.Filter.ToString().ToLowerInvariant()} filter");
        }

        static void CheckCamera(OptionResult result)
        {
            var text = result.GetValueOrDefault<string>();
            if (File.Exists(text)) return;
            if (Directory.Exists(text))
            {
                result.AddError($"--camera \"{text}\": this is a folder, not a file to read.");
                return;
            }

            var (orbit, problem) = OrbitText.Read(text);
            if (problem != null) result.AddError($"--camera \"{text}\": {problem}");
            else if (orbit == null && !text.EndsWith(".json", StringComparison.OrdinalIgnoreCase))
            {
                result.AddError($"--camera \"{text}\": neither a file nor AZIMUTH,ELEVATION[,FOV] in degrees.");
            }
        }

        static float? ParseShare(ArgumentResult result)
        {
            var text = result.Tokens[0].Value;
            if (float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var share) && share is >= 0 and <= 1) return share;
            result.AddError($"--anti-aliasing \"{text}\": expected a number from 0 to 1.");
            return default;
        }

        static SegmentColor ParseColor(ArgumentResult result)
        {
            var text = result.Tokens[0].Value;
            if (text.Length == 7 && text[0] == '#'
                && uint.TryParse(text.AsSpan(1), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var rgb))
            {
                return new SegmentColor((byte)(rgb >> 16), (byte)(rgb >> 8), (byte)rgb);
            }

            result.AddError($"--background \"{text}\": expected a colour such as #202428.");
            return default;
        }
    }
}
