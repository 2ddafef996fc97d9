using System;

namespace UnityEngine
{
    /// <summary>Random numbers from one seeded sequence (xorshift128). Not Unity's exact sequence. Main thread only.</summary>
    public static class Random
    {
        static uint s_X = 123456789;
        static uint s_Y = 362436069;
        static uint s_Z = 521288629;
        static uint s_W = 88675123;

        /// <summary>From 0 to 1, both included.</summary>
        public static float value
        {
            get { MainThread.Check("get_value"); return Next01(); }
        }

        public static Vector3 onUnitSphere
        {
            get
            {
                float z = Range(-1f, 1f), angle = Range(0f, 2f * Mathf.PI), r = Mathf.Sqrt(1f - z * z);
                return new Vector3(r * Mathf.Cos(angle), r * Mathf.Sin(angle), z);
            }
        }

        public static Vector3 insideUnitSphere => onUnitSphere * Mathf.Pow(value, 1f / 3f);

        public static Vector2 insideUnitCircle
        {
            get
            {
                float angle = Range(0f, 2f * Mathf.PI), r = Mathf.Sqrt(value);
                return new Vector2(r * Mathf.Cos(angle), r * Mathf.Sin(angle));
            }
        }

        public static Quaternion rotation => Quaternion.AngleAxis(Range(0f, 360f), onUnitSphere);

        public static void InitState(int seed)
        {
            MainThread.Check("InitState");
            s_X = (uint)seed;
            s_Y = s_X * 1812433253u + 1;
            s_Z = s_Y * 1812433253u + 1;
            s_W = s_Z * 1812433253u + 1;
        }

        /// <summary>From the minimum to the maximum, both included.</summary>
        public static float Range(float minInclusive, float maxInclusive)
        {
            MainThread.Check("Range");
            return minInclusive + (maxInclusive - minInclusive) * Next01();
        }

        /// <summary>From the minimum to just below the maximum.</summary>
        public static int Range(int minInclusive, int maxExclusive)
        {
            MainThread.Check("RandomRangeInt");
            var span = (long)maxExclusive - minInclusive;
            if (span == 0)
                return minInclusive;
            return (int)(minInclusive + Math.Sign(span) * (Next() % Math.Abs(span)));
        }

        static float Next01() => (Next() & 0x7FFFFF) / 8388607f;

        static uint Next()
        {
            var t = s_X ^ (s_X << 11);
            s_X = s_Y;
            s_Y = s_Z;
            s_Z = s_W;
            return s_W = s_W ^ (s_W >> 19) ^ t ^ (t >> 8);
        }
    }
}
