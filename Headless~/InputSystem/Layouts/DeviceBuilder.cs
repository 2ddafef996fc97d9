using System;
using System.Linq;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>Makes a device: its controls from its layout, and their places in its memory.</summary>
    sealed unsafe class DeviceBuilder
    {
        readonly LayoutRegistry m_Layouts;
        InputDevice m_Device;

        internal DeviceBuilder(LayoutRegistry layouts) => m_Layouts = layouts;

        internal InputDevice Build(string layoutName, string name)
        {
            var layout = m_Layouts.Layout(layoutName);
            if (!typeof(InputDevice).IsAssignableFrom(layout.Type))
                throw new ArgumentException($"Layout '{layoutName}' is that of a control, not of a device");
            m_Device = (InputDevice)Activator.CreateInstance(layout.Type);
            Fill(m_Device, layout, name, null);
            m_Device.m_DisplayName ??= layout.DisplayName;
            var size = (Place(m_Device) + 7) / 8;
            m_Device.m_StateBlock.format = layout.StateFormat;
            m_Device.m_StateBlock.sizeInBits = Math.Max(size, layout.StateSize) * 8;
            Move(m_Device, 0);
            ShareStates(m_Device, layout);
            m_Device.State = new DeviceState(m_Device.m_StateBlock.SizeInBytes);
            WriteDefaults(m_Device, layout);
            m_Device.State.Reset();
            m_Device.State.KeepAsPrevious();
            m_Device.CollectControls();
            FinishSetup(m_Device);
            return m_Device;
        }

        void Fill(InputControl control, ControlLayout layout, string name, InputControl parent)
        {
            control.name = name;
            control.m_Parent = parent;
            control.m_Device = m_Device;
            control.m_Layout = new InternedString(layout.Name);
            var own = layout.Items.Where(i => i.Name.IndexOf('/') < 0).ToList();
            control.m_Children = own.Select(item => Make(item, control)).ToArray();
            // A name with a slash changes a control of a control, or adds one to it.
            foreach (var item in layout.Items.Except(own))
            {
                var slash = item.Name.LastIndexOf('/');
                var inside = Child(control, item.Name.Substring(0, slash), layout);
                var childName = item.Name.Substring(slash + 1);
                var known = inside.m_Children.FirstOrDefault(c => string.Equals(c.name, childName, StringComparison.OrdinalIgnoreCase));
                if (known == null)
                    inside.m_Children = inside.m_Children.Append(Make(item, inside, childName)).ToArray();
                else
                    Describe(known, item);
            }
        }

        InputControl Make(ControlLayout.Item item, InputControl parent, string name = null)
        {
            if (item.Layout == null)
                throw new ArgumentException($"Control '{parent.path}/{item.Name}' says no layout");
            var layout = m_Layouts.Layout(item.Layout);
            var control = (InputControl)Activator.CreateInstance(layout.Type);
            Fill(control, layout, name ?? item.Name, parent);
            Describe(control, item);
            return control;
        }

        void Describe(InputControl control, ControlLayout.Item item)
        {
            control.m_DisplayName = item.DisplayName ?? control.m_DisplayName;
            control.m_ShortDisplayName = item.ShortDisplayName ?? control.m_ShortDisplayName;
            control.noisy |= item.Noisy;
            control.synthetic |= item.Synthetic;
            if (item.Usages != null)
                control.m_Usages = item.Usages.Select(u => new InternedString(u)).ToArray();
            if (item.Aliases != null)
                control.m_Aliases = item.Aliases.Select(a => new InternedString(a)).ToArray();
            NameWithParameters.Apply(item.Parameters, control);
            if (!string.IsNullOrEmpty(item.Processors))
                foreach (var processor in NameWithParameters.ParseMultiple(item.Processors))
                    control.AddProcessor(m_Layouts.MakeProcessor(processor, item.Processors));
            if (item.Format != InputStateBlock.FormatInvalid)
                control.m_StateBlock.format = item.Format;
            if (item.SizeInBits != 0)
                control.m_StateBlock.sizeInBits = item.SizeInBits;
            if (item.UseStateFrom != null)
                control.SharesStateOf = item.UseStateFrom;
            control.FixedByte = item.Offset is InputStateBlock.InvalidOffset or InputStateBlock.AutomaticOffset ? null : item.Offset;
            if (item.Bit == InputStateBlock.InvalidOffset)
                return;
            control.m_StateBlock.bitOffset = item.Bit % 8;
            if (item.Offset != InputStateBlock.AutomaticOffset)
                control.FixedByte = (control.FixedByte ?? 0) + item.Bit / 8;
        }

        /// <summary>Gives the controls inside one their places relative to it: said ones first, the others after them.</summary>
        /// <returns>How many bits it takes.</returns>
        static uint Place(InputControl control)
        {
            uint end = 0;
            foreach (var child in control.m_Children)
            {
                var size = Place(child);
                if (child.m_StateBlock.sizeInBits == 0)
                    child.m_StateBlock.sizeInBits = Math.Max(size, InputStateBlock.SizeOf(child.m_StateBlock.format));
                if (child.SharesStateOf != null || child.FixedByte == null)
                    continue;
                child.m_StateBlock.byteOffset = child.FixedByte.Value;
                end = Math.Max(end, child.m_StateBlock.byteOffset * 8 + child.m_StateBlock.bitOffset + child.m_StateBlock.sizeInBits);
            }

            foreach (var child in control.m_Children)
            {
                if (child.SharesStateOf != null || child.FixedByte != null)
                    continue;
                var bits = child.m_StateBlock.sizeInBits;
                // Single bits lie beside each other; whole numbers are aligned to their size, at most to four bytes.
                var alignment = bits < 8 ? 1 : Math.Min(32, Mathf.NextPowerOfTwo((int)bits));
                var at = (uint)((end + alignment - 1) / alignment * alignment);
                child.m_StateBlock.byteOffset = at / 8;
                child.m_StateBlock.bitOffset = at % 8;
                end = at + bits;
            }

            return end;
        }

        static void Move(InputControl control, uint by)
        {
            control.m_StateBlock.byteOffset += by;
            foreach (var child in control.m_Children)
                Move(child, control.m_StateBlock.byteOffset);
        }

        void ShareStates(InputControl control, ControlLayout layout)
        {
            foreach (var child in control.m_Children)
            {
                if (child.SharesStateOf != null)
                {
                    if (child.m_Children.Length > 0)
                        throw new NotSupportedException($"'{child.path}' has controls of its own and so cannot use the state of another one");
                    child.m_StateBlock = Child(control, child.SharesStateOf, layout).m_StateBlock;
                }

                ShareStates(child, m_Layouts.Layout(child.layout));
            }
        }

        void WriteDefaults(InputControl control, ControlLayout layout)
        {
            foreach (var child in control.m_Children)
            {
                var childLayout = m_Layouts.Layout(child.layout);
                if (layout.Items.Find(i => string.Equals(i.Name, child.name, StringComparison.OrdinalIgnoreCase))?.DefaultState is { } value)
                    child.m_StateBlock.WriteFloat(m_Device.State.Default, value);
                WriteDefaults(child, childLayout);
            }
        }

        static void FinishSetup(InputControl control)
        {
            foreach (var child in control.m_Children)
                FinishSetup(child);
            control.SendFinishSetup();
        }

        static InputControl Child(InputControl control, string path, ControlLayout layout)
        {
            foreach (var part in path.Split('/'))
                control = control.m_Children.FirstOrDefault(c => string.Equals(c.name, part, StringComparison.OrdinalIgnoreCase))
                    ?? throw new ArgumentException($"Cannot find control '{path}' in layout '{layout.Name}'");
            return control;
        }
    }
}
