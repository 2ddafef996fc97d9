using System;

namespace UnityEngine
{
    /// <summary>The tags that every Unity project has; others would need a project's settings.</summary>
    static class Tags
    {
        static readonly string[] s_BuiltIn = { "Untagged", "Respawn", "Finish", "EditorOnly", "MainCamera", "Player", "GameController" };

        /// <exception cref="UnityException">The tag is not defined.</exception>
        internal static string Checked(string tag)
        {
            if (string.IsNullOrEmpty(tag))
                return s_BuiltIn[0];
            if (Array.IndexOf(s_BuiltIn, tag) < 0)
                throw new UnityException($"Tag: {tag} is not defined.");
            return tag;
        }
    }
}
