using System;
using System.IO;
using System.Text;

namespace AnatomyCarve.Editor
{
    /// <summary>Looks into the header of an NRRD file for what says that it is a segmentation.</summary>
    static class NrrdHeaderPeek
    {
        const string Magic = "NRRD";

        /// <summary>How 3D Slicer begins what it writes of a first segment.</summary>
        const string FirstSegment = "Segment0_";

        /// <summary>More header than this is none.</summary>
        const int MaximumLines = 1 << 20;

        /// <summary>Whether the file is an NRRD with named segments. A file that cannot be read is not; whoever imports it says why.</summary>
        public static bool HasSegments(string path)
        {
            try
            {
                using (var reader = new StreamReader(path, Encoding.UTF8))
                {
                    string line = reader.ReadLine();
                    if (line == null || !line.StartsWith(Magic, StringComparison.Ordinal))
                        return false;
                    for (int n = 0; n < MaximumLines && !string.IsNullOrEmpty(line); n++, line = reader.ReadLine())
                    {
                        if (line.StartsWith(FirstSegment, StringComparison.Ordinal))
                            return true;
                    }
                }
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                return false;
            }

            return false;
        }
    }
}
