using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>A smooth function of time through keys.</summary>
    public class AnimationCurve : IEquatable<AnimationCurve>
    {
        readonly List<Keyframe> m_Keys = new();

        public AnimationCurve()
        {
        }

        public AnimationCurve(params Keyframe[] keys) => this.keys = keys;

        public Keyframe this[int index] => m_Keys[index];

        public int length => m_Keys.Count;

        /// <summary>In order of time; a copy.</summary>
        public Keyframe[] keys
        {
            get => m_Keys.ToArray();
            set
            {
                m_Keys.Clear();
                foreach (var key in value ?? Array.Empty<Keyframe>())
                    AddKey(key);
            }
        }

        public WrapMode preWrapMode { get; set; } = WrapMode.ClampForever;

        public WrapMode postWrapMode { get; set; } = WrapMode.ClampForever;

        public static AnimationCurve Constant(float timeStart, float timeEnd, float value) => Linear(timeStart, value, timeEnd, value);

        public static AnimationCurve Linear(float timeStart, float valueStart, float timeEnd, float valueEnd)
        {
            if (timeStart == timeEnd)
                return new AnimationCurve(new Keyframe(timeStart, valueStart));
            var slope = (valueEnd - valueStart) / (timeEnd - timeStart);
            return new AnimationCurve(new Keyframe(timeStart, valueStart, 0f, slope), new Keyframe(timeEnd, valueEnd, slope, 0f));
        }

        public static AnimationCurve EaseInOut(float timeStart, float valueStart, float timeEnd, float valueEnd) => timeStart == timeEnd
            ? new AnimationCurve(new Keyframe(timeStart, valueStart))
            : new AnimationCurve(new Keyframe(timeStart, valueStart), new Keyframe(timeEnd, valueEnd));

        public float Evaluate(float time) => CurveMath.Evaluate(m_Keys, time, preWrapMode, postWrapMode);

        /// <summary>A key that the curve passes smoothly, as do its neighbours.</summary>
        /// <returns>Its index; -1 if there is one at that time already.</returns>
        public int AddKey(float time, float value)
        {
            var index = AddKey(new Keyframe(time, value));
            for (var i = Math.Max(0, index - 1); index >= 0 && i < Math.Min(m_Keys.Count, index + 2); i++)
                SmoothTangents(i, 0f);
            return index;
        }

        public int AddKey(Keyframe key)
        {
            var index = m_Keys.FindIndex(k => k.time >= key.time);
            if (index >= 0 && m_Keys[index].time == key.time)
                return -1;
            if (index < 0)
                index = m_Keys.Count;
            m_Keys.Insert(index, key);
            return index;
        }

        /// <returns>Its new index; where there is a key at its new time already, it keeps its old one.</returns>
        public int MoveKey(int index, Keyframe key)
        {
            var old = m_Keys[index];
            m_Keys.RemoveAt(index);
            var moved = AddKey(key);
            if (moved >= 0)
                return moved;
            key.time = old.time;
            return AddKey(key);
        }

        public void RemoveKey(int index) => m_Keys.RemoveAt(index);

        public void ClearKeys() => m_Keys.Clear();

        /// <summary>Lets the curve pass a key with the mean slope of its sides; weight -1 takes the next one's, 1 the previous one's.</summary>
        public void SmoothTangents(int index, float weight)
        {
            var key = m_Keys[index];
            var slope = 0f;
            if (m_Keys.Count > 1)
            {
                var before = index > 0 ? Slope(index - 1) : Slope(index);
                var after = index < m_Keys.Count - 1 ? Slope(index) : before;
                slope = ((1f + weight) * before + (1f - weight) * after) / 2f;
            }
            (key.inTangent, key.outTangent) = (slope, slope);
            m_Keys[index] = key;
        }

        public void CopyFrom(AnimationCurve other)
        {
            keys = other.keys;
            (preWrapMode, postWrapMode) = (other.preWrapMode, other.postWrapMode);
        }

        public bool Equals(AnimationCurve other) => other is not null && preWrapMode == other.preWrapMode && postWrapMode == other.postWrapMode
            && m_Keys.SequenceEqual(other.m_Keys);

        public override bool Equals(object o) => o is AnimationCurve other && Equals(other);

        public override int GetHashCode() => m_Keys.Aggregate(HashCode.Combine(preWrapMode, postWrapMode), HashCode.Combine);

        float Slope(int from) => (m_Keys[from + 1].value - m_Keys[from].value) / (m_Keys[from + 1].time - m_Keys[from].time);
    }
}
