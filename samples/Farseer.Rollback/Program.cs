using System;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;

namespace Farseer.Rollback;

/// <summary>Plays a match of two sides over UDP with rollback, and prints what it cost and that both sides agree.</summary>
internal static class Program
{
    private static int Main(string[] args)
    {
        Option<double> seconds = Number("--seconds", 30, 0.1, 3600.0, "length of the match");
        Option<double> latency = Number("--latency", 60, 0, 2000.0, "least time of a packet under way, ms");
        Option<double> jitter = Number("--jitter", 30, 0, 2000.0, "most time on top of it, ms");
        Option<double> loss = Number("--loss", 5, 0, 95.0, "packets lost, percent");
        Option<int> delay = Number("--input-delay", 2, 0, 30, "frames after which an own input acts");
        Option<int> ahead = Number("--most-ahead", 20, 1, 300, "frames that a side may do without the other's input");
        Option<double> pace = Number("--pace", 4.0, 0.1, 100, "times as fast as the clock");
        Option<int> seed = Number("--seed", 1, 0, 1_000_000, "of the players' whims and of what is lost");
        RootCommand root = new("Two players over a poor line: each side predicts, goes back and does again.")
        {
            seconds, latency, jitter, loss, delay, ahead, pace, seed,
        };
        root.SetAction(words => Play(new MatchOptions(
            (int)Math.Ceiling(words.GetValue(seconds) / BallGame.Dt),
            new LineQuality(words.GetValue(latency), words.GetValue(jitter), words.GetValue(loss)),
            words.GetValue(delay),
            words.GetValue(ahead),
            words.GetValue(pace),
            words.GetValue(seed))));
        return root.Parse(args).Invoke();
    }

    private static int Play(MatchOptions options)
    {
        using Match match = new(options);
        try
        {
            match.Play();
        }
        catch (TimeoutException e)
        {
            Console.Error.WriteLine("error: " + e.Message);
            return 1;
        }

        LineQuality line = options.Quality;
        Write($"{options.Frames} frames; {line.Latency} to {line.Latency + line.Jitter} ms, {line.Loss} % lost; seed {options.Seed}");
        for (int i = 0; i < BallGame.Players; i++)
        {
            Tell(match, i);
        }

        ulong straight = match.Straight();
        Write($"score {match.Game(0).LeftGoals} : {match.Game(0).RightGoals}");
        Write($"checksums {match.Game(0).Checksum:x16} and {match.Game(1).Checksum:x16}");
        Write($"of the same inputs without rollback {straight:x16}");
        bool isEqual = match.Game(0).Checksum == straight && match.Game(1).Checksum == straight
            && match.Peer(0).Figures.Unequal + match.Peer(1).Figures.Unequal == 0;
        Console.WriteLine(isEqual ? "both sides agree, bit for bit" : "THE SIDES DIFFER");
        return isEqual ? 0 : 1;
    }

    private static void Tell(Match match, int number)
    {
        PeerFigures figures = match.Peer(number).Figures;
        double mean = figures.Rollbacks > 0 ? (double)figures.FramesAgain / figures.Rollbacks : 0;
        Write($"player {number + 1}: {match.Line(number).Lost} of {match.Line(number).Sent} packets lost, waited {figures.Waits} ticks");
        Write($"  {figures.Rollbacks} rollbacks, {figures.FramesAgain} frames again");
        Write($"  depth {mean:0.0} on average, {figures.Deepest} at most");
        double longest = figures.LongestRollback.TotalMicroseconds;
        Write($"  a rollback {PerOne(figures.RollbackTime, figures.Rollbacks):0} us on average, {longest:0} at most");
        Write($"  a save {PerOne(figures.SaveTime, figures.Saves):0.0} us");
        Write($"  depths {string.Join(", ", figures.Depths.Select(d => FormattableString.Invariant($"{d.Key}: {d.Value}")))}");
        Write($"  {figures.Checked} checksums of the other compared on the way, {figures.Unequal} unequal");
    }

    private static double PerOne(TimeSpan time, int count) => count > 0 ? time.TotalMicroseconds / count : 0;

    private static void Write(FormattableString text) => Console.WriteLine(text.ToString(CultureInfo.InvariantCulture));

    private static Option<T> Number<T>(string name, T usual, T least, T most, string description)
        where T : IComparable<T>, IParsable<T>
    {
        Option<T> option = new(name) { Description = description, DefaultValueFactory = _ => usual };
        option.Validators.Add(result => Check(result, name, least, most));
        return option;
    }

    private static void Check<T>(OptionResult result, string name, T least, T most)
        where T : IComparable<T>, IParsable<T>
    {
        string text = result.Tokens.Count == 1 ? result.Tokens[0].Value : string.Empty;
        if (T.TryParse(text, CultureInfo.InvariantCulture, out T? value) && (value.CompareTo(least) < 0 || value.CompareTo(most) > 0))
        {
            result.AddError(FormattableString.Invariant($"{name} must be from {least} to {most}, not {value}."));
        }
    }
}
