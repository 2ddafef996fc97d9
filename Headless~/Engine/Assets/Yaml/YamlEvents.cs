using System;
using System.Globalization;
using System.Reflection;
using UnityEngine.Events;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Reads what was wired in the Inspector: the persistent listeners of a UnityEvent.</summary>
    static class YamlEvents
    {
        /// <exception cref="AssetFormatException">A target has no such method: Unity would pass over the call without a word.</exception>
        internal static UnityEventBase Read(YamlDocument document, YamlReferences references, YamlMappingNode node, Type type)
        {
            var made = (UnityEventBase)Activator.CreateInstance(type, true);
            var group = document.Mapping(document.Needed(node, "m_PersistentCalls"));
            foreach (var item in document.List(document.Needed(group, "m_Calls")))
                made.PersistentCalls.Add(Call(document, references, document.Mapping(item), made));
            return made;
        }

        static PersistentCall Call(YamlDocument document, YamlReferences references, YamlMappingNode node, UnityEventBase owner)
        {
            var target = references.Resolve(document, document.Needed(node, "m_Target"));
            var name = document.Scalar(document.Needed(node, "m_MethodName"));
            var mode = (PersistentListenerMode)document.Long(document.Needed(node, "m_Mode"));
            var state = (UnityEventCallState)document.Long(document.Needed(node, "m_CallState"));
            if (!Enum.IsDefined(typeof(PersistentListenerMode), mode) || !Enum.IsDefined(typeof(UnityEventCallState), state))
                throw document.Error(node, $"m_Mode {(int)mode} or m_CallState {(int)state} does not exist");
            var argument = Argument(document, references, node, mode);
            MethodInfo method = null;
            if (target is not null and not DataComponent and not DataAsset)
            {
                var arguments = PersistentCall.ArgumentTypes(owner, mode, argument);
                method = UnityEventBase.GetValidMethodInfo(target.GetType(), name, arguments) ?? throw document.Error(node,
                    $"{target.GetType().Name} has no method {name}({string.Join(", ", Array.ConvertAll(arguments, t => t.Name))})");
            }

            return new PersistentCall(target, name, method, mode, argument, state);
        }

        static object Argument(YamlDocument document, YamlReferences references, YamlMappingNode node, PersistentListenerMode mode)
        {
            if (mode is PersistentListenerMode.EventDefined or PersistentListenerMode.Void)
                return null;
            var arguments = document.Mapping(document.Needed(node, "m_Arguments"));
            switch (mode)
            {
                case PersistentListenerMode.Object:
                    return references.Resolve(document, document.Needed(arguments, "m_ObjectArgument"));
                case PersistentListenerMode.Int:
                    return (int)document.Long(document.Needed(arguments, "m_IntArgument"));
                case PersistentListenerMode.Bool:
                    return document.Long(document.Needed(arguments, "m_BoolArgument")) != 0;
                case PersistentListenerMode.String:
                    return document.Scalar(document.Needed(arguments, "m_StringArgument"));
                default:
                    var number = document.Needed(arguments, "m_FloatArgument");
                    return float.TryParse(document.Scalar(number), NumberStyles.Float, CultureInfo.InvariantCulture, out var value)
                        ? value
                        : throw document.Error(number, $"'{document.Scalar(number)}' is no number");
            }
        }
    }
}
