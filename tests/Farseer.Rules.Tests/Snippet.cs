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

    /// <summary>Parts of the programs of the same document, as a tutorial shows them one after the other.</summary>
    public static IEnumerable<string> Parts(string document) =>
        Regex.Matches(document, "```csharp part\n(.*?)```", RegexOptions.Singleline).Select(m => m.Groups[1].Value);

    /// <summary>Whether the lines of a part stand one after the other in a program, however far they are indented.</summary>
    public static bool IsPartOf(string part, string program)
    {
        string[] lines = Lines(part);
        string[] all = Lines(program);
        return Enumerable.Range(0, Math.Max(0, all.Length - lines.Length + 1))
            .Any(i => all.Skip(i).Take(lines.Length).SequenceEqual(lines));
    }

    private static string[] Lines(string code) =>
        code.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);

    /// <summary>Code for another engine, with the name of the stub that stands for it.</summary>
    public static IEnumerable<(string Engine, string Code)> ForEngines(string document) =>
        Regex.Matches(document, "```csharp stub:(\\w+)\n(.*?)```", RegexOptions.Singleline)
            .Select(m => (m.Groups[1].Value, m.Groups[2].Value));

    /// <summary>Names of the pictures that a program saves where it runs.</summary>
    public static IEnumerable<string> Pictures(string code) => Regex.Matches(code, "\"([a-z-]+\\.svg)\"").Select(m => m.Groups[1].Value);

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

    /// <summary>What a program of one file says to <c>dotnet run</c> is not for the compiler.</summary>
    private static string WithoutDirectives(string code) => Regex.Replace(code, "^#:.*$", string.Empty, RegexOptions.Multiline);

    private static CSharpCompilation Compilation(OutputKind kind, params (string Code, string Where)[] sources)
    {
        string trusted = (string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!;
        return CSharpCompilation.Create(
            "Snippet",
            sources.Select(s => CSharpSyntaxTree.ParseText(WithoutDirectives(s.Code), path: s.Where)),
            trusted.Split(Path.PathSeparator).Select(f => MetadataReference.CreateFromFile(f)),
            new CSharpCompilationOptions(kind));
    }
}
