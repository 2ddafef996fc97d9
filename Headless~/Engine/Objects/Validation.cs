using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>OnValidate, which only the Editor sends: to scripts that were loaded, or whose fields were changed.</summary>
    static class Validation
    {
        /// <summary>To all scripts below some objects, the sleeping ones too.</summary>
        internal static void SendToAll(IEnumerable<GameObject> roots)
        {
            if (!Application.isEditor)
                return;
            foreach (var script in roots.SelectMany(r => r.OwnTransform.Subtree(true)).SelectMany(g => g.Components).OfType<MonoBehaviour>().ToList())
                script.Messages.OnValidate.Send(script);
        }

        internal static void Send(Object target)
        {
            if (Application.isEditor)
                Messages.Of(target.GetType()).OnValidate.Send(target);
        }

        /// <summary>To a script that was just added: Reset, then OnValidate.</summary>
        internal static void SendAdded(MonoBehaviour script)
        {
            if (!Application.isEditor)
                return;
            script.Messages.Reset.Send(script);
            script.Messages.OnValidate.Send(script);
        }
    }
}
