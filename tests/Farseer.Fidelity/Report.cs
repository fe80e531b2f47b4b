using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Farseer.Fidelity.Judging;

namespace Farseer.Fidelity;

/// <summary>Prints the verdicts: one line a scene, its checks under it where they failed or were asked for, and the sum.</summary>
public sealed class Report
{
    private const string Rules = """
        Limits. Trajectories: against `refined` at most the original's own error at its own settings
        (differenceFromRecorded); scenes without it: against the nearer recording within the spread between 5 and
        100 iterations plus the error of its first-order integrator (dt/2 times the variation of the
        velocity, dt times its jumps). Both plus rounding ((2 + sqrt(steps)) ulps; a body that `refined` holds
        still to the last bit: a velocity of half an ulp of its place in a refined step) and, where bodies may
        touch, AllowedPenetration on positions. Beside an impact a velocity may be any between the rows
        around it, and in the first sqrt(2 AllowedPenetration / g) a body at rest may still sink. What does not fit
        so is judged by the equations of motion, where they know all of the scene: at most the original's own error
        against them. Scenes run with all faults of the original, those that act are named. Events: same
        kinds, pairs and order, shifted by 2 updates plus the time to cross AllowedPenetration and the
        circle's sagitta. Queries, masses: 16 ulps. Not compared: number, place and depth of contacts.
        """;

    private readonly TextWriter _output;
    private readonly bool _verbose;
    private readonly List<Verdict> _verdicts = [];

    public Report(TextWriter output, bool verbose)
    {
        _output = output;
        _verbose = verbose;
    }

    public bool AnyFailed => _verdicts.Any(v => v.Outcome == Outcome.Fail);

    public void Begin()
    {
        _output.WriteLine(Rules);
        _output.WriteLine();
    }

    public void Add(Verdict verdict)
    {
        _verdicts.Add(verdict);
        string reason = verdict.Reason.Length == 0 ? string.Empty : "  (" + verdict.Reason + ")";
        _output.WriteLine(Word(verdict.Outcome) + " " + verdict.Scene + reason);
        foreach (Check check in verdict.Checks.Where(c => _verbose || !c.Passed || c.Limit > 0))
        {
            _output.WriteLine((check.Passed ? "       " : "     ! ") + check);
        }
    }

    /// <summary>The last line, which a program may read.</summary>
    public void End()
        => _output.WriteLine($"{Count(Outcome.Pass)} passed, {Count(Outcome.Fail)} failed, {Count(Outcome.Skip)} skipped");

    /// <summary>Every check with its limit, one a line, and for each scene whether it ran to its end.</summary>
    public void WriteCsv(TextWriter csv)
    {
        csv.WriteLine("name,value,limit,better");
        foreach (Verdict verdict in _verdicts)
        {
            bool ran = verdict.Outcome != Outcome.Skip && !(verdict.Outcome == Outcome.Fail && verdict.Checks.All(c => c.Passed));
            WriteLine(csv, verdict.Scene + " ends early", ran ? 0 : 1, 0);
            foreach (Check check in verdict.Checks)
            {
                WriteLine(csv, verdict.Scene + " " + check.What, check.Error, check.Limit);
            }
        }
    }

    private static void WriteLine(TextWriter csv, string name, double value, double limit)
        => csv.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{name.Replace(',', ';')},{value:G9},{limit:G9},less"));

    private int Count(Outcome outcome) => _verdicts.Count(v => v.Outcome == outcome);

    private static string Word(Outcome outcome) => outcome switch
    {
        Outcome.Pass => "PASS",
        Outcome.Fail => "FAIL",
        _ => "SKIP",
    };
}
