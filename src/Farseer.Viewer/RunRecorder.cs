using System;
using System.IO;
using System.Text;
using FarseerGames.FarseerPhysics.Viewer.Page;
using FarseerGames.FarseerPhysics.Viewer.Recording;

namespace FarseerGames.FarseerPhysics.Viewer;

/// <summary>
/// Records what a simulator does, and writes it as one HTML file that shows it in any browser: bodies, contacts, joints, events, and the
/// error of each update. The file needs no server, no network and nothing else.
/// </summary>
/// <remarks>
/// It takes memory for each frame and is meant for looking at runs, not for running games. It changes no bit of the motion, as long as
/// it is made before the simulator's first update: to be told of events (<see cref="PhysicsSimulator.RecordedEvents"/>) wakes what
/// sleeps.
/// </remarks>
/// <example>
/// <code>
/// var recorder = new RunRecorder(simulator);
/// for (int i = 0; i &lt; 600; i++)
/// {
///     simulator.Update(1f / 60);
///     recorder.Record(1f / 60);
/// }
///
/// recorder.Save("run.html");
/// </code>
/// </example>
public sealed class RunRecorder
{
    private readonly RunRecorderOptions _options;
    private readonly bool _isYUp;

    /// <summary>Makes a recorder, and lets the simulator tell what the options ask for.</summary>
    /// <param name="simulator">The simulator to record.</param>
    /// <param name="options">What to record; null, the default, for all.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><see cref="RunRecorderOptions.MostBytes"/> is not above 0.</exception>
    public RunRecorder(PhysicsSimulator simulator, RunRecorderOptions? options = null)
    {
        Simulator = simulator ?? throw new ArgumentNullException(nameof(simulator));
        _options = options ?? new RunRecorderOptions();
        if (_options.MostBytes <= 0)
        {
            throw new ArgumentOutOfRangeException(nameof(options), _options.MostBytes, "MostBytes must be above 0.");
        }

        _isYUp = _options.IsYUp ?? simulator.Gravity.Y <= 0;
        if (_options.Events && (simulator.RecordedEvents & EventTrack.Wanted) != EventTrack.Wanted)
        {
            simulator.RecordedEvents |= EventTrack.Wanted;
        }

        simulator.EnableReport |= _options.Report;
        simulator.SumImpulses |= _options.SumImpulses;
    }

    /// <summary>The simulator that is recorded.</summary>
    public PhysicsSimulator Simulator { get; }

    /// <summary>Frames recorded so far.</summary>
    public int FrameCount => Data.FrameCount;

    internal RunData Data { get; } = new RunData();

    internal RunRecorderOptions Options => _options;

    internal bool IsYUp => _isYUp;

    /// <summary>Records a frame: call it after each update, and not from a handler.</summary>
    /// <param name="dt">Length of the update, s; finite and at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is negative or not finite.</exception>
    public void Record(float dt)
    {
        if (!(dt >= 0) || float.IsInfinity(dt))
        {
            throw new ArgumentOutOfRangeException(nameof(dt), dt, "The time must be finite and at least 0.");
        }

        Data.Record(Simulator, _options, dt);
    }

    /// <summary>Looks for the first difference of two recordings, with all bits.</summary>
    /// <param name="first">One recording.</param>
    /// <param name="second">The other.</param>
    /// <returns>The difference; null if places and velocities are the same, bit for bit, in as many frames.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public static RunDifference? Compare(RunRecorder first, RunRecorder second)
    {
        RunData one = (first ?? throw new ArgumentNullException(nameof(first))).Data;
        RunData two = (second ?? throw new ArgumentNullException(nameof(second))).Data;
        one.Pack();
        two.Pack();
        return Comparison.Find(one, two);
    }

    /// <summary>Writes the page.</summary>
    /// <param name="path">The file, which is written over.</param>
    /// <exception cref="InvalidOperationException">No frame has been recorded.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public void Save(string path) => SaveTo(path, this, null);

    /// <summary>Writes a page that shows two recordings side by side, with their first difference marked.</summary>
    /// <param name="path">The file, which is written over.</param>
    /// <param name="beside">The other recording.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="InvalidOperationException">No frame has been recorded in one of them.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public void Save(string path, RunRecorder beside) => SaveTo(path, this, beside ?? throw new ArgumentNullException(nameof(beside)));

    /// <summary>Writes the page.</summary>
    /// <param name="writer">Where to; it stays open.</param>
    /// <param name="beside">Another recording to show side by side; null, the default, for none.</param>
    /// <exception cref="ArgumentNullException"><paramref name="writer"/> is null.</exception>
    /// <exception cref="InvalidOperationException">No frame has been recorded.</exception>
    public void Write(TextWriter writer, RunRecorder? beside = null)
    {
        if (writer is null)
        {
            throw new ArgumentNullException(nameof(writer));
        }

        Ready(this);
        RunDifference? difference = null;
        if (beside is not null)
        {
            Ready(beside);
            difference = Compare(this, beside);
        }

        PageWriter.Write(writer, this, beside, difference);
    }

    private static void Ready(RunRecorder recorder)
    {
        if (recorder.FrameCount == 0)
        {
            throw new InvalidOperationException("No frame has been recorded: call Record after each update.");
        }

        recorder.Data.Pack();
    }

    private static void SaveTo(string path, RunRecorder recorder, RunRecorder? beside)
    {
        if (path is null)
        {
            throw new ArgumentNullException(nameof(path));
        }

        Ready(recorder);
        using StreamWriter writer = new StreamWriter(path, append: false, new UTF8Encoding(false));
        recorder.Write(writer, beside);
    }
}
