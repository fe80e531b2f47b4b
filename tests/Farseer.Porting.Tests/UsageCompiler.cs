using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using FarseerGames.FarseerPhysics;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace Farseer.Porting.Tests
{
    /// <summary>
    /// Writes for a row of a table a line of C# that uses the member, and compiles it under the aliases of the build property.
    /// </summary>
    internal static class UsageCompiler
    {
        private static readonly Dictionary<string, string> Operators = new Dictionary<string, string>
        {
            ["op_Addition"] = "+",
            ["op_Subtraction"] = "-",
            ["op_Multiply"] = "*",
            ["op_Division"] = "/",
            ["op_Equality"] = "==",
            ["op_Inequality"] = "!=",
            ["op_BitwiseAnd"] = "&",
            ["op_BitwiseOr"] = "|",
            ["op_UnaryNegation"] = "-",
            ["op_OnesComplement"] = "~",
        };

        /// <summary>The rows for which no way of use compiles.</summary>
        public static string[] Failures(string[] rows)
        {
            var source = new StringBuilder("class Uses {\n");
            var candidates = new List<int>();
            for (int i = 0; i < rows.Length; i++)
            {
                foreach (string use in Uses(rows[i].Split('\t')))
                {
                    source.Append(FormattableString.Invariant($"static void M{candidates.Count}{use}\n"));
                    candidates.Add(i);
                }
            }

            HashSet<int> broken = Broken(source.Append('}').ToString());
            HashSet<int> fine = candidates.Where((_, line) => !broken.Contains(line + 1)).ToHashSet();
            return rows.Where((_, i) => !fine.Contains(i)).ToArray();
        }

        /// <summary>The ways in which a row may be meant: of an object or of the type itself, read or written.</summary>
        private static IEnumerable<string> Uses(string[] row)
        {
            string type = Regex.Replace(row[1], @"\bPool$", "Pool<Body>");
            string kind = row[2], member = row[3];
            if (kind == "type")
            {
                return new[] { $"() {{ var x = typeof({type}); }}" };
            }

            if (kind == "enum value")
            {
                return new[] { $"() {{ {type} x = {type}.{member}; }}" };
            }

            Match call = Regex.Match(member, @"^(\w+)\((.*)\)$");
            string[] parameters = call.Success && call.Groups[2].Length > 0
                ? Regex.Split(call.Groups[2].Value, ", ").Select(p => Regex.Replace(p, @"\bT\b", "Body")).ToArray()
                : Array.Empty<string>();
            string declared = string.Join(", ", parameters.Select((p, i) => $"{Qualified(p, type)} a{i}"));
            string passed = string.Join(", ", parameters.Select((p, i) => $"{Regex.Match(p, "^(ref |out )?").Value}a{i}"));
            string name = call.Success ? call.Groups[1].Value : member;
            if (kind == "constructor")
            {
                return new[] { $"({declared}) {{ new {type}({passed}); }}" };
            }

            if (Operators.TryGetValue(name, out string symbol))
            {
                return new[] { parameters.Length == 1
                    ? $"({declared}) {{ var y = {symbol}a0; }}"
                    : $"({declared}) {{ var y = a0 {symbol} a1; }}" };
            }

            if (name.StartsWith("add_", StringComparison.Ordinal) || kind == "event")
            {
                string item = name.Replace("add_", string.Empty);
                return new[] { $"({type} x) {{ x.{item} += delegate {{ }}; }}" };
            }

            if (call.Success)
            {
                string comma = declared.Length > 0 ? ", " : string.Empty;
                return new[]
                {
                    $"({type} x{comma}{declared}) {{ {Set(parameters)}x.{name}({passed}); }}",
                    $"({declared}) {{ {Set(parameters)}{type}.{name}({passed}); }}",
                };
            }

            // A public field could be assigned, and so it can still be.
            return kind == "field" && name != "IsDisposed"
                ? new[] { $"({type} x) {{ x.{name} = x.{name}; }}", $"() {{ const float x = {type}.{name}; }}" }
                : new[] { $"({type} x) {{ var y = x.{name}; }}", $"() {{ var y = {type}.{name}; }}" };
        }

        /// <summary>A nested type of the owner is named with it.</summary>
        private static string Qualified(string parameter, string type)
        {
            int dot = type.LastIndexOf('.');
            return dot > 0 && parameter == type.Substring(dot + 1) ? type : parameter;
        }

        private static string Set(string[] parameters) => string.Concat(parameters
            .Select((p, i) => (p, i)).Where(pair => pair.p.StartsWith("out ", StringComparison.Ordinal))
                .Select(pair => $"a{pair.i} = default; "));

        /// <summary>Lines with an error.</summary>
        public static HashSet<int> Broken(string body)
        {
            string usings = BuildProperty.GlobalUsings + @"global using System;
global using FarseerGames.FarseerPhysics; global using FarseerGames.FarseerPhysics.Collisions;
global using FarseerGames.FarseerPhysics.Controllers; global using FarseerGames.FarseerPhysics.Dynamics;
global using FarseerGames.FarseerPhysics.Dynamics.Joints; global using FarseerGames.FarseerPhysics.Dynamics.Springs;
global using FarseerGames.FarseerPhysics.Factories; global using FarseerGames.FarseerPhysics.Interfaces;";
            var options = new CSharpParseOptions(LanguageVersion.Latest);
            SyntaxTree tree = CSharpSyntaxTree.ParseText(body, options);
            string[] assemblies = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")).Split(System.IO.Path.PathSeparator);
            var compilation = CSharpCompilation.Create(
                "Uses",
                new[] { tree, CSharpSyntaxTree.ParseText(usings, options) },
                assemblies.Append(typeof(PhysicsSimulator).Assembly.Location).Distinct().Select(a => MetadataReference.CreateFromFile(a)),
                new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));
            return compilation.GetDiagnostics()
                .Where(d => d.Severity == DiagnosticSeverity.Error && d.Location.SourceTree == tree)
                .Select(d => d.Location.GetLineSpan().StartLinePosition.Line)
                .ToHashSet();
        }
    }
}
