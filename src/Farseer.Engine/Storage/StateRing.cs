using System;

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
    private readonly StateStream _nothing = new StateStream();
    private StateStream _newest = new StateStream { HoldsDifferences = true };
    private StateStream _next = new StateStream { HoldsDifferences = true };
    private StateStream _spare = new StateStream { HoldsDifferences = true };

    private StateRing(int mostFrames, long mostBytes)
    {
        MostFrames = mostFrames;
        MostBytes = mostBytes;
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
    public unsafe long ByteCount => Count == 0 ? 0 : Bytes(_newest)
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

    /// <summary>What the next frame is to be written to, before <see cref="Push"/>; meanwhile it is compared with the newest one.</summary>
    public StateStream BeginPush()
    {
        _delta.Watch(_next, _newest);
        return _next;
    }

    /// <summary>Takes what <see cref="BeginPush"/> gave in as the newest frame.</summary>
    /// <returns>Its number.</returns>
    public long Push()
    {
        if (Count == MostFrames)
        {
            DropOldest();
        }

        if (Count > 0)
        {
            _delta.Finish(_next);
            Store(out _frames[Newest].Back);
        }
        else
        {
            _delta.Leave(_next);
        }

        (_newest, _next) = (_next, _newest);
        _frames.Append(new Frame { WordAt = _words.End, ObjectAt = _objects.End, Round = _newest.Round });
        if (MostFrames > KeyInterval && Newest % KeyInterval == 0)
        {
            _delta.Find(_nothing, _newest);
            Store(out _frames[Newest].Key);
        }

        while (ByteCount > MostBytes && Count > 1)
        {
            DropOldest();
        }

        return Newest;
    }

    /// <summary>The state of a frame; it lasts until anything else is asked of the ring.</summary>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="frame"/> is not held.</exception>
    public StateStream Find(long frame)
    {
        if (Count == 0 || frame < Oldest || frame > Newest)
        {
            throw new ArgumentOutOfRangeException(
                nameof(frame), frame, Count == 0 ? "The buffer holds no frame." : $"Frames {Oldest} to {Newest} are held.");
        }

        long at = Newest;
        StateStream state = _newest;
        for (long key = frame; at - frame > KeyInterval; key++)
        {
            if (_frames[key].Key.Words > 0)
            {
                Load(_frames[key].WordAt, _frames[key].ObjectAt, _frames[key].Key);
                _delta.Apply(_nothing, _next);
                state = _next;
                at = key;
            }
        }

        while (at > frame)
        {
            at--;
            ref Frame next = ref _frames[at];
            Load(next.WordAt + next.Key.Words, next.ObjectAt + next.Key.Objects, next.Back);
            StateStream target = _delta.KeepsShape && !ReferenceEquals(state, _newest) ? state
                : ReferenceEquals(state, _next) ? _spare : _next;
            _delta.Apply(state, target);
            target.Round = 0;
            state = target;
        }

        _delta.Forget();
        state.Round = _frames[frame].Round;
        return state;
    }

    /// <summary>Drops the frames after one, which <see cref="Find"/> has just made.</summary>
    public void CutAfter(long frame, StateStream state)
    {
        if (ReferenceEquals(state, _next))
        {
            (_newest, _next) = (_next, _newest);
        }
        else if (ReferenceEquals(state, _spare))
        {
            (_newest, _spare) = (_spare, _newest);
        }

        ref Frame last = ref _frames[frame];
        _words.DropFrom(last.WordAt + last.Key.Words);
        _objects.DropFrom(last.ObjectAt + last.Key.Objects);
        last.Back = default;
        _frames.DropFrom(frame + 1);
    }

    /// <summary>Drops all frames; the numbers go on.</summary>
    public void Clear()
    {
        _words.DropBefore(_words.End);
        _objects.DropBefore(_objects.End);
        _frames.DropBefore(_frames.End);
        _newest.CopyFrom(_nothing);
        _next.CopyFrom(_nothing);
        _spare.CopyFrom(_nothing);
    }

    private static long Bytes(StateStream s) => s.Length + ((long)s.ObjectCount * IntPtr.Size);

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
        _delta.Forget();
    }

    private void Load(long words, long objects, Piece piece)
    {
        _delta.Prepare(piece.Words, piece.Objects, out Span<uint> wordSpan, out Span<object?> objectSpan);
        _words.CopyTo(words, wordSpan);
        _objects.CopyTo(objects, objectSpan);
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
