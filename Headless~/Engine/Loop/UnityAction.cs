namespace UnityEngine.Events
{
    /// <summary>A callback without arguments.</summary>
    public delegate void UnityAction();

    /// <summary>A callback with one argument.</summary>
    public delegate void UnityAction<T0>(T0 arg0);

    /// <summary>A callback with two arguments.</summary>
    public delegate void UnityAction<T0, T1>(T0 arg0, T1 arg1);
}
