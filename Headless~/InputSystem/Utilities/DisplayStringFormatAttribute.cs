using System;

namespace UnityEngine.InputSystem.Utilities
{
    /// <summary>How a composite's bindings are shown to people: "{modifier}+{button}".</summary>
    [AttributeUsage(AttributeTargets.Class)]
    public class DisplayStringFormatAttribute : Attribute
    {
        public DisplayStringFormatAttribute(string formatString) => this.formatString = formatString;

        public string formatString { get; set; }
    }
}
