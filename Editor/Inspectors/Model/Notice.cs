namespace AnatomyCarve.Editor
{
    /// <summary>How a notice is shown; the numbers are those of Unity's MessageType.</summary>
    enum NoticeKind
    {
        None = 0,
        Info = 1,
        Warning = 2,
        Error = 3,
    }

    /// <summary>A sentence at the top of an Inspector: what is wrong, or what is missing.</summary>
    readonly struct Notice
    {
        public Notice(NoticeKind kind, string text)
        {
            Kind = kind;
            Text = text;
        }

        public NoticeKind Kind { get; }

        /// <summary>Null = there is nothing to say.</summary>
        public string Text { get; }
    }
}
