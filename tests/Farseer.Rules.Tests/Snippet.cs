using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.Emit;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>A block of C# in a document: a whole program, which is compiled as a reader would and run.</summary>
internal static class Snippet
{
    private static readonly object _console = new();

    /// <summary>Programs with what is said below them that they print, or null.</summary>
    public static IEnumerable<(string Code, string? Output)> Programs(string document) =>
        Regex.Matches(document, "```csharp\n(.*?)```(?:\n+(?:It prints:\n+)?```text\n(.*?)```)?", RegexOptions.Singleline)
            .Select(m => (m.Groups[1].Value, m.Groups[2].Success ? m.Groups[2].Value : null));

    /// <summary>Code for another engine, with the name of the stub that stands for it.</summary>
    public static IEnumerable<(string Engine, string Code)> ForEngines(string document) =>
        Regex.Matches(document, "```csharp stub:(\\w+)\n(.*?)```", RegexOptions.Singleline)
            .Select(m => (m.Groups[1].Value, m.Groups[2].Value));

    public static IEnumerable<string> Blocks(string document) =>
        Regex.Matches(document, "```csharp\n(.*?)```", RegexOptions.Singleline).Select(m => m.Groups[1].Value);

    /// <summary>
    /// Errors and warnings of code for another engine. That references may be null is not said there: none of them writes so.
    /// </summary>
    public static IEnumerable<Diagnostic> Compile(string code, string stub, string where)
    {
        bool isProgram = Regex.IsMatch(code, "^Raylib\\.", RegexOptions.Multiline);
        return Compilation(isProgram ? OutputKind.ConsoleApplication : OutputKind.DynamicallyLinkedLibrary, (code, where), (stub, "stub"))
            .GetDiagnostics()
            .Where(d => d.Severity >= DiagnosticSeverity.Warning);
    }

    /// <summary>What the program wrote. A warning of the compiler fails the test that runs it.</summary>
    public static string Run(string code, string where)
    {
        CSharpCompilation compilation = Compilation(OutputKind.ConsoleApplication, (code, where));
        using MemoryStream image = new();
        EmitResult result = compilation.Emit(image);
        Assert.Empty(result.Diagnostics.Where(d => d.Severity >= DiagnosticSeverity.Warning));

        MethodInfo main = Assembly.Load(image.ToArray()).EntryPoint!;
        lock (_console)
        {
            TextWriter before = Console.Out;
            using StringWriter output = new();
            Console.SetOut(output);
            try
            {
                main.Invoke(null, main.GetParameters().Length == 0 ? [] : [Array.Empty<string>()]);
            }
            finally
            {
                Console.SetOut(before);
            }

            return output.ToString();
        }
    }

    private static CSharpCompilation Compilation(OutputKind kind, params (string Code, string Where)[] sources)
    {
        string trusted = (string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!;
        return CSharpCompilation.Create(
            "Snippet",
            sources.Select(s => CSharpSyntaxTree.ParseText(s.Code, path: s.Where)),
            trusted.Split(Path.PathSeparator).Select(f => MetadataReference.CreateFromFile(f)),
            new CSharpCompilationOptions(kind));
    }
}
