using System;
using System.IO;
using System.Linq;

namespace Farseer.Porting.Tests
{
    /// <summary>docs/Porting.md and the tables of tests/data that it explains.</summary>
    internal static class PortingGuide
    {
        public static string Text { get; } = Read("Porting.md");

        /// <summary>The rows of a table without its head.</summary>
        public static string[] Rows(string name) => Read(name).Split('\n', StringSplitOptions.RemoveEmptyEntries).Skip(1).ToArray();

        /// <summary>What stands under a heading.</summary>
        public static string Section(string heading)
        {
            int start = Text.IndexOf($"## {heading}\n", StringComparison.Ordinal);
            if (start < 0)
            {
                throw new ArgumentException($"docs/Porting.md has no section '{heading}'.", nameof(heading));
            }

            int end = Text.IndexOf("\n## ", start + 3, StringComparison.Ordinal);
            return end < 0 ? Text.Substring(start) : Text.Substring(start, end - start);
        }

        /// <summary>The cells of a section's first table, line by line, without its head.</summary>
        public static string[][] Table(string heading) => Section(heading).Split('\n')
            .SkipWhile(line => !line.StartsWith('|')).TakeWhile(line => line.StartsWith('|')).Skip(2)
            .Select(line => line.Split('|').Skip(1).SkipLast(1).Select(cell => cell.Trim()).ToArray())
            .ToArray();

        private static string Read(string name)
        {
            using Stream stream = typeof(PortingGuide).Assembly.GetManifestResourceStream(name);
            using var reader = new StreamReader(stream);
            return reader.ReadToEnd().Replace("\r", string.Empty);
        }
    }
}
