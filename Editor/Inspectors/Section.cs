using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>A titled part of an Inspector that can be folded. Whether it is open is remembered until the Editor is closed.</summary>
    sealed class Section
    {
        readonly string key;
        readonly GUIContent title;
        bool isOpen;

        public Section(string title, string tooltip, bool openAtFirst)
        {
            this.title = new GUIContent(title, tooltip);
            key = "AnatomyCarve.Section." + title;
            isOpen = SessionState.GetBool(key, openAtFirst);
        }

        public bool IsOpen => isOpen;

        /// <summary>Draws the title.</summary>
        /// <returns>Whether what stands below it is to be drawn.</returns>
        public bool Draw()
        {
            bool now = EditorGUILayout.Foldout(isOpen, title, true, EditorStyles.foldoutHeader);
            if (now != isOpen)
            {
                isOpen = now;
                SessionState.SetBool(key, now);
            }
            return isOpen;
        }
    }
}
