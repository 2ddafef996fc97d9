using System;
using System.Collections.Generic;
using System.Linq;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace UnityEngine.InputSystem
{
    /// <summary>The text of .inputactions files.</summary>
    static class ActionsJson
    {
        /// <exception cref="ArgumentException">The text is no JSON, or an action's type is unknown.</exception>
        internal static void Read(string json, InputActionAsset asset)
        {
            var root = Parse(json);
            asset.name = Text(root, "name");
            asset.m_ActionMaps = Maps(root);
            asset.m_ControlSchemes = Objects(root, "controlSchemes").Select(Scheme).ToArray();
        }

        internal static InputActionMap[] ReadMaps(string json) => Maps(Parse(json));

        internal static string Write(string name, IEnumerable<InputActionMap> maps, IEnumerable<InputControlScheme> schemes)
        {
            var root = new JObject();
            if (name != null)
            {
                root["version"] = 1;
                root["name"] = name;
            }

            root["maps"] = new JArray(maps.Select(Json));
            if (schemes != null)
                root["controlSchemes"] = new JArray(schemes.Select(Json));
            return root.ToString(Formatting.Indented);
        }

        static JObject Parse(string json)
        {
            try
            {
                return JObject.Parse(json);
            }
            catch (JsonException e)
            {
                throw new ArgumentException($"JSON parse error: {e.Message}", e);
            }
        }

        static InputActionMap[] Maps(JObject root)
        {
            var maps = Objects(root, "maps").Select(Map).ToArray();
            foreach (var map in maps)
                map.OnAfterDeserialize();
            return maps;
        }

        static InputActionMap Map(JObject json) => new(Text(json, "name"))
        {
            m_Id = Text(json, "id"),
            m_Actions = Objects(json, "actions").Select(Action).ToArray(),
            m_Bindings = Objects(json, "bindings").Select(Binding).ToArray(),
        };

        static InputAction Action(JObject json)
        {
            var type = Text(json, "type");
            if (string.IsNullOrEmpty(type))
                type = nameof(InputActionType.Value);
            if (!Enum.TryParse<InputActionType>(type, true, out var parsed))
                throw new ArgumentException($"Action '{Text(json, "name")}' has type '{type}'; expected Value, Button or PassThrough");
            return new InputAction(Text(json, "name"), parsed)
            {
                m_Id = Text(json, "id"),
                m_ExpectedControlType = Text(json, "expectedControlType"),
                m_Processors = Text(json, "processors"),
                m_Interactions = Text(json, "interactions"),
                wantsInitialStateCheck = Flag(json, "initialStateCheck"),
            };
        }

        static InputBinding Binding(JObject json) => new(
            Text(json, "path"), Text(json, "action"), Text(json, "groups"), Text(json, "processors"), Text(json, "interactions"), Text(json, "name"))
        {
            m_Id = Text(json, "id"),
            isComposite = Flag(json, "isComposite"),
            isPartOfComposite = Flag(json, "isPartOfComposite"),
        };

        static InputControlScheme Scheme(JObject json) => new(
            Text(json, "name"),
            Objects(json, "devices").Select(d => new InputControlScheme.DeviceRequirement
            {
                controlPath = Text(d, "devicePath"),
                isOptional = Flag(d, "isOptional"),
                isOR = Flag(d, "isOR"),
            }),
            Text(json, "bindingGroup"));

        static JObject Json(InputActionMap map) => new()
        {
            ["name"] = map.name,
            ["id"] = map.id.ToString(),
            ["actions"] = new JArray(map.m_Actions.Select(a => new JObject
            {
                ["name"] = a.name,
                ["type"] = a.type.ToString(),
                ["id"] = a.id.ToString(),
                ["expectedControlType"] = a.expectedControlType ?? "",
                ["processors"] = a.processors ?? "",
                ["interactions"] = a.interactions ?? "",
                ["initialStateCheck"] = a.wantsInitialStateCheck,
            })),
            ["bindings"] = new JArray(map.m_Bindings.Select(b => new JObject
            {
                ["name"] = b.name ?? "",
                ["id"] = b.id.ToString(),
                ["path"] = b.path ?? "",
                ["interactions"] = b.interactions ?? "",
                ["processors"] = b.processors ?? "",
                ["groups"] = b.groups ?? "",
                ["action"] = b.action ?? "",
                ["isComposite"] = b.isComposite,
                ["isPartOfComposite"] = b.isPartOfComposite,
            })),
        };

        static JObject Json(InputControlScheme scheme) => new()
        {
            ["name"] = scheme.name,
            ["bindingGroup"] = scheme.bindingGroup,
            ["devices"] = new JArray(scheme.deviceRequirements.Select(d => new JObject
            {
                ["devicePath"] = d.controlPath,
                ["isOptional"] = d.isOptional,
                ["isOR"] = d.isOR,
            })),
        };

        static IEnumerable<JObject> Objects(JObject json, string key) => (json[key] as JArray)?.OfType<JObject>() ?? Enumerable.Empty<JObject>();

        static string Text(JObject json, string key) => (string)json[key] ?? "";

        static bool Flag(JObject json, string key) => (bool?)json[key] ?? false;
    }
}
