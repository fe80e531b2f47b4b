using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Farseer.Accuracy.Surveys;

/// <summary>Plays the variations of surveys and counts those that exceed their limits.</summary>
internal static class SurveyCommand
{
    /// <summary>Prints the table; true if every variation holds.</summary>
    public static bool Run(string[] args, TextWriter output)
    {
        uint seed = 1;
        int? count = null;
        string? path = null;
        var words = new List<string>();
        for (int i = 0; i < args.Length; i++)
        {
            string? value = i + 1 < args.Length ? args[i + 1] : null;
            switch (args[i])
            {
                case "--seed":
                    seed = (uint)Number(args[i], value);
                    i++;
                    break;
                case "--count":
                    count = Number(args[i], value);
                    i++;
                    break;
                case "--csv":
                    path = value ?? throw new UsageException("surveys: --csv needs a file name.");
                    i++;
                    break;
                default:
                    words.Add(args[i]);
                    break;
            }
        }

        List<Survey> chosen = Choose(words);
        using StreamWriter? csv = Cli.OpenCsv(path);
        csv?.WriteLine("survey,variation,figure,limit,held");
        output.WriteLine($"{"survey",-6} {"variations",10} {"failures",9} {"median",10} {"worst",10} {"limit",8}  of the worst");
        int passed = 0;
        int failed = 0;
        foreach (Survey survey in chosen)
        {
            var tally = new Tally(survey.Name);
            foreach (Variation variation in survey.Variations(seed, count))
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
                throw new UsageException($"surveys: '{word}' is none of {known}; --seed N, --count N and --csv FILE are known.");
            }
        }

        return chosen;
    }

    /// <summary>A kind's word stands for all its parts: K7 for K7a and K7b, K1 not for K11.</summary>
    private static bool Means(string word, string name) =>
        name == word || (name.StartsWith(word, StringComparison.Ordinal) && char.IsAsciiLetterLower(name[word.Length]));

    private static int Number(string option, string? value) =>
        int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out int number)
            ? number
            : throw new UsageException($"surveys: {option} needs a whole number of at least 0.");

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
