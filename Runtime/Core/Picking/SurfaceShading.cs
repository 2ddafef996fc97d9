using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>Shades a surface of which only distances are known: normals from their slopes, one light from above the viewer's left shoulder.</summary>
    static class SurfaceShading
    {
        const double Ambient = 0.25;
        const double Diffuse = 0.85;

        /// <summary>How many pixels on each side a slope is taken from: fewer show the voxels' steps, more blur what is small.</summary>
        const int Reach = 2;

        /// <summary>A surface that falls steeper than this, in lengths of distance per length of picture, is another one behind an edge.</summary>
        const double SteepestSlope = 8;

        /// <summary>Where the light comes from, as seen in the picture: x right, y up, z towards the viewer.</summary>
        static readonly VectorMm Light = new VectorMm(-0.45, 0.5, 0.74).Normalized();

        /// <summary>How bright a pixel's surface is: a factor for its linear colour, 0 to 1.1.</summary>
        /// <param name="pixelMm">From one pixel to the next.</param>
        internal static double BrightnessAt(SurfaceMap surface, int column, int row, double pixelMm)
        {
            VectorMm normal = NormalAt(surface, column, row, pixelMm);
            return Ambient + (Diffuse * Math.Max(0, normal.Dot(Light) / normal.Length));
        }

        /// <summary>The normal of the plane that fits the distances around a pixel best (least squares), of those that belong to the same surface.</summary>
        static VectorMm NormalAt(SurfaceMap surface, int column, int row, double pixelMm)
        {
            double here = surface.DistanceMmAt(column, row);
            double xx = 0, xy = 0, yy = 0, xd = 0, yd = 0;
            for (int y = -Reach; y <= Reach; y++)
            {
                for (int x = -Reach; x <= Reach; x++)
                {
                    double further = (surface.DistanceMmAt(column + x, row + y) - here) / pixelMm;
                    if (!(Math.Abs(further) <= SteepestSlope * Math.Max(Math.Abs(x), Math.Abs(y))))
                        continue;
                    xx += x * x;
                    xy += x * y;
                    yy += y * y;
                    xd += x * further;
                    yd += y * further;
                }
            }

            // Where pixels lie on one line only, or there are none, the slope across stays unknown: taken for 0.
            double determinant = (xx * yy) - (xy * xy);
            if (determinant == 0)
                return new VectorMm(xx > 0 ? xd / xx : 0, yy > 0 && xx == 0 ? yd / yy : 0, 1);

            // A surface whose distance grows to the right faces right.
            return new VectorMm(((xd * yy) - (yd * xy)) / determinant, ((yd * xx) - (xd * xy)) / determinant, 1);
        }
    }
}
