using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;
using AnatomyCarve.Headless.Cli.Files;
using AnatomyCarve.Headless.Tests.CommandLine;
using AnatomyCarve.Metrics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Tests.Golden
{
    /// <summary>
    /// The pictures that are kept, a folder for each driver and version beside this file. Each folder's figures.json has the limits and what was last seen.
    /// ANATOMYCARVE_GOLDEN=write makes the pictures of the driver at hand anew; ANATOMYCARVE_GOLDEN=note keeps them and writes down the figures.
    /// </summary>
    sealed class GoldenStore
    {
        /// <summary>PSNR is infinite where no byte differs; files say this instead.</summary>
        const double Identical = 999;

        static readonly JsonSerializerOptions Format = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

        readonly string folder;
        readonly string mode = Environment.GetEnvironmentVariable("ANATOMYCARVE_GOLDEN") ?? "";
        readonly FigureFile figures;

        public GoldenStore(string driver)
        {
            folder = Path.Combine(Home, driver);
            IsSameDriver = IsWriting || File.Exists(FiguresPath);
            if (!IsSameDriver)
                folder = Directory.GetDirectories(Home).OrderBy(Sortable, StringComparer.Ordinal).LastOrDefault();
            figures = HasGoldens && File.Exists(FiguresPath) ? JsonSerializer.Deserialize<FigureFile>(File.ReadAllText(FiguresPath), Format) : new FigureFile();
        }

        public bool IsWriting => mode == "write";

        public bool IsSameDriver { get; }

        public bool HasGoldens => folder != null;

        public double LimitDecibels => IsSameDriver ? figures.LimitOnThisDriver : figures.LimitOnOtherDrivers;

        /// <summary>The name of a driver and its version as the host reports them, fit for a folder.</summary>
        public static string DriverName(string device, string version) => Regex.Replace($"{device} {version}", "[^A-Za-z0-9.]+", "-").Trim('-');

        static string Home => Path.Combine(RepositoryFiles.Root, "Headless~", "Tests", "Golden");

        static string Out => Path.Combine(RepositoryFiles.Root, "Headless~", "out", "golden");

        string FiguresPath => Path.Combine(folder, "figures.json");

        public void Write(string scene, byte[] png)
        {
            Directory.CreateDirectory(folder);
            File.WriteAllBytes(PathOf(scene), png);
            Note(scene, Identical);
        }

        /// <summary>
        /// PSNR of a picture against the golden one. Where it is below the limit, the picture and what differs are written to Headless~/out/golden.
        /// </summary>
        public double Compare(string scene, byte[] png)
        {
            Directory.CreateDirectory(Out);
            string actual = Path.Combine(Out, scene + ".actual.png"), difference = Path.Combine(Out, scene + ".difference.png");
            File.Delete(difference);
            File.WriteAllBytes(actual, png);
            Plane<byte> a = PngFile.ReadRgb(actual), golden = PngFile.ReadRgb(PathOf(scene));
            double decibels = (a.Width, a.Height) == (golden.Width, golden.Height) ? PictureMetrics.Psnr(a.Values, golden.Values) : 0;
            if (decibels >= LimitDecibels)
                File.Delete(actual);
            else if (decibels > 0)
                File.WriteAllBytes(difference, Difference(a, golden));
            if (mode == "note" && IsSameDriver)
                Note(scene, Math.Min(Identical, Math.Round(decibels, 1)));
            return decibels;
        }

        /// <summary>The figure that was last written down, in dB; 999 = not a byte differed.</summary>
        public double LastFigure(string scene) => figures.Last.GetValueOrDefault(scene, double.NaN);

        string PathOf(string scene) => Path.Combine(folder, scene + ".png");

        void Note(string scene, double decibels)
        {
            figures.Last[scene] = decibels;
            File.WriteAllText(FiguresPath, JsonSerializer.Serialize(figures, Format) + "\n");
        }

        /// <summary>Numbers with leading zeros, so that version 19 comes after version 9.</summary>
        static string Sortable(string path) => Regex.Replace(Path.GetFileName(path), "[0-9]+", number => number.Value.PadLeft(12, '0'));

        /// <summary>Ten times what differs, channel by channel.</summary>
        static byte[] Difference(Plane<byte> a, Plane<byte> b)
        {
            var rgba = new byte[a.Values.Length / 3 * 4];
            for (int p = 0; p < rgba.Length / 4; p++)
            {
                int row = a.Height - 1 - p / (a.Width / 3), from = row * a.Width + p % (a.Width / 3) * 3; // pictures begin below, files above
                for (int c = 0; c < 3; c++)
                    rgba[4 * p + c] = (byte)Math.Min(255, 10 * Math.Abs(a.Values[from + c] - b.Values[from + c]));
                rgba[4 * p + 3] = 255;
            }
            return ImageConversion.EncodeArrayToPNG(rgba, GraphicsFormat.R8G8B8A8_SRGB, (uint)(a.Width / 3), (uint)a.Height);
        }

        /// <summary>Limits and last figures of a folder, PSNR in dB.</summary>
        sealed class FigureFile
        {
            public double LimitOnThisDriver { get; set; } = 50;

            public double LimitOnOtherDrivers { get; set; } = 40;

            public SortedDictionary<string, double> Last { get; set; } = new(StringComparer.Ordinal);
        }
    }
}
