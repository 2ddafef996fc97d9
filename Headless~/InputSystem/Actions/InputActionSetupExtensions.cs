using System;
using System.Linq;

namespace UnityEngine.InputSystem
{
    /// <summary>Makes maps, actions and bindings by script.</summary>
    public static class InputActionSetupExtensions
    {
        /// <exception cref="InvalidOperationException">The asset has a map of that name.</exception>
        public static InputActionMap AddActionMap(this InputActionAsset asset, string name)
        {
            if (asset == null)
                throw new ArgumentNullException(nameof(asset));
            if (string.IsNullOrEmpty(name))
                throw new ArgumentNullException(nameof(name));
            if (asset.FindActionMap(name) != null)
                throw new InvalidOperationException($"An action map called '{name}' already exists in the asset");
            var map = new InputActionMap(name);
            map.m_Id = Guid.NewGuid().ToString();
            asset.Add(map);
            return map;
        }

        public static void AddActionMap(this InputActionAsset asset, InputActionMap map)
        {
            if (asset == null)
                throw new ArgumentNullException(nameof(asset));
            asset.Add(map ?? throw new ArgumentNullException(nameof(map)));
        }

        /// <exception cref="InvalidOperationException">The map has an action of that name, or is enabled.</exception>
        public static InputAction AddAction(
            this InputActionMap map, string name, InputActionType type = default, string binding = null, string interactions = null,
            string processors = null, string groups = null, string expectedControlLayout = null)
        {
            if (map == null)
                throw new ArgumentNullException(nameof(map));
            if (string.IsNullOrEmpty(name))
                throw new ArgumentException("Action must have name", nameof(name));
            if (map.FindAction(name) != null)
                throw new InvalidOperationException($"Cannot add action with duplicate name '{name}' to set '{map.name}'");
            var action = new InputAction(name, type, expectedControlType: expectedControlLayout);
            action.m_Id = Guid.NewGuid().ToString();
            map.Add(action);
            if (string.IsNullOrEmpty(binding))
            {
                action.m_Interactions = interactions;
                action.m_Processors = processors;
            }
            else
            {
                action.AddBinding(binding, interactions, processors, groups);
            }

            return action;
        }

        public static BindingSyntax AddBinding(this InputAction action, string path, string interactions = null, string processors = null, string groups = null) =>
            AddBinding(action, new InputBinding(path, null, groups, processors, interactions));

        public static BindingSyntax AddBinding(this InputAction action, InputBinding binding = default)
        {
            if (action == null)
                throw new ArgumentNullException(nameof(action));
            binding.action = action.name;
            action.MapInUse.Add(binding);
            return new BindingSyntax(action.MapInUse, action.MapInUse.m_Bindings.Length - 1, action);
        }

        /// <summary>Its parts follow: <c>.With("Up", "&lt;Keyboard&gt;/w")</c>.</summary>
        public static CompositeSyntax AddCompositeBinding(this InputAction action, string composite, string interactions = null, string processors = null)
        {
            if (string.IsNullOrEmpty(composite))
                throw new ArgumentException("Composite name cannot be null or empty", nameof(composite));
            var binding = new InputBinding(composite, null, null, processors, interactions, NameWithParameters.Parse(composite).Name) { isComposite = true };
            return new CompositeSyntax(action, AddBinding(action, binding).bindingIndex);
        }

        /// <summary>A binding that was added or found.</summary>
        public struct BindingSyntax
        {
            readonly InputActionMap m_Map;
            readonly InputAction m_Action;
            readonly int m_Index;

            internal BindingSyntax(InputActionMap map, int indexInMap, InputAction action)
            {
                m_Map = map;
                m_Index = indexInMap;
                m_Action = action;
            }

            public bool valid => m_Map != null && m_Index >= 0 && m_Index < m_Map.m_Bindings.Length;

            public InputBinding binding => valid ? m_Map.m_Bindings[m_Index] : throw new InvalidOperationException("BindingSyntax accessor is not valid");

            /// <summary>Among the action's bindings.</summary>
            public int bindingIndex
            {
                get
                {
                    if (!valid)
                        return -1;
                    var id = binding.m_Id;
                    return m_Action == null ? m_Index : Array.FindIndex(m_Map.BindingsOf(m_Action), b => b.m_Id == id);
                }
            }

            public BindingSyntax WithGroups(string groups)
            {
                m_Map.m_Bindings[valid ? m_Index : throw new InvalidOperationException("BindingSyntax accessor is not valid")].groups =
                    string.Join(";", new[] { binding.groups, groups }.Where(g => !string.IsNullOrEmpty(g)));
                m_Map.ForgetResolution();
                return this;
            }
        }

        /// <summary>A composite that was added, which gets its parts.</summary>
        public struct CompositeSyntax
        {
            readonly InputAction m_Action;

            internal CompositeSyntax(InputAction action, int bindingIndex)
            {
                m_Action = action;
                this.bindingIndex = bindingIndex;
            }

            public int bindingIndex { get; }

            /// <summary>Adds a part. All parts are added before other bindings.</summary>
            public CompositeSyntax With(string name, string binding, string groups = null, string processors = null)
            {
                m_Action.AddBinding(new InputBinding(binding, null, groups, processors, null, name) { isPartOfComposite = true });
                return this;
            }
        }
    }
}
