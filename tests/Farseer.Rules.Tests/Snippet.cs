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

    public static IEnumerable<string> Blocks(string document) =>
        Regex.Matches(document, "```csharp\n(.*?)```", RegexOptions.Singleline).Select(m => m.Groups[1].Value);

    /// <summary>What the program wrote. A warning of the compiler fails the test that runs it.</summary>
    public static string Run(string code, string where)
    {
        string trusted = (string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!;
        CSharpCompilation compilation = CSharpCompilation.Create(
            "Snippet",
            [CSharpSyntaxTree.ParseText(code, path: where)],
            trusted.Split(Path.PathSeparator).Select(f => MetadataReference.CreateFromFile(f)),
            new CSharpCompilationOptions(OutputKind.ConsoleApplication));
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
}
