using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("AnatomyCarve.Tests")]
