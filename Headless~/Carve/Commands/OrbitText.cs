using System;
using System.Globalization;
using System.Linq;
using AnatomyCarve.Picking;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>An orbit's angles as the user writes them: AZIMUTH,ELEVATION[,FOV] in degrees.</summary>
    static class OrbitText
    {
        /// <summary>The camera, or null and what is wrong with the angles; null and null if the text is something else.</summary>
        public static (OrbitCamera Camera, string Problem) Read(string text)
        {
            var numbers = text.Split(',').Select(word => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out var number)
                ? number : double.NaN).ToArray();
            if (numbers.Length is not (2 or 3) || !numbers.All(double.IsFinite)) return default;
            try
            {
                return (new OrbitCamera(numbers[0], numbers[1], numbers.Length == 3 ? numbers[2] : OrbitCamera.DefaultFovDegrees), null);
            }
            catch (ArgumentOutOfRangeException exception)
            {
                // The first sentence, which has the range; what follows is the parameter and its value.
                return (null, exception.Message[..(exception.Message.IndexOf('.', StringComparison.Ordinal) + 1)]);
            }
        }
    }
}
