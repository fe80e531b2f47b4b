using System;
using System.Globalization;
using Farseer.CommandLines;
using Farseer.Samples.Terminal;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;
using Spectre.Console;

namespace Farseer.Samples.Commands;

/// <summary>Sweeps the dials on a scene and prints the cheapest setting that keeps an error, with the curve.</summary>
internal static class AdviseCommand
{
    /// <summary>Seconds of the scene that are tried at most: every setting runs twice.</summary>
    private const float LongestSeconds = 10;

    /// <summary>Share of the scene's longer side that is asked for if the command line names no error.</summary>
    private const float UsualShare = 1e-4f;

    private const int Fine = 0;
    private const int NotReached = 1;

    public static int Execute(RunOptions options)
    {
        Scene scene = SceneSelection.Find(options.Scene);
        float seconds = Math.Min((options.Steps ?? scene.Steps) * scene.Dt, LongestSeconds);
        float error = options.Error
            ?? UsualShare * Math.Max(scene.View.Max.X - scene.View.Min.X, scene.View.Max.Y - scene.View.Min.Y);
        Console.WriteLine(
            FormattableString.Invariant($"{scene.Title}: the cheapest setting for an error of {error:G3} in {seconds:0.##} s"));
        AccuracyAdvice advice;
        try
        {
            advice = Advise(scene, seconds, error);
        }
        catch (ArgumentException e)
        {
            throw new UsageException(e.Message.ReplaceLineEndings(" "));
        }

        Write(advice);
        AccuracyPoint? cheapest = advice.Cheapest;
        Console.WriteLine(cheapest is AccuracyPoint best
            ? FormattableString.Invariant(
                $"cheapest with an error of at most {error:G3}: {best.Iterations} iterations at {1 / best.Dt:0} updates a second")
            : advice.ReferenceError > error
                ? FormattableString.Invariant(
                    $"nobody knows the motion to {error:G3}: the two finest runs are {advice.ReferenceError:G3} apart")
                : FormattableString.Invariant($"no setting keeps the error below {error:G3}"));
        return cheapest is null ? NotReached : Fine;
    }

    /// <summary>With a bar, as it takes minutes for a large scene.</summary>
    private static AccuracyAdvice Advise(Scene scene, float seconds, float error)
    {
        if (Console.IsOutputRedirected)
        {
            return AccuracyAdvisor.Advise(() => Build(scene), scene.Step, seconds, error);
        }

        return ProgressBar.Show(scene.Name, 1, bar =>
            AccuracyAdvisor.Advise(() => Build(scene), scene.Step, seconds, error, new BarProgress(bar)));
    }

    private static PhysicsSimulator Build(Scene scene)
    {
        PhysicsSimulator simulator = new();
        scene.Build(simulator);
        return simulator;
    }

    private static void Write(AccuracyAdvice advice)
    {
        Console.WriteLine("Lengths of the constraint error (overlaps,");
        Console.WriteLine("joints, slip, impacts) and of the motion error (where bodies are);");
        Console.WriteLine("milliseconds for a second of the scene");
        Console.WriteLine("rate  iterations  constr.   motion      rms      end   work  ms/second");
        foreach (AccuracyPoint point in advice.Curve)
        {
            bool best = advice.Cheapest is AccuracyPoint cheapest && cheapest.Iterations == point.Iterations && cheapest.Dt == point.Dt;
            string verdict = best ? "  cheapest" : point.PeakError <= advice.MaximumError ? "  kept" : string.Empty;
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{1 / point.Dt,4:0}  {point.Iterations,10}  {point.ConstraintError,7:0.0E+0}  {point.MotionError,7:0.0E+0}  "
                    + $"{point.RmsError,7:0.0E+0}  {point.EndError,7:0.0E+0}  {point.Work,5:0}  "
                        + $"{point.MillisecondsPerSecond,9:0.00}{verdict}"));
        }
    }

    /// <summary>Moves the bar at once; the class of the framework would do so later, on another thread.</summary>
    private sealed class BarProgress(ProgressTask bar) : IProgress<double>
    {
        public void Report(double value) => bar.Value = value;
    }
}
