using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Numerics;
using Farseer.CommandLines;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Truth;

/// <summary>
/// Whether reports and budgets tell the truth: random scenes, one update of each done once as it is and once with 64 times the iterations
/// from the same state. The scene is built twice from its seed, and both do the same updates before.
/// </summary>
internal static class TruthfulCommand
{
    private const int Finer = 64;

    /// <summary>Share of the scenes in which the truth is within what was reported.</summary>
    private const double Share = 0.99;

    /// <summary>The truth is never more than so many times what was reported.</summary>
    private const double Most = 3;

    /// <summary>Share of a budget from which on it matters whether the finer run is itself exact.</summary>
    private const double DoubtShare = 0.1;

    /// <summary>Budgets that each scene is asked to keep, m.</summary>
    private static readonly float[] _budgets = [1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f];

    private static readonly Option<int> _count = Values.Whole("--count", "scenes", 1, int.MaxValue, 300);
    private static readonly Option<int> _seed = Values.Whole("--seed", "draws the scenes", 1, int.MaxValue, 1);
    private static readonly ValueOption<string?> _csv = Values.File("--csv", "writes the figures to a file too");

    public static Command Create() => Cli.Judged(
        "truthful",
        "Whether reports and budgets tell the truth, on random scenes against 64 times the iterations.",
        Run,
        _count,
        _seed,
        _csv);

    private static bool Run(ParseResult result)
    {
        TextWriter output = result.Output();
        int count = result.GetValue(_count);
        int seed = result.GetValue(_seed);
        using StreamWriter? csv = Values.Open(_csv.Name, result.GetValue(_csv));
        var kinds = new Dictionary<string, Tally>();
        var all = new Tally("all");
        foreach (string kind in RandomScene.Kinds)
        {
            kinds[kind] = new Tally(kind);
        }

        for (int i = 0; i < count; i++)
        {
            int scene = unchecked((seed - 1) * count) + i;
            Case one = Try(scene);
            kinds[one.Kind].Add(one);
            all.Add(one);
            if (one.Lie is not null)
            {
                output.WriteLine(Text($"seed {scene} ({one.Kind}): {one.Lie}"));
            }

            if (one.Truth > Most * one.Reported)
            {
                output.WriteLine(Text($"seed {scene} ({one.Kind}): true {one.Truth:G3} m, reported {one.Reported:G3} m"));
            }
        }

        output.WriteLine("scenes      count   within    worst   motion  median over  90 % over  lies");
        foreach (Tally tally in kinds.Values)
        {
            tally.Print(output);
        }

        all.Print(output);
        int passed = 0;
        int failed = 0;
        string within = Text($"true error within the report's in {all.Within:P1} of the scenes, asked {Share:P0}");
        Check(output, within, all.Within >= Share, ref passed, ref failed);
        Check(output, Text($"and at most {all.Worst:0.00} times it, asked {Most}"), all.Worst <= Most, ref passed, ref failed);
        string budgets =
            Text($"budgets kept or flagged in {all.Told} of {all.Asked}, said to be kept {all.Kept}, unknown {all.Unknown} besides");
        Check(output, budgets, all.Told == all.Asked, ref passed, ref failed);
        output.WriteLine($"{passed} passed, {failed} failed");
        if (csv is not null)
        {
            TruthFigure.Write(csv, Figures(all, kinds.Values));
        }

        return failed == 0;
    }

    /// <summary>What is asked of all scenes, and by kind what holds for each of them.</summary>
    private static List<TruthFigure> Figures(Tally all, IEnumerable<Tally> kinds)
    {
        var figures = new List<TruthFigure> { new("all within", all.Within, Share, true) };
        foreach (Tally tally in kinds)
        {
            figures.Add(new($"{tally.Name} worst", tally.Worst, Most, false));
            figures.Add(new($"{tally.Name} budgets_untold", tally.Asked - tally.Told, 0, false));
        }

        return figures;
    }

    private static string Text(FormattableString text) => FormattableString.Invariant(text);

    private static void Check(TextWriter output, string what, bool holds, ref int passed, ref int failed)
    {
        output.WriteLine($"{what}: {(holds ? "PASS" : "FAIL")}");
        passed += holds ? 1 : 0;
        failed += holds ? 0 : 1;
    }

    private static Case Try(int seed)
    {
        using RandomScene plain = RandomScene.Build(seed);
        using RandomScene exact = RandomScene.Build(seed);
        Lead(plain);
        Lead(exact);
        exact.Simulator.Iterations = Finer * plain.Simulator.Iterations;
        double rounding = Rounding(exact);
        plain.Simulator.Update(plain.Dt);
        exact.Simulator.Update(exact.Dt);
        StepReport report = plain.Simulator.Report;
        var one = new Case(plain.Kind)
        {
            Truth = Math.Max(0, Difference(plain, exact) - rounding),
            Reported = report.Error,
            Motion = report.MotionError,
        };
        foreach (float budget in _budgets)
        {
            AskFor(seed, budget, one);
        }

        return one;
    }

    /// <summary>
    /// One update with a budget: what it says of it is held against the truth. The finer run has 64 times the iterations of the dial, and
    /// at least four times those that the budget took. Not 64 times these: with thousands of substeps a step the rounding of gaps, divided
    /// by the substep, drives bodies apart. Where that shows already, because half as many iterations come closer to the run in question
    /// than to the finer one, nobody knows the truth.
    /// </summary>
    private static void AskFor(int seed, float length, Case one)
    {
        using RandomScene asked = RandomScene.Build(seed);
        int dial = asked.Simulator.Iterations;
        asked.Simulator.ErrorBudget = ErrorBudget.OfLength(length);
        Lead(asked);
        asked.Simulator.Update(asked.Dt);
        int finer = Math.Max(Finer * dial, 4 * asked.Simulator.Report.Iterations);
        using RandomScene exact = RunFiner(seed, length, finer, out double rounding);
        using RandomScene half = RunFiner(seed, length, finer / 2, out _);
        StepReport report = asked.Simulator.Report;
        double doubt = Difference(half, exact);
        double truth = Difference(asked, exact) - rounding;
        bool told = truth <= length || !report.IsWithinBudget;
        if (!told && doubt > DoubtShare * length && 2 * doubt > Difference(asked, half))
        {
            one.Unknown++;
            return;
        }

        one.Asked++;
        one.Kept += report.IsWithinBudget ? 1 : 0;
        one.Told += told ? 1 : 0;
        one.Lie = told ? one.Lie : FormattableString.Invariant($"{length} m asked, true {truth:G3} m, told {report.Error:G3} m");
    }

    /// <summary>It has a budget too, for that decides how deep bodies rest, and as many iterations as it is told.</summary>
    private static RandomScene RunFiner(int seed, float length, int iterations, out double rounding)
    {
        RandomScene scene = RandomScene.Build(seed);
        scene.Simulator.ErrorBudget = ErrorBudget.OfLength(length);
        Lead(scene);
        scene.Simulator.Iterations = iterations;
        rounding = Rounding(scene);
        scene.Simulator.Update(scene.Dt);
        return scene;
    }

    private static void Lead(RandomScene scene)
    {
        for (int i = 0; i < scene.Lead; i++)
        {
            // What slips is known from the second update on that is looked at.
            scene.Simulator.EnableReport = i >= scene.Lead - 2;
            scene.Simulator.Update(scene.Dt);
        }

        scene.Simulator.EnableReport = true;
    }

    /// <summary>
    /// What the finer run itself may be off by: each of its substeps rounds a velocity and a displacement to a float, by half a unit in the
    /// last place at most, and a contact reads its gap to half a unit of the body's size and holds the body there, now here and now there.
    /// </summary>
    private static double Rounding(RandomScene exact)
    {
        const double HalfUnit = 1.0 / (1 << 24);
        double fastest = 0;
        double farthest = 0;
        double largest = 0;
        foreach (Body body in exact.Bodies)
        {
            double radius = Math.Sqrt(body.MomentOfInertia / body.Mass);
            double turn = Math.Abs(body.AngularVelocity) * radius;
            largest = Math.Max(largest, 2 * radius);
            fastest = Math.Max(fastest, body.LinearVelocity.Length() + turn);
            farthest = Math.Max(farthest, Math.Max(Math.Abs(body.Position.X), Math.Abs(body.Position.Y)));
        }

        int substeps = exact.Simulator.Iterations;
        double gaps = HalfUnit * largest * Math.Sqrt(substeps);
        return (HalfUnit * substeps * (fastest + (10 * exact.Dt)) * exact.Dt) + (2 * HalfUnit * farthest) + gaps;
    }

    private static double Difference(RandomScene mine, RandomScene other)
    {
        double worst = 0;
        for (int i = 0; i < mine.Bodies.Count; i++)
        {
            Body a = mine.Bodies[i];
            Body b = other.Bodies[i];
            double turn = Math.IEEERemainder((double)a.Rotation - b.Rotation, 2 * Math.PI);
            double radius = Math.Sqrt(a.MomentOfInertia / a.Mass);
            worst = Math.Max(worst, Vector2.Distance(a.Position, b.Position) + (Math.Abs(turn) * radius));
        }

        return worst;
    }

    private sealed class Case(string kind)
    {
        public string Kind { get; } = kind;

        public double Truth { get; init; }

        public double Reported { get; init; }

        public double Motion { get; init; }

        public int Asked { get; set; }

        public int Told { get; set; }

        public int Kept { get; set; }

        /// <summary>Budgets of which nobody knows whether they were kept.</summary>
        public int Unknown { get; set; }

        public string? Lie { get; set; }
    }

    private sealed class Tally(string name)
    {
        private readonly List<double> _over = [];
        private int _within;
        private int _motionWithin;
        private int _count;

        public string Name { get; } = name;

        public double Within => _within / (double)Math.Max(1, _count);

        public double Worst { get; private set; }

        public int Asked { get; private set; }

        public int Told { get; private set; }

        public int Kept { get; private set; }

        public int Unknown { get; private set; }

        public void Add(Case one)
        {
            _count++;
            _within += one.Truth <= one.Reported ? 1 : 0;
            _motionWithin += one.Truth <= one.Motion ? 1 : 0;
            Worst = one.Truth > 0 ? Math.Max(Worst, one.Truth / one.Reported) : Worst;
            Asked += one.Asked;
            Told += one.Told;
            Kept += one.Kept;
            Unknown += one.Unknown;
            if (one.Truth > 0)
            {
                _over.Add(one.Motion / one.Truth);
            }
        }

        public void Print(TextWriter output)
        {
            _over.Sort();
            string median = _over.Count > 0 ? Text($"{_over[_over.Count / 2]:0.0}") : "–";
            string ninety = _over.Count > 0 ? Text($"{_over[_over.Count * 9 / 10]:0.0}") : "–";
            double motion = _motionWithin / (double)Math.Max(1, _count);
            string shares = Text($"{Name,-10} {_count,6} {Within,8:P1} {Worst,8:0.00} {motion,8:P1}");
            output.WriteLine(Text($"{shares} {median,12} {ninety,10} {Asked - Told,5}"));
        }
    }
}
