using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.DemoData
{
    /// <summary>The demo's carving, camera and transfer function.</summary>
    static class DemoScene
    {
        static readonly string[] Protected = ["Hippocampus", "Amygdala", "Thalamus", "Caudate", "Putamen", "Pallidum", "Insula"];

        sealed record Sphere(PointMm CentreLps, double RadiusMm, Func<string, bool> Clips);

        static readonly Sphere[] Spheres =
        [
            // Skin and skull over the upper left: the brain stands whole in the opening.
            new(new PointMm(40, -12, 72), 86, IsHead),
            // The left cortex and what lies under it, as far as the deep grey matter and the insula, which stay.
            new(new PointMm(57, 9, 18), 50, name => IsHead(name) || IsBrainOther(name) || (IsLeft(name) && !IsCerebellum(name) && !IsProtected(name))),
            // Skin and skull over the left cerebellum.
            new(new PointMm(54, 80, -30), 34, IsHead),
            // A piece of the cerebellum itself.
            new(new PointMm(50, 66, -34), 17, name => IsHead(name) || IsBrainOther(name) || IsCerebellum(name)),
        ];

        const string Camera = """
            {
              "space": "LPS",
              "eyeMm": [608, 5, 155],
              "targetMm": [0, 17, -7],
              "up": [0, 0, 1],
              "verticalFovDegrees": 23
            }

            """;

        // 3D Slicer's volume property: interpolation, shading (on, diffuse, ambient, specular, power), then opacity by value, opacity by
        // gradient, colour by value. Air is 0, bone below 30, fluid below 45, grey matter 60 to 90, white matter to 120, skin and fat above.
        const string VolumeProperty = """
            1
            1
            0.75
            0.25
            0.2
            24
            6 0 0 40 0 65 1
            4 0 1 255 1
            8 0 0 0 0 255 1 1 1

            """;

        public static void Write(string folder, SegmentTable segments)
        {
            var spheres = Spheres.Select(sphere => new CarvingDocumentSphere(sphere.CentreLps, sphere.RadiusMm, Clipped(sphere, segments)));
            CarvingFile.Write(new CarvingDocument(spheres), Path.Combine(folder, "demo.carving.json"));
            File.WriteAllText(Path.Combine(folder, "demo.camera.json"), Camera.ReplaceLineEndings("\n"));
            File.WriteAllText(Path.Combine(folder, "Colin27.vp"), VolumeProperty.ReplaceLineEndings("\n"));
        }

        static IEnumerable<SegmentReference> Clipped(Sphere sphere, SegmentTable segments) => segments
            .Where(segment => segment.Index > 0 && sphere.Clips(segment.Name))
            .Select(segment => new SegmentReference(segment.Label, segment.Name));

        static bool IsHead(string name) => name == "head";

        static bool IsBrainOther(string name) => name == "brain, other";

        static bool IsLeft(string name) => name.EndsWith("_L", StringComparison.Ordinal);

        static bool IsCerebellum(string name) =>
            name.StartsWith("Cerebelum", StringComparison.Ordinal) || name.StartsWith("Vermis", StringComparison.Ordinal);

        static bool IsProtected(string name) => Protected.Any(start => name.StartsWith(start, StringComparison.Ordinal));
    }
}
