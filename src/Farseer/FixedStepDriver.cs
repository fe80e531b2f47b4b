using System;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// Updates a simulator with steps of one length, however long the frames of the program are: results then do not depend on the frame rate.
/// What is left of a frame is kept for the next one, and <see cref="Alpha"/> says how far along it is, for drawing with
/// <see cref="Dynamics.Body.GetPose(float)"/>. (An addition to the original.)
/// </summary>
/// <remarks>
/// The driver switches <see cref="PhysicsSimulator.KeepsPoses"/> on. It reads no clock: it is told how much time has passed.
/// </remarks>
/// <example>
/// <code>
/// var driver = new FixedStepDriver(simulator, 1.0 / 60) { BeforeStep = _ =&gt; player.ApplyForces() };
/// // In each frame:
/// driver.Advance(secondsSinceLastFrame);
/// Pose pose = player.Body.GetPose(driver.Alpha);
/// Draw(player.Sprite, pose.Position, pose.Rotation);
/// </code>
/// </example>
public sealed class FixedStepDriver
{
    private double _step;
    private double _timeScale = 1;
    private int _maxSteps = 8;
    private double _left;

    /// <summary>Makes a driver.</summary>
    /// <param name="simulator">What it updates.</param>
    /// <param name="step">Length of a step, seconds; finite and above 0, also as a float. 1/60 if not given.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="step"/> is not finite or not above 0.</exception>
    public FixedStepDriver(PhysicsSimulator simulator, double step = 1.0 / 60)
    {
        Simulator = Require.NotNull(simulator, nameof(simulator));
        _step = StepOf(step, nameof(step));
        simulator.KeepsPoses = true;
    }

    /// <summary>The simulator that it updates.</summary>
    public PhysicsSimulator Simulator { get; }

    /// <summary>Length of a step, seconds; finite and above 0, also as a float. Default 1/60.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or not above 0.</exception>
    public double Step
    {
        get => _step;
        set => _step = StepOf(value, nameof(Step));
    }

    /// <summary>
    /// Most steps of one call of <see cref="Advance"/>; at least 1. Time beyond them is dropped, so that a slow frame does not make the
    /// next one slower still. Default 8.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is below 1.</exception>
    public int MaxSteps
    {
        get => _maxSteps;
        set => _maxSteps = Require.AtLeast(value, 1, nameof(MaxSteps));
    }

    /// <summary>
    /// Seconds of the simulation in a second of the program; finite and at least 0: 0.5 is slow motion, 0 a pause. The steps keep their
    /// length. Default 1.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public double TimeScale
    {
        get => _timeScale;
        set => _timeScale = Require.NotNegative(value, nameof(TimeScale));
    }

    /// <summary>
    /// How much of the next step has passed, from 0 to below 1: the argument for <see cref="Dynamics.Body.GetPose(float)"/>.
    /// </summary>
    public float Alpha => Math.Min((float)(_left / _step), 0.99999994f);

    /// <summary>Steps made so far.</summary>
    public long StepCount { get; private set; }

    /// <summary>
    /// Seconds of the simulation that were dropped so far, because a frame would have taken more than <see cref="MaxSteps"/>.
    /// </summary>
    public double DroppedTime { get; private set; }

    /// <summary>
    /// Called before each step with its length, for what acts in each: forces, input, kinematic motion. Use with +=. Default null.
    /// </summary>
    public Action<float>? BeforeStep { get; set; }

    /// <summary>
    /// Called after each step with its length, for what reads each: <see cref="PhysicsSimulator.Events"/> last until the next step only.
    /// Use with +=. Default null.
    /// </summary>
    public Action<float>? AfterStep { get; set; }

    /// <summary>Lets time pass, and makes the steps that are due.</summary>
    /// <param name="elapsed">Seconds of the program since the last call; finite and at least 0.</param>
    /// <returns>The number of steps made.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="elapsed"/> is negative or not finite.</exception>
    /// <exception cref="InvalidOperationException">The call comes from a handler of an update under way.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public int Advance(double elapsed)
    {
        _left += Require.NotNegative(elapsed, nameof(elapsed)) * _timeScale;
        double due = Math.Floor(_left / _step);
        if (due > _maxSteps)
        {
            DroppedTime += (due - _maxSteps) * _step;
            _left -= (due - _maxSteps) * _step;
            due = _maxSteps;
        }

        int made = 0;
        for (; made < due; made++)
        {
            // Taken off before: a step that throws is not made again.
            _left = Math.Max(0, _left - _step);
            float dt = (float)_step;
            BeforeStep?.Invoke(dt);
            Simulator.Update(dt);
            StepCount++;
            AfterStep?.Invoke(dt);
        }

        return made;
    }

    /// <summary>Forgets what is left of the last frame, as after loading.</summary>
    public void Reset() => _left = 0;

    private static double StepOf(double value, string name)
    {
        Require.Finite(value, name);
        return (float)value > 0 ? value : throw Require.Range(name, value, "must be a finite number above 0");
    }
}
