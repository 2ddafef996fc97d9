using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>Values of curves.</summary>
    static class CurveMath
    {
        const float DefaultWeight = 1f / 3f;

        internal static float Evaluate(IReadOnlyList<Keyframe> keys, float time, WrapMode before, WrapMode after)
        {
            if (keys.Count == 0)
                return 0f;
            var (first, last) = (keys[0].time, keys[keys.Count - 1].time);
            if (time < first)
                time = Wrap(time, first, last, before);
            else if (time > last)
                time = Wrap(time, first, last, after);
            if (time <= first)
                return keys[0].value;
            var next = 1;
            while (next < keys.Count && keys[next].time <= time)
                next++;
            return next < keys.Count ? Between(keys[next - 1], keys[next], time) : keys[keys.Count - 1].value;
        }

        static float Wrap(float time, float first, float last, WrapMode mode) => mode switch
        {
            WrapMode.Loop when last > first => first + Mathf.Repeat(time - first, last - first),
            WrapMode.PingPong when last > first => first + Mathf.PingPong(time - first, last - first),
            _ => Mathf.Clamp(time, first, last),
        };

        static float Between(Keyframe a, Keyframe b, float time)
        {
            if (float.IsInfinity(a.outTangent) || float.IsInfinity(b.inTangent))
                return a.value;
            var length = b.time - a.time;
            var isWeighted = (a.weightedMode & WeightedMode.Out) != 0 || (b.weightedMode & WeightedMode.In) != 0;
            var t = (time - a.time) / length;
            var left = (a.weightedMode & WeightedMode.Out) != 0 ? a.outWeight : DefaultWeight;
            var right = (b.weightedMode & WeightedMode.In) != 0 ? b.inWeight : DefaultWeight;
            // A cubic Bezier curve whose times are even without weights.
            if (isWeighted)
                t = Solve(t, left, 1f - right);
            return Bezier(t, a.value, a.value + a.outTangent * left * length, b.value - b.inTangent * right * length, b.value);
        }

        /// <summary>Where the Bezier curve through 0, p1, p2, 1 has the value x; it rises.</summary>
        static float Solve(float x, float p1, float p2)
        {
            float low = 0f, high = 1f;
            for (var i = 0; i < 32; i++)
            {
                var middle = (low + high) / 2f;
                if (Bezier(middle, 0f, p1, p2, 1f) < x)
                    low = middle;
                else
                    high = middle;
            }
            return (low + high) / 2f;
        }

        static float Bezier(float t, float p0, float p1, float p2, float p3)
        {
            var u = 1f - t;
            return u * u * u * p0 + 3f * u * u * t * p1 + 3f * u * t * t * p2 + t * t * t * p3;
        }
    }
}
