using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem.LowLevel
{
    /// <summary>What a keyboard reports: a bit per key.</summary>
    public unsafe struct KeyboardState : IInputStateTypeInfo
    {
        internal const int SizeInBytes = (Keyboard.KeyCount + 7) / 8;

        public fixed byte keys[SizeInBytes];

        /// <summary>Some keys down, the others up.</summary>
        public KeyboardState(params Key[] pressedKeys) : this()
        {
            if (pressedKeys == null)
                throw new System.ArgumentNullException(nameof(pressedKeys));
            foreach (var key in pressedKeys)
                Press(key);
        }

        public static FourCC Format => new('K', 'E', 'Y', 'S');

        public FourCC format => Format;

        public void Press(Key key) => Set(key, true);

        public void Release(Key key) => Set(key, false);

        public void Set(Key key, bool state)
        {
            var bit = (byte)(1 << ((int)key % 8));
            if (state)
                keys[(int)key / 8] |= bit;
            else
                keys[(int)key / 8] &= (byte)~bit;
        }
    }
}
