using System;

namespace AnatomyCarve.Headless.Cli.Files
{
    /// <summary>One value per pixel, the first row on top, left to right.</summary>
    sealed record Plane<T>(int Width, int Height, T[] Values);

    /// <summary>A picture's file can't be read; the message is one line that names it.</summary>
    sealed class PictureFileException(string path, string reason) : Exception($"{path}: {reason}.");
}
