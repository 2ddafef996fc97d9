using System;

namespace UnityEditor
{
    /// <summary>Puts a static method into the Editor's menus.</summary>
    [AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
    public sealed class MenuItem : Attribute
    {
        public string menuItem;
        public bool validate;
        public int priority;

        public MenuItem(string itemName) : this(itemName, false)
        {
        }

        public MenuItem(string itemName, bool isValidateFunction) : this(itemName, isValidateFunction, isValidateFunction ? int.MaxValue : 1000)
        {
        }

        /// <param name="itemName">The path, with slashes; a short cut may follow.</param>
        /// <param name="isValidateFunction">Whether the method says whether the entry of that path can be chosen.</param>
        /// <param name="priority">Where it stands.</param>
        public MenuItem(string itemName, bool isValidateFunction, int priority)
        {
            menuItem = itemName;
            validate = isValidateFunction;
            this.priority = priority;
        }
    }
}
