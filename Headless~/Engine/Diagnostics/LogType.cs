namespace UnityEngine
{
    /// <summary>How serious a message is.</summary>
    public enum LogType
    {
        Error = 0,
        Assert = 1,
        Warning = 2,
        Log = 3,
        Exception = 4,
    }

    /// <summary>Whether a message carries a stack trace.</summary>
    public enum LogOption
    {
        None = 0,
        NoStacktrace = 1,
    }
}
