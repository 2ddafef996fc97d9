using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using UnityEngine.InputSystem.Layouts;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>What controls a device or a control consists of: read from the attributes of its class, of its state struct and of the classes it is based on.</summary>
    sealed class ControlLayout
    {
        ControlLayout(string name, Type type)
        {
            Name = name;
            Type = type;
        }

        internal string Name { get; }

        internal Type Type { get; }

        internal List<Item> Items { get; } = new();

        internal string DisplayName { get; private set; }

        internal FourCC StateFormat { get; private set; }

        internal uint StateSize { get; private set; }

        internal static ControlLayout Of(string name, Type type)
        {
            var layout = new ControlLayout(name, type);
            // What is based on something else changes what that has.
            for (var level = type; level != null && typeof(InputControl).IsAssignableFrom(level); level = level.BaseType)
                layout.Take(level);
            return layout;
        }

        void Take(Type level)
        {
            var attribute = level.GetCustomAttribute<InputControlLayoutAttribute>(false);
            DisplayName ??= attribute?.displayName;
            if (attribute?.stateType is { } state)
                TakeState(state);
            foreach (var property in level.GetProperties(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
                foreach (var item in property.GetCustomAttributes<InputControlAttribute>(false))
                    Add(new Item(item, property.Name, property.PropertyType, InputStateBlock.InvalidOffset));
        }

        void TakeState(Type state)
        {
            if (StateSize == 0 && typeof(IInputStateTypeInfo).IsAssignableFrom(state))
            {
                StateSize = (uint)Marshal.SizeOf(state);
                if (StateSize != Values.SizeOf(state))
                    throw new NotSupportedException($"State {state.Name} has fields whose place in memory is not sure, such as bool; use byte");
                StateFormat = ((IInputStateTypeInfo)Activator.CreateInstance(state)).format;
            }

            if (state == typeof(KeyboardState))
                foreach (var item in KeyControls.Attributes())
                    Add(new Item(item, "keys", typeof(byte[]), 0));
            foreach (var field in state.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
                foreach (var item in field.GetCustomAttributes<InputControlAttribute>(false))
                    Add(new Item(item, field.Name, field.FieldType, (uint)(int)Marshal.OffsetOf(state, field.Name)));
        }

        void Add(Item item)
        {
            if (Items.Find(i => string.Equals(i.Name, item.Name, StringComparison.OrdinalIgnoreCase)) is { } known)
                known.FillFrom(item);
            else
                Items.Add(item);
        }

        /// <summary>One control, or with a slash in its name what is different in a control of a control.</summary>
        internal sealed class Item
        {
            internal Item(InputControlAttribute source, string memberName, Type memberType, uint fieldOffset)
            {
                Name = string.IsNullOrEmpty(source.name) ? memberName : source.name;
                Layout = string.IsNullOrEmpty(source.layout) ? LayoutOf(memberType) : source.layout;
                DisplayName = source.displayName;
                ShortDisplayName = source.shortDisplayName;
                Usages = Joined(source.usage, source.usages);
                Aliases = Joined(source.alias, source.aliases);
                Parameters = NameWithParameters.ParseParameters(source.parameters);
                Processors = source.processors;
                UseStateFrom = source.useStateFrom;
                Noisy = source.noisy;
                Synthetic = source.synthetic;
                DefaultState = source.defaultState == null ? null : Convert.ToSingle(source.defaultState, CultureInfo.InvariantCulture);
                Bit = source.bit;
                SizeInBits = source.sizeInBits;
                Offset = source.offset != InputStateBlock.InvalidOffset ? source.offset : fieldOffset;
                if (Name.IndexOf('/') >= 0)
                    Offset = source.offset;
                Format = !string.IsNullOrEmpty(source.format) ? new FourCC(source.format)
                    : Bit != InputStateBlock.InvalidOffset ? InputStateBlock.FormatBit
                    : fieldOffset != InputStateBlock.InvalidOffset && Offset == fieldOffset ? InputStateBlock.FormatOf(memberType)
                    : InputStateBlock.FormatInvalid;
            }

            internal string Name { get; }
            internal string Layout { get; private set; }
            internal string DisplayName { get; private set; }
            internal string ShortDisplayName { get; private set; }
            internal string[] Usages { get; private set; }
            internal string[] Aliases { get; private set; }
            internal List<KeyValuePair<string, string>> Parameters { get; }
            internal string Processors { get; private set; }
            internal string UseStateFrom { get; private set; }
            internal bool Noisy { get; private set; }
            internal bool Synthetic { get; private set; }
            internal float? DefaultState { get; private set; }
            internal uint Bit { get; private set; }
            internal uint SizeInBits { get; private set; }
            internal uint Offset { get; private set; }
            internal FourCC Format { get; private set; }

            /// <summary>Takes from what this is based on whatever is not said here. A place is said as a whole.</summary>
            internal void FillFrom(Item other)
            {
                var hasPlace = Offset != InputStateBlock.InvalidOffset || Bit != InputStateBlock.InvalidOffset || UseStateFrom != null;
                Layout ??= other.Layout;
                DisplayName ??= other.DisplayName;
                ShortDisplayName ??= other.ShortDisplayName;
                Usages ??= other.Usages;
                Aliases ??= other.Aliases;
                Processors ??= other.Processors;
                DefaultState ??= other.DefaultState;
                Noisy |= other.Noisy;
                Synthetic |= other.Synthetic;
                foreach (var parameter in other.Parameters)
                    if (!Parameters.Exists(p => string.Equals(p.Key, parameter.Key, StringComparison.OrdinalIgnoreCase)))
                        Parameters.Add(parameter);
                if (hasPlace)
                    return;
                (Offset, Bit, SizeInBits, Format, UseStateFrom) = (other.Offset, other.Bit, other.SizeInBits, other.Format, other.UseStateFrom);
            }

            static string[] Joined(string first, string[] others) =>
                first == null ? others : others == null ? new[] { first } : new[] { first }.Concat(others).ToArray();

            static string LayoutOf(Type type) =>
                typeof(InputControl).IsAssignableFrom(type) ? LayoutRegistry.NameOf(type)
                : type == typeof(Vector2) ? "Vector2"
                : type == typeof(Vector3) ? "Vector3"
                : type == typeof(Quaternion) ? "Quaternion"
                : type == typeof(float) ? "Analog"
                : type == typeof(int) || type == typeof(uint) ? "Integer"
                : null;
        }
    }
}
