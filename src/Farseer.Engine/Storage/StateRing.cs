using System;
using System.Collections.Generic;

namespace Farseer.Engine.Storage;

/// <summary>
/// The last states of a simulation, one a frame. The newest is whole; each other is kept as what makes it of the one after it, so
/// the oldest can go at any time. Each 64th is kept as a key besides, so that no more than that many are made on the way back.
/// </summary>
internal sealed class StateRing
{
    /// <summary>Frames from one key to the next.</summary>
    public const int KeyInterval = 64;

    private readonly Ring<uint> _words = new Ring<uint>();
    private readonly Ring<object?> _objects = new Ring<object?>();
    private readonly Ring<Frame> _frames = new Ring<Frame>();
    private readonly StateDelta _delta = new StateDelta();
    private readonly StateStream _stream;
    private readonly StateSections _newest;

    // One that is gone back to, as long as it is read: it shares with the newest what is the same in both.
    private readonly StateSections _found;
    private bool _isBusy;

    private StateRing(int mostFrames, long mostBytes)
    {
        MostFrames = mostFrames;
        MostBytes = mostBytes;
        _stream = new StateStream(new StateUpdate(_delta));
        var unused = new Stack<StateSection>();
        _newest = new StateSections(unused);
        _found = new StateSections(unused);
    }

    /// <summary>The oldest frame falls out when there are more.</summary>
    public int MostFrames { get; }

    /// <summary>And when they take more bytes; the newest stays in any case.</summary>
    public long MostBytes { get; }

    /// <summary>Frames held.</summary>
    public int Count => (int)(_frames.End - _frames.Begin);

    public long Oldest => Count == 0 ? -1 : _frames.Begin;

    public long Newest => Count == 0 ? -1 : _frames.End - 1;

    /// <summary>Bytes of all frames, without unused room.</summary>
    public unsafe long ByteCount => Count == 0 ? 0 : _newest.ByteCount
        + ((_words.End - _words.Begin) * sizeof(uint)) + ((_objects.End - _objects.Begin) * IntPtr.Size) + ((long)Count * sizeof(Frame));

    /// <summary>A ring of so many frames.</summary>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="frames"/> is less than 1.</exception>
    public static StateRing OfFrames(int frames) => frames >= 1
        ? new StateRing(frames, long.MaxValue)
        : throw new ArgumentOutOfRangeException(nameof(frames), frames, "frames must be at least 1.");

    /// <summary>A ring of as many frames as so many bytes hold.</summary>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="bytes"/> is less than 1.</exception>
    public static StateRing OfBytes(long bytes) => bytes >= 1
        ? new StateRing(int.MaxValue, bytes)
        : throw new ArgumentOutOfRangeException(nameof(bytes), bytes, "bytes must be at least 1.");

    /// <summary>
    /// What the next frame is to be written to: it brings the newest one up to date. <see cref="Push"/> or <see cref="CancelPush"/> comes
    /// behind.
    /// </summary>
    /// <exception cref="InvalidOperationException">Another call is not finished.</exception>
    public StateStream BeginPush()
    {
        Enter();
        return _stream.Use(_newest);
    }

    /// <summary>The frame of <see cref="BeginPush"/> is not taken in: all is as it was.</summary>
    public void CancelPush()
    {
        _stream.CancelUpdate();
        _isBusy = false;
    }

    /// <summary>Takes what was written since <see cref="BeginPush"/> in as the newest frame.</summary>
    /// <returns>Its number.</returns>
    public long Push()
    {
        if (Count == MostFrames)
        {
            DropOldest();
        }

        if (Count > 0)
        {
            Store(out _frames[Newest].Back);
        }

        _frames.Append(new Frame { WordAt = _words.End, ObjectAt = _objects.End, Round = _newest.Round });
        if (MostFrames > KeyInterval && Newest % KeyInterval == 0)
        {
            StoreKey();
        }

        _delta.Forget();
        while (MostBytes < long.MaxValue && Count > 1 && ByteCount > MostBytes)
        {
            DropOldest();
        }

        _isBusy = false;
        return Newest;
    }

    /// <summary>The state of a frame, to be read. <see cref="EndRewind"/> or <see cref="CancelRewind"/> comes behind.</summary>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="frame"/> is not held.</exception>
    /// <exception cref="InvalidOperationException">Another call is not finished.</exception>
    public StateStream BeginRewind(long frame)
    {
        if (Count == 0 || frame < Oldest || frame > Newest)
        {
            throw new ArgumentOutOfRangeException(
                nameof(frame), frame, Count == 0 ? "The buffer holds no frame." : $"Frames {Oldest} to {Newest} are held.");
        }

        Enter();
        if (frame == Newest)
        {
            return _stream.Use(_newest);
        }

        Find(frame);
        return _stream.Use(_found);
    }

    /// <summary>The frame that was read is the newest: those after it are dropped.</summary>
    public void EndRewind(long frame)
    {
        if (frame < Newest)
        {
            _newest.TakeOver(_found);
            ref Frame last = ref _frames[frame];
            _newest.Round = last.Round;
            _words.DropFrom(last.WordAt + last.Key.Words);
            _objects.DropFrom(last.ObjectAt + last.Key.Objects);
            last.Back = default;
            _frames.DropFrom(frame + 1);
        }

        _isBusy = false;
    }

    /// <summary>The frame was refused: all is as it was.</summary>
    public void CancelRewind()
    {
        _found.Clear();
        _newest.MarkShared(false);
        _isBusy = false;
    }

    /// <summary>Drops all frames; the numbers go on.</summary>
    /// <exception cref="InvalidOperationException">Another call is not finished.</exception>
    public void Clear()
    {
        Enter();
        _words.DropBefore(_words.End);
        _objects.DropBefore(_objects.End);
        _frames.DropBefore(_frames.End);
        _newest.Clear();
        _isBusy = false;
    }

    private void Enter()
    {
        if (_isBusy)
        {
            throw new InvalidOperationException(
                "The buffer is in a call already: a method that saves or restores must not push, rewind or clear it.");
        }

        _isBusy = true;
    }

    private void Find(long frame)
    {
        long at = Newest;
        long key = frame;
        while (key < at && _frames[key].Key.Words == 0)
        {
            key++;
        }

        _newest.MarkShared(true);
        if (key < at && at - frame > KeyInterval)
        {
            Apply(_frames[key].WordAt, _frames[key].ObjectAt, _frames[key].Key);
            at = key;
        }
        else
        {
            _found.CopyFrom(_newest);
        }

        while (at > frame)
        {
            at--;
            ref Frame next = ref _frames[at];
            Apply(next.WordAt + next.Key.Words, next.ObjectAt + next.Key.Objects, next.Back);
        }

        _found.Round = _frames[frame].Round;
        _delta.Forget();
    }

    private void DropOldest()
    {
        _frames.DropBefore(_frames.Begin + 1);
        bool any = _frames.Begin < _frames.End;
        _words.DropBefore(any ? _frames[_frames.Begin].WordAt : _words.End);
        _objects.DropBefore(any ? _frames[_frames.Begin].ObjectAt : _objects.End);
    }

    private void Store(out Piece piece)
    {
        _words.Append(_delta.Words);
        _objects.Append(_delta.Objects);
        piece = new Piece { Words = _delta.WordCount, Objects = _delta.ObjectCount };
    }

    private void StoreKey()
    {
        _delta.Begin();
        for (int i = 0; i < _newest.Count; i++)
        {
            _delta.AddSection(0, _newest[i]);
        }

        _delta.End();
        Store(out _frames[Newest].Key);
    }

    /// <summary>Goes a piece of the way to the state that is looked for.</summary>
    private void Apply(long words, long objects, Piece piece)
    {
        _delta.Prepare(piece.Words, piece.Objects, out Span<uint> wordSpan, out Span<object?> objectSpan);
        _words.CopyTo(words, wordSpan);
        _objects.CopyTo(objects, objectSpan);
        _delta.Apply(_found);
    }

    /// <summary>How much there is of a difference.</summary>
    private struct Piece
    {
        public int Words;
        public int Objects;
    }

    /// <summary>Where the pieces of a frame begin: first its key, if it has one, then the way back to it from the frame after.</summary>
    private struct Frame
    {
        public long WordAt;
        public long ObjectAt;

        /// <summary>See <see cref="StateStream.Round"/>.</summary>
        public long Round;
        public Piece Key;
        public Piece Back;
    }
}
