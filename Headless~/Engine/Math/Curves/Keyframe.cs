namespace UnityEngine
{
    /// <summary>What a curve or an animation does beyond its ends.</summary>
    public enum WrapMode
    {
        Default = 0,
        Clamp = 1,
        Once = 1,
        Loop = 2,
        PingPong = 4,
        ClampForever = 8,
    }

    /// <summary>Which of a key's tangents have weights of their own.</summary>
    public enum WeightedMode
    {
        None = 0,
        In = 1,
        Out = 2,
        Both = 3,
    }

    /// <summary>A key of a curve. An infinite tangent makes a step.</summary>
    public struct Keyframe
    {
        public Keyframe(float time, float value) : this(time, value, 0f, 0f)
        {
        }

        public Keyframe(float time, float value, float inTangent, float outTangent)
        {
            (this.time, this.value, this.inTangent, this.outTangent) = (time, value, inTangent, outTangent);
            (inWeight, outWeight, weightedMode) = (0f, 0f, WeightedMode.None);
        }

        public Keyframe(float time, float value, float inTangent, float outTangent, float inWeight, float outWeight)
        {
            (this.time, this.value, this.inTangent, this.outTangent) = (time, value, inTangent, outTangent);
            (this.inWeight, this.outWeight, weightedMode) = (inWeight, outWeight, WeightedMode.Both);
        }

        public float time { get; set; }

        public float value { get; set; }

        public float inTangent { get; set; }

        public float outTangent { get; set; }

        public float inWeight { get; set; }

        public float outWeight { get; set; }

        public WeightedMode weightedMode { get; set; }
    }
}
