using System;
using System.Collections.Generic;
using System.IO;
using FarseerGames.FarseerPhysics.Serialization.Documents;
using FarseerGames.FarseerPhysics.Serialization.Recordings;
using FarseerGames.FarseerPhysics.Serialization.States;

namespace FarseerGames.FarseerPhysics.Serialization;

/// <summary>
/// Records a simulator: whatever a program does between updates, and whatever its handlers do within, so that a <see cref="Replay"/> shows
/// the same without either. Updates are made by <see cref="Update"/> in place of the simulator's own.
/// </summary>
/// <remarks>
/// It hooks into no member. A second simulator, loaded from a file of the first, goes along: before each update it is set to what the
/// program has changed, and after it to what handlers have; the differences are the recording. So it is complete for whatever a state has,
/// and each recording has been replayed once when it is made. It costs an update and two captures more, and memory for the differences.
/// </remarks>
/// <example>
/// <code>
/// var recorder = new SimulationRecorder(simulator);
/// for (int i = 0; i &lt; 600; i++)
/// {
///     Act(simulator);
///     recorder.Update(1f / 60);
/// }
///
/// Replay replay = Replay.Load(recorder.ToArray());
/// </code>
/// </example>
public sealed class SimulationRecorder
{
    internal const string Format = "farseer recording";

    private readonly List<RecordedFrame> _frames = new List<RecordedFrame>();
    private readonly SceneFileOptions _options = new SceneFileOptions { Format = SceneFormat.Binary, ExactState = true };
    private readonly int _keyframeInterval;

    // The simulator and the one that goes along, each with its objects of the last file.
    private SceneContents _contents;
    private SceneContents _shadow;

    // What both were after the last update, and the last state in the recording.
    private StateImage _image;
    private StateImage _stored;
    private List<object?> _fixedParts;
    private int _sinceKeyframe;

    /// <summary>Begins a recording.</summary>
    /// <param name="simulator">The simulator.</param>
    /// <param name="keyframeInterval">Updates from one whole file to the next, from which a replay can begin; at least 1. Default
    /// 600.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="keyframeInterval"/> is below 1.</exception>
    /// <exception cref="InvalidOperationException">An update runs.</exception>
    /// <exception cref="NotSupportedException">A joint, spring, controller, container or broad phase is of your own type: it is
    /// named.</exception>
    public SimulationRecorder(PhysicsSimulator simulator, int keyframeInterval = 600)
    {
        Simulator = simulator ?? throw new ArgumentNullException(nameof(simulator));
        _keyframeInterval = keyframeInterval >= 1
            ? keyframeInterval
            : throw new ArgumentOutOfRangeException(nameof(keyframeInterval), keyframeInterval, "keyframeInterval must be at least 1.");
        First = TakeKeyframe(out _contents, out _shadow, out _image, out _fixedParts);
        _stored = _image;
    }

    /// <summary>The simulator that is recorded.</summary>
    public PhysicsSimulator Simulator { get; }

    /// <summary>Updates recorded.</summary>
    public int FrameCount => _frames.Count;

    /// <summary>The simulator as the recording began.</summary>
    internal byte[] First { get; }

    /// <summary>Updates the simulator and records it.</summary>
    /// <param name="dt">Time of the update, seconds; at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is negative or not finite; nothing is recorded.</exception>
    /// <exception cref="NotSupportedException">An item of your own type was added: it is named, and nothing is updated.</exception>
    /// <remarks>What a handler throws comes out when the update is done and recorded.</remarks>
    public void Update(float dt)
    {
        if (!(dt >= 0) || float.IsInfinity(dt))
        {
            throw new ArgumentOutOfRangeException(nameof(dt), dt, "dt must be at least 0 and finite.");
        }

        var frame = new RecordedFrame { Dt = dt };
        StateImage? before = IsAsInTheFile() ? StateImage.Of(_contents) : null;
        if (before is null || _sinceKeyframe >= _keyframeInterval)
        {
            frame.Keyframe = TakeKeyframe(out _contents, out _shadow, out _image, out _fixedParts);
            _stored = _image;
            _sinceKeyframe = 0;
        }
        else if (!before.IsSameAs(_image))
        {
            frame.Before = Store(before);
        }

        try
        {
            Simulator.Update(dt);
        }
        finally
        {
            _shadow.Simulator.Update(dt);
            Finish(frame);
            _sinceKeyframe++;
            _frames.Add(frame);
        }
    }

    /// <summary>The recording as a file; recording may go on.</summary>
    /// <returns>The file.</returns>
    public byte[] ToArray() => SceneFile.Write(Format, _options, sink =>
    {
        sink.Name("first");
        sink.Bytes(First);
        sink.Name("frames");
        sink.BeginArray();
        foreach (RecordedFrame frame in _frames)
        {
            Write(sink, frame);
        }

        sink.EndArray();
    });

    /// <summary>Writes the recording into a stream, which stays open; recording may go on.</summary>
    /// <param name="stream">Where to.</param>
    /// <exception cref="ArgumentNullException"><paramref name="stream"/> is null.</exception>
    public void Save(Stream stream)
    {
        byte[] file = ToArray();
        (stream ?? throw new ArgumentNullException(nameof(stream))).Write(file, 0, file.Length);
    }

    private static void Write(SceneSink sink, RecordedFrame frame)
    {
        sink.BeginObject();
        sink.Name("dt");
        sink.Number(frame.Dt);
        StateChange.Number(sink, "hash", frame.Hash);
        Bytes("keyframe", frame.Keyframe);
        Bytes("end", frame.End);
        Change("before", frame.Before);
        Change("after", frame.After);
        sink.EndObject();

        void Bytes(string name, byte[]? bytes)
        {
            if (bytes is not null)
            {
                sink.Name(name);
                sink.Bytes(bytes);
            }
        }

        void Change(string name, StateChange? change)
        {
            if (change is not null)
            {
                sink.Name(name);
                change.Write(sink);
            }
        }
    }

    private void Finish(RecordedFrame frame)
    {
        frame.Hash = _shadow.Simulator.MotionHash();
        StateImage? after = IsAsInTheFile() ? StateImage.Of(_contents) : null;
        if (after is null)
        {
            frame.End = TakeKeyframe(out _contents, out _shadow, out _image, out _fixedParts);
            _stored = _image;
            return;
        }

        StateImage own = StateImage.Of(_shadow)!;
        if (!after.IsSameAs(own))
        {
            frame.After = Store(after);
        }

        _image = after;
    }

    /// <summary>Sets the simulator that goes along to a state.</summary>
    /// <returns>What makes that state of the last one in the recording: whoever plays need not have come to the same bytes.</returns>
    private StateChange Store(StateImage state)
    {
        StateChange change = StateChange.Between(_stored, state);
        _stored = state;
        state.Restore(_shadow);
        return change;
    }

    /// <summary>Nothing has been replaced that only a file tells of.</summary>
    private bool IsAsInTheFile()
    {
        List<object?> parts = StateImage.FixedParts(_contents);
        for (int i = 0; i < parts.Count; i++)
        {
            if (!Equals(parts[i], _fixedParts[i]))
            {
                return false;
            }
        }

        return true;
    }

    private byte[] TakeKeyframe(out SceneContents contents, out SceneContents shadow, out StateImage image, out List<object?> fixedParts)
    {
        byte[] file = SceneFile.Save(Simulator, _options, out contents);
        shadow = SceneFile.LoadContents(file, _options, out StatePart? state);
        image = StateImage.From(state!);
        fixedParts = StateImage.FixedParts(contents);
        return file;
    }
}
