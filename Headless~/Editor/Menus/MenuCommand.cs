using UnityEngine;

namespace UnityEditor
{
    /// <summary>On what a menu entry was chosen.</summary>
    public sealed class MenuCommand
    {
        public Object context;
        public int userData;

        public MenuCommand(Object inContext) : this(inContext, 0)
        {
        }

        public MenuCommand(Object inContext, int inUserData)
        {
            context = inContext;
            userData = inUserData;
        }
    }
}
