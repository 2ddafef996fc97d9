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
        /// <exception cref="CommandException">The file does not hold such a camera.</exception>
        public static PerspectiveCamera Read(string path)
        {
            JObject camera;
            try
            {
                using var reader = new JsonTextReader(new StreamReader(path)) { DateParseHandling = DateParseHandling.None };
                camera = JObject.Load(reader, new JsonLoadSettings { DuplicatePropertyNameHandling = DuplicatePropertyNameHandling.Error });
            }
            catch (JsonException exception)
            {
                throw new CommandException($"{path}: not a camera in JSON: {exception.Message}");
            }

            var sign = camera["space"]?.Type == JTokenType.String ? SignOf(path, (string)camera["space"]) : throw Missing(path, "space", "\"LPS\" or \"RAS\"");
            var (eye, target, up) = (Triple(path, camera, "eyeMm"), Triple(path, camera, "targetMm"), Triple(path, camera, "up"));
            var fov = camera["verticalFovDegrees"] is { Type: JTokenType.Float or JTokenType.Integer } token
                ? (double)token
                : throw Missing(path, "verticalFovDegrees", "a number");
            var exact = new PerspectiveCamera(
                new PointMm(sign * eye[0], sign * eye[1], eye[2]),
                new PointMm(sign * target[0], sign * target[1], target[2]),
                new VectorMm(sign * up[0], sign * up[1], up[2]),
                fov);
            Check(path, exact);
            return exact;
        }

        static void Check(string path, PerspectiveCamera camera)
        {
            if (camera.VerticalFovDegrees is not (> 0 and < 180)) throw Missing(path, "verticalFovDegrees", "an angle between 0 and 180 degrees");
            var view = camera.TargetLps - camera.EyeLps;
            if (view.Length == 0) throw new CommandException($"{path}: \"eyeMm\" and \"targetMm\" are the same point.");
            if (view.Cross(camera.UpLps).Length <= 1e-9 * view.Length * camera.UpLps.Length)
            {
                throw new CommandException($"{path}: \"up\" is zero or points along the line of sight.");
            }
        }

        static int SignOf(string path, string space) => space switch
        {
            "LPS" => 1,
            "RAS" => -1,
            _ => throw Missing(path, "space", "\"LPS\" or \"RAS\""),
        };

        static double[] Triple(string path, JObject camera, string field)
        {
            if (camera[field] is JArray { Count: 3 } array && array.All(item => item.Type is JTokenType.Float or JTokenType.Integer))
            {
                var numbers = array.Select(item => (double)item).ToArray();
                if (numbers.All(double.IsFinite)) return numbers;
            }

            throw Missing(path, field, "a list of three finite numbers");
        }

        static CommandException Missing(string path, string field, string expected) =>
            new($"{path}: \"{field}\" must be {expected}.");
    }
}
