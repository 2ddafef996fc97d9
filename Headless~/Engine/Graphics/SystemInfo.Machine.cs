using System;
using System.IO;
using System.Runtime.InteropServices;

namespace UnityEngine
{
    public sealed partial class SystemInfo
    {
        /// <summary>Logical processors.</summary>
        public static int processorCount => Environment.ProcessorCount;

        public static string operatingSystem => RuntimeInformation.OSDescription;

        public static string deviceName => Environment.MachineName;

        public static string deviceModel => unsupportedIdentifier;

        /// <summary>MiB; 0 if it cannot be found out.</summary>
        public static int systemMemorySize
        {
            get
            {
                const string file = "/proc/meminfo";
                const string field = "MemTotal:";
                if (!File.Exists(file))
                    return 0;
                foreach (var line in File.ReadLines(file))
                {
                    if (!line.StartsWith(field, StringComparison.Ordinal))
                        continue;
                    var kibibytes = line.Substring(field.Length).Replace("kB", "").Trim();
                    return (int)(long.Parse(kibibytes, System.Globalization.CultureInfo.InvariantCulture) / 1024);
                }
                return 0;
            }
        }
    }
}
