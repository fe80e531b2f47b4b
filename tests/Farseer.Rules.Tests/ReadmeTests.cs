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

public sealed class ReadmeTests
{
    private static readonly string _text = File.ReadAllText(Path.Combine(Repository.Root, "README.md"));

    [Fact]
    public void Commands_NameWhatExists()
    {
        List<string> commands = [.. Regex.Matches(_text, "^dotnet .*$", RegexOptions.Multiline).Select(m => m.Value.Trim())];

        Assert.Contains("dotnet run -c Release --project samples/Farseer.Samples", commands);
        Assert.Contains("dotnet test -c Release Farseer.sln", commands);
        Assert.True(File.Exists(Path.Combine(Repository.Root, "samples", "Farseer.Samples", "Farseer.Samples.csproj")));
    }

    [Fact]
    public void Code_CompilesAndLetsTheBoxRestOnTheFloor()
    {
        List<string> blocks = [.. Regex.Matches(_text, "```csharp\n(.*?)```", RegexOptions.Singleline).Select(m => m.Groups[1].Value)];

        string output = string.Concat(blocks.Select(Run));

        // The floor's top is at 0.5 and half the box is 0.5; a contact rests at AllowedPenetration = 0.05 below.
        Match y = Regex.Match(output, @"^the box rests at y = (-?\d+\.\d+)\s*$");
        Assert.True(y.Success, output);
        Assert.InRange(double.Parse(y.Groups[1].Value, System.Globalization.CultureInfo.InvariantCulture), 0.94, 1.0);
    }

    private static string Run(string code)
    {
        string trusted = (string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!;
        CSharpCompilation compilation = CSharpCompilation.Create(
            "Readme",
            [CSharpSyntaxTree.ParseText(code)],
            trusted.Split(Path.PathSeparator).Select(f => MetadataReference.CreateFromFile(f)),
            new CSharpCompilationOptions(OutputKind.ConsoleApplication));
        using MemoryStream image = new();
        EmitResult result = compilation.Emit(image);
        Assert.Empty(result.Diagnostics.Where(d => d.Severity >= DiagnosticSeverity.Warning));

        MethodInfo main = Assembly.Load(image.ToArray()).EntryPoint!;
        TextWriter before = Console.Out;
        using StringWriter output = new();
        Console.SetOut(output);
        try
        {
            main.Invoke(null, [Array.Empty<string>()]);
        }
        finally
        {
            Console.SetOut(before);
        }

        return output.ToString();
    }
}
