using System;
using System.IO;
using System.Linq;
using AnatomyCarve.Volumes;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>
    /// A file with an exact camera: {"space": "LPS" or "RAS", "eyeMm": [x, y, z], "targetMm": [x, y, z], "up": [x, y, z], "verticalFovDegrees": a}.
    /// Other fields are left to whoever wrote them.
    /// </summary>
    static class CameraFile
    {
        const double Farthest = 1e9;
        const int LongestFound = 80;

        /// <exception cref="CommandException">The file does not hold such a camera.</exception>
        public static PerspectiveCamera Read(string path)
        {
            JObject camera;
            try
            {
                using var reader = new JsonTextReader(new StreamReader(path)) { DateParseHandling = DateParseHandling.None };
                camera = JObject.Load(reader, new JsonLoadSettings { DuplicatePropertyNameHandling = DuplicatePropertyNameHandling.Error });
                // Text after the camera's end is refused by the reader; it only has to be read.
                while (reader.Read())
                {
                }
            }
            catch (JsonException exception)
            {
                throw new CommandException($"{path}: not a camera in JSON: {exception.Message}");
            }

            var sign = Sign(path, camera);
            var (eye, target, up) = (Triple(path, camera, "eyeMm", " (mm)"), Triple(path, camera, "targetMm", " (mm)"), Triple(path, camera, "up"));
            var fov = camera["verticalFovDegrees"] is { Type: JTokenType.Float or JTokenType.Integer } token && (double)token is > 0 and < 180
                ? (double)token
                : throw Unexpected(path, camera, "verticalFovDegrees", "an angle between 0 and 180 degrees");
            var exact = new PerspectiveCamera(
                new PointMm(sign * eye[0], sign * eye[1], eye[2]),
                new PointMm(sign * target[0], sign * target[1], target[2]),
                new VectorMm(sign * up[0], sign * up[1], up[2]),
                fov);
            Check(path, camera, exact);
            return exact;
        }

        static void Check(string path, JObject file, PerspectiveCamera camera)
        {
            var view = camera.TargetLps - camera.EyeLps;
            if (view.Length == 0) throw new CommandException($"{path}: \"eyeMm\" and \"targetMm\" are the same point, {Found(file, "eyeMm")}.");
            if (view.Cross(camera.UpLps).Length <= 1e-9 * view.Length * camera.UpLps.Length)
            {
                throw Unexpected(path, file, "up", "a direction other than zero and the line of sight");
            }
        }

        static int Sign(string path, JObject camera) => (camera["space"] as JValue)?.Value switch
        {
            "LPS" => 1,
            "RAS" => -1,
            _ => throw Unexpected(path, camera, "space", "\"LPS\" or \"RAS\""),
        };

        static double[] Triple(string path, JObject camera, string field, string unit = "")
        {
            if (camera[field] is JArray { Count: 3 } array && array.All(item => item.Type is JTokenType.Float or JTokenType.Integer))
            {
                var numbers = array.Select(item => (double)item).ToArray();
                if (numbers.All(number => Math.Abs(number) <= Farthest)) return numbers;
            }

            throw Unexpected(path, camera, field, $"a list of three numbers from -1e9 to 1e9{unit}");
        }

        static CommandException Unexpected(string path, JObject camera, string field, string expected) =>
            new($"{path}: \"{field}\" is {Found(camera, field)}; expected {expected}.");

        static string Found(JObject camera, string field)
        {
            if (camera[field] is not { } token) return "missing";
            var text = token.ToString(Formatting.None);
            return text.Length <= LongestFound ? text : text[..LongestFound] + "...";
        }
    }
}
