using System.IO;
using System.Linq;
using System.Xml.Linq;

namespace Farseer.Porting.Tests
{
    /// <summary>What the build property brings, read from the package's own targets file.</summary>
    internal static class BuildProperty
    {
        /// <summary>The global usings of a project that sets it, and gives no names by itself.</summary>
        public static string GlobalUsings { get; } = Read();

        private static string Read()
        {
            using Stream stream = typeof(BuildProperty).Assembly.GetManifestResourceStream("Farseer.targets");
            XElement items = XDocument.Load(stream).Root.Elements("ItemGroup").Single();
            string aliases = string.Concat(items.Elements("_FarseerPortingName").Where(e => e.Attribute("Include") != null)
                .Select(e => $"global using {e.Attribute("Alias").Value} = {e.Attribute("Type").Value};\n"));
            return aliases + string.Concat(items.Elements("Using").Select(e => e.Attribute("Include")?.Value)
                .Where(name => name != null && !name.StartsWith('@')).Select(name => $"global using {name};\n"));
        }
    }
}
