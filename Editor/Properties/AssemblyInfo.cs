using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("AnatomyCarve.Editor.Tests")]
