using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Xunit;

namespace Farseer.Rules.Tests;

public sealed class SourceTests
{
    private static readonly string[] _places = ["src", "tests", "samples", "benchmarks"];

    private static readonly string[] _emptyNames = ["Helper", "Utils", "Manager", "Common", "Misc"];

    // Spelled in two parts, so that this file passes its own rule.
    private static readonly Regex _leftOver = new(@"\b(TO" + @"DO|FIX" + @"ME|HA" + @"CK)\b");

    [Fact]
    public void File_HasAtMost500Lines()
    {
        Assert.DoesNotContain(Lengths(), f => f.Lines > 500);
    }

    [Fact]
    public void MedianFile_HasFewerThan150Lines()
    {
        List<int> lengths = [.. Lengths().Select(f => f.Lines).Order()];

        Assert.True(lengths[lengths.Count / 2] < 150, "median " + lengths[lengths.Count / 2]);
    }

    [Fact]
    public void Method_HasAtMost120Lines()
    {
        IEnumerable<string> wrong =
            from file in Repository.Files("src", "*.cs")
            from member in Parse(file).DescendantNodes()
            where member is BaseMethodDeclarationSyntax or AccessorDeclarationSyntax or LocalFunctionStatementSyntax
            let span = member.GetLocation().GetLineSpan()
            let lines = span.EndLinePosition.Line - span.StartLinePosition.Line + 1
            where lines > 120
            select $"{Repository.Relative(file)}({span.StartLinePosition.Line + 1}): {lines}";

        Assert.Empty(wrong);
    }

    [Fact]
    public void EngineName_SaysSomething()
    {
        IEnumerable<string> names = Repository.Files("src/Farseer.Engine", "*.cs")
            .SelectMany(f => Parse(f).DescendantNodes().OfType<BaseTypeDeclarationSyntax>().Select(t => t.Identifier.Text)
                .Append(Repository.Relative(f)));

        Assert.DoesNotContain(names, n => _emptyNames.Any(e => n.Contains(e, StringComparison.Ordinal)));
    }

    [Fact]
    public void Comment_IsNotCode()
    {
        IEnumerable<string> wrong =
            from place in _places
            from file in Repository.Files(place, "*.cs")
            from trivia in Parse(file).DescendantTrivia()
            where trivia.IsKind(SyntaxKind.SingleLineCommentTrivia)
            let text = trivia.ToString().TrimEnd()
            where text.EndsWith(';') && IsStatement(text[2..])
            select Repository.Relative(file) + ": " + text;

        Assert.Empty(wrong);
    }

    [Fact]
    public void Source_HasNoLeftOverMarks()
    {
        Assert.Empty(_places.SelectMany(p => Repository.Files(p, "*.cs"))
            .Where(f => _leftOver.IsMatch(File.ReadAllText(f)))
            .Select(Repository.Relative));
    }

    private static List<(string File, int Lines)> Lengths() =>
        [.. Repository.Files("src", "*.cs").Select(f => (Repository.Relative(f), File.ReadLines(f).Count()))];

    private static SyntaxNode Parse(string file) => CSharpSyntaxTree.ParseText(File.ReadAllText(file)).GetRoot();

    // A sentence that happens to end in a semicolon does not parse; an assignment or a call does.
    private static bool IsStatement(string text)
    {
        StatementSyntax statement = SyntaxFactory.ParseStatement(text.Trim());
        return !statement.ContainsDiagnostics && statement.ToString().Contains('(', StringComparison.Ordinal)
            && statement is ExpressionStatementSyntax { Expression: InvocationExpressionSyntax or AssignmentExpressionSyntax };
    }
}
