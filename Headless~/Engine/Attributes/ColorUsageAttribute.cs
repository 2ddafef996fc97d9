using System;

namespace UnityEngine
{
    /// <summary>Which parts of a colour the Inspector lets one edit.</summary>
    [AttributeUsage(AttributeTargets.Field | AttributeTargets.Property)]
    public sealed class ColorUsageAttribute : PropertyAttribute
    {
        public readonly bool showAlpha;
        public readonly bool hdr;

        public ColorUsageAttribute(bool showAlpha) : this(showAlpha, false)
        {
        }

        public ColorUsageAttribute(bool showAlpha, bool hdr)
        {
            this.showAlpha = showAlpha;
            this.hdr = hdr;
        }
    }
}
