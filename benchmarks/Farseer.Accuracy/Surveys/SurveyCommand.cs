using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.CommandLines;

namespace Farseer.Accuracy.Surveys;

/// <summary>Plays the variations of surveys and counts those that exceed their limits.</summary>
internal static class SurveyCommand
{
    private static readonly Argument<string[]> _words = new("kind") { Description = "kinds of faults, such as K1; none: all" };
    private static readonly Option<int> _seed = Values.Whole("--seed", "draws the random variations", 0, int.MaxValue, 1);
    private static readonly ValueOption<int?> _count = Values.Whole("--count", "random variations of each kind", 0);
    private static readonly ValueOption<string?> _csv = Values.File("--csv", "writes the figures to a file too");

    public static Command Create() => Cli.Judged(
        "surveys", "Kinds of faults found before, each in a grid of variations and in random ones.", Run, _words, _seed, _count, _csv);

    private static bool Run(ParseResult result)
    {
        TextWriter output = result.Output();
        List<Survey> chosen = Choose([.. result.GetValue(_words) ?? []]);
        using StreamWriter? csv = Values.Open(_csv.Name, result.GetValue(_csv));
        csv?.WriteLine("survey,variation,figure,limit,held");
        output.WriteLine($"{"survey",-6} {"variations",10} {"failures",9} {"median",10} {"worst",10} {"limit",8}  of the worst");
        int passed = 0;
        int failed = 0;
        foreach (Survey survey in chosen)
        {
            var tally = new Tally(survey.Name);
            foreach (Variation variation in survey.Variations((uint)result.GetValue(_seed), result.GetValue(_count)))
            {
                tally.Take(variation, csv);
            }

            output.WriteLine(tally.Row());
            output.WriteLine($"       {survey.What}");
            output.Flush();
            passed += tally.Passed;
            failed += tally.Failed;
        }

        output.WriteLine($"{passed} passed, {failed} failed");
        return failed == 0;
    }

    private static List<Survey> Choose(List<string> words)
    {
        var chosen = new List<Survey>();
        foreach (Survey survey in Survey.All)
        {
            if (words.Count == 0 || words.Exists(word => Means(word, survey.Name)))
            {
                chosen.Add(survey);
            }
        }

        foreach (string word in words)
        {
            if (!chosen.Exists(survey => Means(word, survey.Name)))
            {
                var names = new List<string>();
                foreach (Survey survey in Survey.All)
                {
                    names.Add(survey.Name);
                }

                string known = string.Join(", ", names);
                throw new UsageException($"surveys: '{word}' is none of {known}.");
            }
        }

        return chosen;
    }

    /// <summary>A kind's word stands for all its parts: K7 for K7a and K7b, K1 not for K11.</summary>
    private static bool Means(string word, string name) =>
        name == word || (name.StartsWith(word, StringComparison.Ordinal) && char.IsAsciiLetterLower(name[word.Length]));

    /// <summary>What became of a survey's variations.</summary>
    private sealed class Tally(string name)
    {
        private readonly List<double> _figures = [];
        private Variation? _worst;
        private double _worstFigure;

        public int Passed { get; private set; }

        public int Failed { get; private set; }

        public void Take(Variation variation, StreamWriter? csv)
        {
            double figure = variation.Measure();
            bool holds = figure <= variation.Limit;
            Passed += holds ? 1 : 0;
            Failed += holds ? 0 : 1;

            // What is no number is worse than any.
            double rank = double.IsNaN(figure) ? double.PositiveInfinity : figure;
            _figures.Add(rank);
            if (_worst is null || rank - variation.Limit > _worstFigure - _worst.Limit)
            {
                _worst = variation;
                _worstFigure = rank;
            }

            csv?.WriteLine(FormattableString.Invariant($"{name},\"{variation.What}\",{figure:G6},{variation.Limit:G6},{(holds ? 1 : 0)}"));
        }

        public string Row()
        {
            _figures.Sort();
            double median = _figures.Count == 0 ? 0 : _figures[_figures.Count / 2];
            return string.Create(
                CultureInfo.InvariantCulture,
                $"{name,-6} {_figures.Count,10} {Failed,9} {median,10:G4} {_worstFigure,10:G4} {_worst?.Limit,8:G3}  {_worst?.What}");
        }
    }
}
