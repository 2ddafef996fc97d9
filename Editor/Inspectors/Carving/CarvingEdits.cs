using System;
using AnatomyCarve.Carving;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Edits of a carving from the Editor. In Play they are edits like those of a hand, with the component's own history. Outside Play they become what
    /// volumes start with: saved with the scene, and undone by Unity's own Undo, after which the component notices that it starts with something else.
    /// </summary>
    static class CarvingEdits
    {
        /// <summary>Whether there is something to edit: a loaded volume.</summary>
        public static bool IsPossible(ClipSphereStack stack) => stack != null && stack.Carving != null;

        /// <summary>Whether the active mask can be edited. Outside Play a mask is saved with its sphere only.</summary>
        public static bool IsMaskPossible(ClipSphereStack stack) => IsPossible(stack) && (Application.isPlaying || stack.Carving.Active is object);

        /// <summary>Makes an edit.</summary>
        /// <param name="stack">Whose carving; without a loaded volume nothing happens.</param>
        /// <param name="name">What the menu Edit calls it, such as "Fix Clip Sphere".</param>
        /// <param name="edit">The edit. Where it throws, the carving is as it was.</param>
        public static void Do(ClipSphereStack stack, string name, Action<CarvingStack> edit)
        {
            if (!IsPossible(stack))
                return;
            if (Application.isPlaying)
            {
                edit(stack.Carving);
                return;
            }
            Undo.RecordObject(stack, name);
            edit(stack.Carving);
            stack.KeepAsStart();
            PrefabUtility.RecordPrefabInstancePropertyModifications(stack);
            EditorLink.RequestRefresh();
        }
    }
}
