using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("AnatomyCarve.Tests")]
[assembly: InternalsVisibleTo("AnatomyCarve.Editor")]
[assembly: InternalsVisibleTo("AnatomyCarve.Editor.Tests")]
[assembly: InternalsVisibleTo("AnatomyCarve.Desktop")]
