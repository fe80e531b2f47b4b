using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Numerics;
using System.Threading;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// Finds the cheapest setting with which a scene of yours keeps an error: it runs the scene over and over with other iterations and
/// steps. (An addition to the original.)
/// </summary>
/// <remarks>
/// Two things are measured, and both have to stay within what is asked. The constraint error is what each update reports to be wrong with
/// its state: overlaps, open joints, slip, impacts against their law. The motion error is how far bodies are from where they are in a
/// reference run with 80 iterations at 480 updates a second. A scene that small differences decide, as they do a double pendulum after
/// some seconds, has no motion that could be known; then no setting is named (<see cref="AccuracyAdvice.ReferenceError"/>).
/// </remarks>
/// <example>
/// <code>
/// AccuracyAdvice advice = AccuracyAdvisor.Advise(MakeScene, seconds: 5, maximumError: 0.001f);
/// Console.WriteLine(advice.Cheapest);
/// </code>
/// </example>
public static class AccuracyAdvisor
{
    /// <summary>Bodies are compared so often in a second.</summary>
    private const int Rate = 30;

    private const int ReferenceIterations = 80;
    private const int ReferenceUpdates = 16;

    private static readonly int[] _iterations = { 1, 2, 5, 10, 20, 40 };

    /// <summary>Updates from one comparison to the next.</summary>
    private static readonly int[] _updates = { 1, 2, 4, 8 };

    /// <summary>Tries the settings on a scene that needs nothing but updates, by constraint error and motion error.</summary>
    /// <param name="build">Makes the scene anew, in a simulator of its own; called twice for each setting, and once more.</param>
    /// <param name="seconds">Seconds for which the scene is run; finite and above 0, taken to whole thirtieths, at least four.</param>
    /// <param name="maximumError">The error to be kept, a length; finite and above 0.</param>
    /// <param name="progress">Told the share of the work that is done, from 0 to 1, after each run; null: nobody.</param>
    /// <param name="cancellation">Stops between two updates.</param>
    /// <returns>The curve of errors and costs, and the cheapest setting.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="build"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    /// <exception cref="InvalidOperationException"><paramref name="build"/> returned null.</exception>
    /// <exception cref="OperationCanceledException"><paramref name="cancellation"/> was asked for.</exception>
    public static AccuracyAdvice Advise(
        Func<PhysicsSimulator> build,
        float seconds,
        float maximumError,
        IProgress<double>? progress = null,
        CancellationToken cancellation = default) =>
        Advise(build, (simulator, _, dt) => simulator.Update(dt), seconds, maximumError, progress, cancellation);

    /// <summary>Tries the settings on a scene that acts on its bodies between the updates, by constraint error and motion error.</summary>
    /// <param name="build">Makes the scene anew, in a simulator of its own; called twice for each setting, and once more.</param>
    /// <param name="update">
    /// Does one update: gets the simulator, the number of updates done, and the seconds of this one. What it does should depend on the
    /// time, the product of both: what depends on the number alone is another motion at another step.
    /// </param>
    /// <param name="seconds">Seconds for which the scene is run; finite and above 0, taken to whole thirtieths, at least four.</param>
    /// <param name="maximumError">The error to be kept, a length; finite and above 0.</param>
    /// <param name="progress">Told the share of the work that is done, from 0 to 1, after each run; null: nobody.</param>
    /// <param name="cancellation">Stops between two updates.</param>
    /// <returns>The curve of errors and costs, and the cheapest setting.</returns>
    /// <exception cref="ArgumentNullException">A function is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    /// <exception cref="InvalidOperationException"><paramref name="build"/> returned null.</exception>
    /// <exception cref="OperationCanceledException"><paramref name="cancellation"/> was asked for.</exception>
    public static AccuracyAdvice Advise(
        Func<PhysicsSimulator> build,
        Action<PhysicsSimulator, int, float> update,
        float seconds,
        float maximumError,
        IProgress<double>? progress = null,
        CancellationToken cancellation = default)
    {
        Require.NotNull(build, nameof(build));
        Require.NotNull(update, nameof(update));
        Require.Positive(seconds, nameof(seconds));
        Require.Positive(maximumError, nameof(maximumError));
        var run = new Run(build, update, (int)Math.Max(4, Math.Min(Math.Round((double)seconds * Rate), 1e7)), progress, cancellation);
        List<Vector2> reference = run.Follow(ReferenceIterations, ReferenceUpdates);
        var curve = new List<AccuracyPoint>();
        double referenceError = 0;
        foreach (int updates in _updates)
        {
            foreach (int iterations in _iterations)
            {
                AccuracyErrors errors = run.Measure(iterations, updates, reference);
                referenceError = errors.Motion;
                curve.Add(new AccuracyPoint(iterations, Step(updates), errors, run.Time(iterations, updates)));
            }
        }

        curve.Sort((a, b) => a.Work != b.Work ? a.Work.CompareTo(b.Work) : b.Dt.CompareTo(a.Dt));
        return new AccuracyAdvice(maximumError, referenceError, curve);
    }

    private static float Step(int updates) => 1f / (Rate * updates);

    /// <summary>What all runs have in common.</summary>
    private sealed class Run
    {
        private readonly Func<PhysicsSimulator> _build;
        private readonly Action<PhysicsSimulator, int, float> _update;
        private readonly int _frames;
        private readonly IProgress<double>? _progress;
        private readonly CancellationToken _cancellation;
        private readonly double _allWork;
        private double _work;

        public Run(
            Func<PhysicsSimulator> build,
            Action<PhysicsSimulator, int, float> update,
            int frames,
            IProgress<double>? progress,
            CancellationToken cancellation)
        {
            _build = build;
            _update = update;
            _frames = frames;
            _progress = progress;
            _cancellation = cancellation;
            _allWork = WorkOf(ReferenceIterations, ReferenceUpdates);
            foreach (int updates in _updates)
            {
                foreach (int iterations in _iterations)
                {
                    _allWork += 2 * WorkOf(iterations, updates);
                }
            }
        }

        /// <summary>Where all bodies are, frame by frame, at a setting.</summary>
        public List<Vector2> Follow(int iterations, int updates)
        {
            var places = new List<Vector2>();
            using PhysicsSimulator simulator = Begin(iterations);
            bool lost = false;
            simulator.BodyQuarantined += (_, _) => lost = true;
            for (int frame = 0; frame < _frames; frame++)
            {
                Advance(simulator, frame, updates, null);
                foreach (Body body in simulator.BodyList)
                {
                    places.Add(lost ? new Vector2(float.NaN) : body.Position);
                }
            }

            Tell(iterations, updates);
            return places;
        }

        public AccuracyErrors Measure(int iterations, int updates, List<Vector2> reference)
        {
            AccuracyErrors errors = default;
            double squares = 0;
            int place = 0;
            using PhysicsSimulator simulator = Begin(iterations);
            simulator.EnableReport = true;
            bool lost = false;
            simulator.BodyQuarantined += (_, _) => lost = true;
            for (int frame = 0; frame < _frames; frame++)
            {
                Advance(simulator, frame, updates, () =>
                {
                    double error = lost ? double.PositiveInfinity : simulator.Report.ConstraintError;
                    errors.Constraint = Math.Max(errors.Constraint, error);
                    errors.End = frame >= _frames - (_frames / 4) ? Math.Max(errors.End, error) : 0;
                    squares += error * error;
                });
                foreach (Body body in simulator.BodyList)
                {
                    bool known = place < reference.Count && !lost;
                    double distance = known ? Distance(body.Position, reference[place]) : double.PositiveInfinity;
                    errors.Motion = Math.Max(errors.Motion, distance);
                    place++;
                }
            }

            errors.Motion = place == reference.Count ? errors.Motion : double.PositiveInfinity;
            errors.Rms = Math.Sqrt(squares / (_frames * (double)updates));
            Tell(iterations, updates);
            return errors;
        }

        /// <summary>Milliseconds for a second of the scene.</summary>
        public double Time(int iterations, int updates)
        {
            using PhysicsSimulator simulator = Begin(iterations);
            long start = Stopwatch.GetTimestamp();
            for (int frame = 0; frame < _frames; frame++)
            {
                Advance(simulator, frame, updates, null);
            }

            long ticks = Stopwatch.GetTimestamp() - start;
            Tell(iterations, updates);
            return 1000.0 * ticks / Stopwatch.Frequency * Rate / _frames;
        }

        private static double Distance(Vector2 place, Vector2 reference)
        {
            double x = (double)place.X - reference.X;
            double y = (double)place.Y - reference.Y;
            double distance = Math.Sqrt((x * x) + (y * y));
            return double.IsNaN(distance) ? double.PositiveInfinity : distance;
        }

        private static double WorkOf(int iterations, int updates) => (iterations + (double)AccuracyPoint.CollisionShare) * updates;

        private void Advance(PhysicsSimulator simulator, int frame, int updates, Action? afterUpdate)
        {
            for (int i = 0; i < updates; i++)
            {
                _cancellation.ThrowIfCancellationRequested();
                _update(simulator, (frame * updates) + i, Step(updates));
                afterUpdate?.Invoke();
            }
        }

        private PhysicsSimulator Begin(int iterations)
        {
            PhysicsSimulator simulator = _build()
                ?? throw new InvalidOperationException("The function that builds the scene returned null.");
            simulator.Iterations = iterations;
            simulator.ErrorBudget = ErrorBudget.None;
            return simulator;
        }

        private void Tell(int iterations, int updates)
        {
            _work += WorkOf(iterations, updates);
            _progress?.Report(_work / _allWork);
        }
    }
}
