using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("AnatomyCarve.Desktop.Tests")]
