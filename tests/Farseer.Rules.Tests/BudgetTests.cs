using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>How large a type may be, and how long a line.</summary>
public sealed class BudgetTests
{
    private const int MostLines = 1000;
    private const int MostFiles = 3;
    private const int MostColumns = 140;
    private const int MostParameters = 8;

    private static readonly string[] _places = ["src", "tests", "samples", "benchmarks"];

    // Types that are larger, with the lines and files that they have at most. Those of the facades are the interfaces of the originals,
    // with a comment for each member. An entry may only shrink.
    private static readonly Dictionary<string, (int Lines, int Files)> _larger = new()
    {
        ["PhysicsSimulator"] = (3345, 17),
        ["Body"] = (1510, 6),
        ["b2World"] = (1300, 7),
        ["Geom"] = (1210, 6),
        ["Vertices"] = (1010, 5),
        ["b2Body"] = (810, 4),
        ["GeomFactory"] = (790, 6),
    };

    // Methods with more parameters, and how many they have at most. The documented interfaces of the originals prescribe those of
    // Calculator and ComplexFactory. Tracing tools read the names of an event's numbers from its method's parameters. Strides of a chain as
    // one argument made the code of ChainSolve longer. An entry may only shrink.
    private static readonly Dictionary<string, int> _longer = new()
    {
        ["Calculator.BiLerp"] = 9,
        ["ChainSolve.Reduce"] = 9,
        ["ComplexFactory.CreateChain"] = 10,
        ["ComplexFactory.CreateRope"] = 9,
        ["StepEventSource.Step"] = 16,
    };

    // What is for the newer framework alone counts too.
    private static readonly CSharpParseOptions _parsing = new(LanguageVersion.Preview, preprocessorSymbols: ["NET", "NET8_0_OR_GREATER"]);

    [Fact]
    public void Type_HasAtMost1000LinesInThreeFiles()
    {
        var types = Repository.Files("src", "*.cs")
            .Select(f => (Text: File.ReadAllText(f), File: f))
            .Select(f => (Type: NameOf(f.Text), Lines: f.Text.Count(c => c == '\n'), Project: Repository.Relative(f.File).Split('/')[1]))
            .Where(f => f.Type is not null)
            .GroupBy(f => (f.Project, f.Type))
            .Select(g => (Type: g.Key.Type!, Lines: g.Sum(f => f.Lines), Files: g.Count()))
            .ToList();

        Assert.True(types.Count > 500, "only " + types.Count + " types were found");
        Assert.Empty(types.Where(t => IsOver(t.Type, t.Lines, t.Files)).Select(t => $"{t.Type}: {t.Lines} lines in {t.Files} files"));
    }

    [Fact]
    public void Line_HasAtMost140Columns()
    {
        IEnumerable<string> longer =
            from place in _places
            from file in Repository.Files(place, "*.cs")
            from line in File.ReadLines(file).Select((text, number) => (Text: text, Number: number + 1))
            where line.Text.Length > MostColumns
            select $"{Repository.Relative(file)}({line.Number}): {line.Text.Length}";

        Assert.Empty(longer);
    }

    [Fact]
    public void EngineTypes_ShareNoName()
    {
        // A guarded build has stores of its own in place of the others.
        IEnumerable<string> twice = Repository.Files("src/Farseer.Engine", "*.cs")
            .Where(f => !f.Contains("Guarded", StringComparison.Ordinal))
            .SelectMany(f => CSharpSyntaxTree.ParseText(File.ReadAllText(f)).GetRoot().DescendantNodes(n => n is not TypeDeclarationSyntax))
            .OfType<TypeDeclarationSyntax>()
            .Where(t => !t.Modifiers.Any(SyntaxKind.PartialKeyword))
            .GroupBy(t => t.Identifier.Text + "`" + t.Arity)
            .Where(g => g.Count() > 1)
            .Select(g => g.Key);

        Assert.Empty(twice);
    }

    [Fact]
    public void Method_HasAtMost8Parameters()
    {
        var methods = Repository.Files("src", "*.cs")
            .SelectMany(f => CSharpSyntaxTree.ParseText(File.ReadAllText(f), _parsing).GetRoot().DescendantNodes())
            .Select(n => (Node: n, Parameters: ParametersOf(n)))
            .Where(m => m.Parameters is not null && !IsExtern(m.Node))
            .Select(m => (Name: FullNameOf(m.Node), m.Parameters!.Parameters.Count))
            .ToList();

        Assert.True(methods.Count > 5000, "only " + methods.Count + " methods were found");
        Assert.Empty(methods.Where(m => m.Count > _longer.GetValueOrDefault(m.Name, MostParameters)).Select(m => $"{m.Name}: {m.Count}"));

        // An exception that has shrunk shrinks here too.
        var most = methods.GroupBy(m => m.Name).ToDictionary(g => g.Key, g => g.Max(m => m.Count));
        Assert.Empty(_longer.Where(l => most.GetValueOrDefault(l.Key) < l.Value).Select(l => $"{l.Key}: {most.GetValueOrDefault(l.Key)}"));
    }

    private static BaseParameterListSyntax? ParametersOf(SyntaxNode node) => node switch
    {
        BaseMethodDeclarationSyntax method => method.ParameterList,
        LocalFunctionStatementSyntax local => local.ParameterList,
        TypeDeclarationSyntax type => type.ParameterList,
        DelegateDeclarationSyntax type => type.ParameterList,
        IndexerDeclarationSyntax indexer => indexer.ParameterList,
        _ => null,
    };

    private static bool IsExtern(SyntaxNode node) =>
        node is MemberDeclarationSyntax member && member.Modifiers.Any(SyntaxKind.ExternKeyword);

    // Its own name behind that of the type around it; that of a constructor is the type's.
    private static string FullNameOf(SyntaxNode node)
    {
        string? type = node.Ancestors().OfType<TypeDeclarationSyntax>().FirstOrDefault()?.Identifier.Text;
        string name = node switch
        {
            MethodDeclarationSyntax method => method.Identifier.Text,
            ConstructorDeclarationSyntax constructor => constructor.Identifier.Text,
            LocalFunctionStatementSyntax local => local.Identifier.Text,
            BaseTypeDeclarationSyntax named => named.Identifier.Text,
            DelegateDeclarationSyntax named => named.Identifier.Text,
            _ => node.Kind().ToString(),
        };
        return type is null ? name : type + "." + name;
    }

    private static bool IsOver(string type, int lines, int files) =>
        _larger.TryGetValue(type, out (int Lines, int Files) most)
            ? lines > most.Lines || files > most.Files
            : lines > MostLines || files > MostFiles;

    // The first type of a file gives it its name.
    private static string? NameOf(string text) =>
        CSharpSyntaxTree.ParseText(text).GetRoot().DescendantNodes(n => n is not BaseTypeDeclarationSyntax)
            .OfType<BaseTypeDeclarationSyntax>().FirstOrDefault()?.Identifier.Text;
}
