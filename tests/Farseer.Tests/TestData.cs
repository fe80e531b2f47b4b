using System.IO;

namespace Farseer.Tests;

/// <summary>The files of tests/data, which are embedded in the test assembly under their names.</summary>
internal static class TestData
{
    public static string Read(string name)
    {
        using var stream = typeof(TestData).Assembly.GetManifestResourceStream(name)
            ?? throw new FileNotFoundException($"No data file {name} is embedded in the tests.", name);
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }
}
