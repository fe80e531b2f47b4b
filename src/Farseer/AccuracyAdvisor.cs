using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// Finds the cheapest setting with which a scene of yours keeps an error: it runs the scene over and over with other iterations and
/// steps and reads what each update reports of itself. (An addition to the original.)
/// </summary>
public static class AccuracyAdvisor
{
    private static readonly int[] _iterations = { 1, 2, 5, 10, 20, 40 };
    private static readonly float[] _steps = { 1f / 30, 1f / 60, 1f / 120, 1f / 240 };

    /// <summary>Tries the settings on a scene that needs nothing but updates.</summary>
    /// <param name="build">Makes the scene anew, in a simulator of its own; called twice for each setting.</param>
    /// <param name="seconds">How long the scene is run; finite and above 0.</param>
    /// <param name="maximumError">The error to be kept, a length; finite and above 0.</param>
    /// <returns>The curve of errors and costs, and the cheapest setting.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="build"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    /// <exception cref="InvalidOperationException"><paramref name="build"/> returned null.</exception>
    public static AccuracyAdvice Advise(Func<PhysicsSimulator> build, float seconds, float maximumError) =>
        Advise(build, (simulator, _, dt) => simulator.Update(dt), seconds, maximumError);

    /// <summary>Tries the settings on a scene that acts on its bodies between the updates.</summary>
    /// <param name="build">Makes the scene anew, in a simulator of its own; called twice for each setting.</param>
    /// <param name="update">Does one update: gets the simulator, the number of updates done, and the seconds of this one.</param>
    /// <param name="seconds">How long the scene is run; finite and above 0.</param>
    /// <param name="maximumError">The error to be kept, a length; finite and above 0.</param>
    /// <returns>The curve of errors and costs, and the cheapest setting.</returns>
    /// <exception cref="ArgumentNullException">A function is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    /// <exception cref="InvalidOperationException"><paramref name="build"/> returned null.</exception>
    public static AccuracyAdvice Advise(
        Func<PhysicsSimulator> build, Action<PhysicsSimulator, int, float> update, float seconds, float maximumError)
    {
        Require.NotNull(build, nameof(build));
        Require.NotNull(update, nameof(update));
        Require.Positive(seconds, nameof(seconds));
        Require.Positive(maximumError, nameof(maximumError));
        var curve = new List<AccuracyPoint>();
        foreach (float dt in _steps)
        {
            foreach (int iterations in _iterations)
            {
                curve.Add(Try(build, update, iterations, dt, (int)Math.Max(4, Math.Min(Math.Round(seconds / dt), 1e8)), maximumError));
            }
        }

        curve.Sort((a, b) => a.Work != b.Work ? a.Work.CompareTo(b.Work) : b.Dt.CompareTo(a.Dt));
        return new AccuracyAdvice(maximumError, curve);
    }

    private static AccuracyPoint Try(
        Func<PhysicsSimulator> build, Action<PhysicsSimulator, int, float> update, int iterations, float dt, int steps, float maximumError)
    {
        double peak = 0;
        double end = 0;
        double squares = 0;

        // A budget that allows no more iterations than the setting has makes the updates measure, and nothing else.
        PhysicsSimulator measured = Begin(build, iterations);
        measured.ErrorBudget = ErrorBudget.OfLength(maximumError, iterations);
        bool lost = false;
        measured.BodyQuarantined += (_, _) => lost = true;
        for (int i = 0; i < steps; i++)
        {
            update(measured, i, dt);
            double error = lost ? double.PositiveInfinity : measured.Report.Error;
            peak = Math.Max(peak, error);
            end = i >= steps - (steps / 4) ? Math.Max(end, error) : 0;
            squares += error * error;
        }

        measured.Dispose();
        PhysicsSimulator timed = Begin(build, iterations);
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < steps; i++)
        {
            update(timed, i, dt);
        }

        double milliseconds = 1000.0 * (Stopwatch.GetTimestamp() - start) / Stopwatch.Frequency / (steps * (double)dt);
        timed.Dispose();
        return new AccuracyPoint(iterations, dt, peak, Math.Sqrt(squares / steps), end, milliseconds);
    }

    private static PhysicsSimulator Begin(Func<PhysicsSimulator> build, int iterations)
    {
        PhysicsSimulator simulator = build() ?? throw new InvalidOperationException("The function that builds the scene returned null.");
        simulator.Iterations = iterations;
        return simulator;
    }
}
