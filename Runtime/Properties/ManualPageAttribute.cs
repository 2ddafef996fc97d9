using System;
using System.IO;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// The page of the manual that an Inspector's help button opens: a file of the package as it is installed, so that it fits the version and needs no network.
    /// </summary>
    sealed class ManualPageAttribute : HelpURLAttribute
    {
        /// <summary>In the Editor this path leads into the package, wherever the package manager put it.</summary>
        const string Folder = "Packages/com.anatomycarve.vr/Documentation~/";

        /// <param name="page">The page's file name without its ending.</param>
        public ManualPageAttribute(string page)
            : base(new Uri(Path.GetFullPath(Folder + page + ".md")).AbsoluteUri)
        {
        }
    }
}
