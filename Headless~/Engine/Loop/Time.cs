using System.Diagnostics;

namespace UnityEngine
{
    /// <summary>The frame's time, in seconds. Main thread only.</summary>
    public class Time
    {
        const double DefaultFixedStep = 0.02;

        static readonly Stopwatch s_Real = Stopwatch.StartNew();

        static double s_Time;
        static double s_Unscaled;
        static double s_Fixed;
        static double s_FixedUnscaled;
        static float s_Delta;
        static float s_UnscaledDelta;
        static float s_FixedStep = (float)DefaultFixedStep;
        static float s_MaximumDelta = 1f / 3f;
        static float s_Scale = 1f;
        static int s_Frame;
        static bool s_InFixedStep;

        public static float time => (float)timeAsDouble;

        public static double timeAsDouble
        {
            get { MainThread.Check("get_time"); return s_InFixedStep ? s_Fixed : s_Time; }
        }

        public static float timeSinceLevelLoad => time;

        public static double timeSinceLevelLoadAsDouble => timeAsDouble;

        /// <summary>Seconds since the last frame; inside FixedUpdate the fixed step.</summary>
        public static float deltaTime
        {
            get { MainThread.Check("get_deltaTime"); return s_InFixedStep ? s_FixedStep : s_Delta; }
        }

        public static float smoothDeltaTime => deltaTime;

        public static float unscaledTime => (float)unscaledTimeAsDouble;

        public static double unscaledTimeAsDouble
        {
            get { MainThread.Check("get_unscaledTime"); return s_InFixedStep ? s_FixedUnscaled : s_Unscaled; }
        }

        public static float unscaledDeltaTime
        {
            get { MainThread.Check("get_unscaledDeltaTime"); return s_InFixedStep ? s_FixedStep : s_UnscaledDelta; }
        }

        public static float fixedTime => (float)fixedTimeAsDouble;

        public static double fixedTimeAsDouble
        {
            get { MainThread.Check("get_fixedTime"); return s_Fixed; }
        }

        public static float fixedDeltaTime
        {
            get { MainThread.Check("get_fixedDeltaTime"); return s_FixedStep; }
            set { MainThread.Check("set_fixedDeltaTime"); s_FixedStep = Mathf.Clamp(value, 0.0001f, 10f); }
        }

        /// <summary>Longer frames count as this long.</summary>
        public static float maximumDeltaTime
        {
            get { MainThread.Check("get_maximumDeltaTime"); return s_MaximumDelta; }
            set { MainThread.Check("set_maximumDeltaTime"); s_MaximumDelta = Mathf.Max(value, s_FixedStep); }
        }

        public static float timeScale
        {
            get { MainThread.Check("get_timeScale"); return s_Scale; }
            set
            {
                MainThread.Check("set_timeScale");
                if (value is < 0f or > 100f)
                    Debug.LogError("Time.timeScale is out of range. The value has to be between 0.0 and 100.0.");
                else
                    s_Scale = value;
            }
        }

        public static int frameCount
        {
            get { MainThread.Check("get_frameCount"); return s_Frame; }
        }

        public static int renderedFrameCount => frameCount;

        public static bool inFixedTimeStep
        {
            get { MainThread.Check("get_inFixedTimeStep"); return s_InFixedStep; }
        }

        public static float realtimeSinceStartup => (float)realtimeSinceStartupAsDouble;

        public static double realtimeSinceStartupAsDouble
        {
            get { MainThread.Check("get_realtimeSinceStartup"); return s_Real.Elapsed.TotalSeconds; }
        }

        internal static void Reset()
        {
            s_Time = s_Unscaled = s_Fixed = s_FixedUnscaled = 0.0;
            s_Delta = s_UnscaledDelta = 0f;
            s_FixedStep = (float)DefaultFixedStep;
            s_MaximumDelta = 1f / 3f;
            s_Scale = 1f;
            s_Frame = 0;
            s_InFixedStep = false;
            s_Real.Restart();
        }

        internal static void BeginFrame(float seconds)
        {
            s_Frame++;
            s_UnscaledDelta = seconds;
            s_Unscaled += seconds;
            s_Delta = Mathf.Min(seconds, s_MaximumDelta) * s_Scale;
            s_Time += s_Delta;
        }

        /// <summary>Enters the next fixed step, if the frame's time has one left.</summary>
        internal static bool EnterFixedStep()
        {
            if (s_Fixed + s_FixedStep > s_Time)
            {
                s_InFixedStep = false;
                return false;
            }

            s_Fixed += s_FixedStep;
            s_FixedUnscaled += s_Scale > 0f ? s_FixedStep / s_Scale : s_FixedStep;
            s_InFixedStep = true;
            return true;
        }
    }
}
