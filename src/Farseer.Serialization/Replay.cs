using System;
using System.Collections.Generic;
using System.IO;
using FarseerGames.FarseerPhysics.Serialization.Documents;
using FarseerGames.FarseerPhysics.Serialization.Recordings;
using FarseerGames.FarseerPhysics.Serialization.States;

namespace FarseerGames.FarseerPhysics.Serialization;

/// <summary>
/// Plays what a <see cref="SimulationRecorder"/> has recorded: any frame, forward and back, without the program that was recorded and its
/// handlers. Frame 0 is the simulator as the recording began, frame n as update n has left it.
/// </summary>
/// <example>
/// <code>
/// Replay replay = Replay.Load(file);
/// replay.Seek(120);
/// while (replay.MoveNext())
/// {
///     Draw(replay.Simulator);
/// }
///
/// Console.WriteLine(replay.Divergence is { } frame ? "another world from frame " + frame : "the same bits");
/// </code>
/// </example>
public sealed class Replay
{
    private readonly byte[] _first;
    private readonly List<RecordedFrame> _frames;
    private SceneContents _contents;
    private StateImage _stored;

    private Replay(byte[] first, List<RecordedFrame> frames)
    {
        _first = first;
        _frames = frames;
        _contents = LoadKeyframe(first, out _stored);
    }

    /// <summary>
    /// The simulator at the present frame. At a whole file within the recording it is another one, with other objects: ask for it anew
    /// after each move, and change nothing in it.
    /// </summary>
    public PhysicsSimulator Simulator => _contents.Simulator;

    /// <summary>The present frame; 0 at first.</summary>
    public int Frame { get; private set; }

    /// <summary>The last frame: the updates recorded.</summary>
    public int FrameCount => _frames.Count;

    /// <summary>
    /// The first frame played so far whose state was not the one recorded; null: there was none. Recordings play with the same bits on any
    /// number of workers, of both assets, on any processor: it tells of a fault of the library, or of a simulator that was changed.
    /// </summary>
    public int? Divergence { get; private set; }

    /// <summary>Loads a recording.</summary>
    /// <param name="file">The file.</param>
    /// <returns>The replay, at frame 0.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="file"/> is null.</exception>
    /// <exception cref="SceneFileException">The file is no recording, is damaged, is of a newer version, or its states are of another
    /// version of the library.</exception>
    public static Replay Load(byte[] file)
    {
        SceneObject root =
            SceneFile.Open(file ?? throw new ArgumentNullException(nameof(file)), new SceneFileOptions(), SimulationRecorder.Format);
        SceneNode sum = root.Take(SceneDocument.ChecksumName);
        if (sum.Text() != sum.Document.Checksum)
        {
            throw sum.Error("is not that of the file, which has been changed since it was recorded");
        }

        byte[] first = root.Take("first").Bytes();
        var frames = new List<RecordedFrame>();
        foreach (SceneNode node in root.TakeItems("frames"))
        {
            frames.Add(Read(new SceneObject(node)));
        }

        root.Finish();
        return new Replay(first, frames);
    }

    /// <summary>Loads a recording from a stream, which is read to its end and stays open.</summary>
    /// <param name="stream">The stream.</param>
    /// <returns>The replay, at frame 0.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="stream"/> is null.</exception>
    /// <exception cref="SceneFileException">The file is no recording, is damaged, is of a newer version, or its states are of another
    /// version of the library.</exception>
    public static Replay Load(Stream stream) => Load(SceneFile.ReadAll(stream, null));

    /// <summary>Plays the next frame.</summary>
    /// <returns>False at the last one.</returns>
    public bool MoveNext()
    {
        if (Frame == FrameCount)
        {
            return false;
        }

        RecordedFrame frame = _frames[Frame];
        if (frame.Keyframe is not null)
        {
            _contents = LoadKeyframe(frame.Keyframe, out _stored);
        }
        else
        {
            Change(frame.Before);
        }

        _contents.Simulator.Update(frame.Dt);
        Frame++;
        if (_contents.Simulator.MotionHash() != frame.Hash)
        {
            Divergence = Math.Min(Divergence ?? int.MaxValue, Frame);
        }

        if (frame.End is not null)
        {
            _contents = LoadKeyframe(frame.End, out _stored);
        }
        else
        {
            Change(frame.After);
        }

        return true;
    }

    /// <summary>Goes to a frame: from the last whole file before it, or from the present frame where that is nearer.</summary>
    /// <param name="frame">From 0 to <see cref="FrameCount"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    public void Seek(int frame)
    {
        if (frame < 0 || frame > FrameCount)
        {
            throw new ArgumentOutOfRangeException(nameof(frame), frame, "frame must be a frame of the recording, from 0 to FrameCount.");
        }

        // An update that begins with a whole file makes its frame of that alone; one that ends with one, the frame itself.
        int start = frame;
        while (start > 0 && _frames[start - 1].End is null && (start == frame || _frames[start].Keyframe is null))
        {
            start--;
        }

        if (Frame > frame || Frame < start)
        {
            byte[]? file = start == 0 ? _first : _frames[start - 1].End;
            _contents = file is null ? _contents : LoadKeyframe(file, out _stored);
            Frame = start;
        }

        while (Frame < frame)
        {
            MoveNext();
        }
    }

    private static RecordedFrame Read(SceneObject members)
    {
        var frame = new RecordedFrame { Dt = members.Take("dt").Single(), Hash = StateChange.Number(members.Take("hash")) };
        if (!(frame.Dt >= 0) || float.IsInfinity(frame.Dt))
        {
            throw members.Node.Error("needs a time that is at least 0");
        }

        frame.Keyframe = members.TryTake("keyframe", out SceneNode keyframe) ? keyframe.Bytes() : null;
        frame.End = members.TryTake("end", out SceneNode end) ? end.Bytes() : null;
        frame.Before = members.TryTake("before", out SceneNode before) ? StateChange.Read(before) : null;
        frame.After = members.TryTake("after", out SceneNode after) ? StateChange.Read(after) : null;
        members.Finish();
        return frame;
    }

    private static SceneContents LoadKeyframe(byte[] file, out StateImage stored)
    {
        SceneContents contents = SceneFile.LoadContents(file, new SceneFileOptions(), out StatePart? state);
        stored = state is null ? throw new SceneFileException("A whole file within the recording has no state.") : StateImage.From(state);
        return contents;
    }

    /// <summary>Sets the simulator to what a change makes of the last state in the recording.</summary>
    private void Change(StateChange? change)
    {
        if (change is null)
        {
            return;
        }

        _stored =
            change.Applied(_stored) ?? throw new SceneFileException("A change within the recording does not fit the state before it.");
        _stored.Restore(_contents);
    }
}
