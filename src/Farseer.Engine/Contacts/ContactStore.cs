using System;
using System.Runtime.InteropServices;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

[Flags]
internal enum ContactFlags : byte
{
    None = 0,

    /// <summary>The surfaces touch, or will within this step.</summary>
    Touching = 1,

    /// <summary>Gives impulses: both colliders respond and at least one body can move.</summary>
    Solid = 2,

    /// <summary>A handler cancelled the response when last asked: the pair has no row until it is asked again.</summary>
    Vetoed = 4,

    /// <summary>
    /// Listeners are to be told of a contact: the pair touches, may get an impulse before the next narrow phase, or got one since
    /// the last. The solver looks one substep beyond the step, so a pair may be about to touch, bounce, and never be seen touching.
    /// </summary>
    Due = 16,

    /// <summary>A listener of either collider wants the points: the manifold is kept.</summary>
    Heard = 8,
}

/// <summary>By which kernel the manifolds of a pair are found.</summary>
internal enum PairKind : byte
{
    Boxes,
    Circles,
    CircleAndHull,

    /// <summary>Any others, most of them hulls.</summary>
    Hulls,
}

/// <summary>
/// A pair of pieces whose fat boxes overlap, 24 bytes. Its colliders are those of the pieces, its impulses and its constraint live in a
/// lane of a <see cref="ContactBundle"/>.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal struct ContactRecord
{
    public int PieceA;
    public int PieceB;
    public int BodyA;
    public int BodyB;

    /// <summary>Colour of a pair that has no row.</summary>
    public const int Idle = -1;

    /// <summary>Colour of a pair that sleeps and has no row.</summary>
    public const int DormantIdle = -2;

    /// <summary>Colour of a row that sleeps: one behind all others.</summary>
    public const int DormantRow = 65;

    public int Row;

    /// <summary>Colour of its row, or <see cref="Idle"/>: not in the graph, <see cref="Row"/> then counts in the idle list.</summary>
    public sbyte Color;
    public ContactFlags Flags;

    /// <summary>How many there are of <see cref="PairKind"/>.</summary>
    public const int Kinds = 4;

    private const int SeveralMark = 128;

    /// <summary>A alone can move, or B alone.</summary>
    private const int MoverAMark = 64;
    private const int MoverBMark = 32;
    private const int KindMask = MoverBMark - 1;

    private byte _kind;

    /// <summary>Group of its row.</summary>
    public byte Group;

    /// <summary>A collider of the pair has several pieces: the pair of colliders may have further records.</summary>
    public bool OfSeveral
    {
        readonly get => (_kind & SeveralMark) != 0;
        set => _kind = (byte)(value ? _kind | SeveralMark : _kind & ~SeveralMark);
    }

    /// <summary>Only for what is done together: what a piece is may change while the pair lasts.</summary>
    public PairKind Kind
    {
        readonly get => (PairKind)(_kind & KindMask);
        set => _kind = (byte)((_kind & ~KindMask) | (int)value);
    }

    /// <summary>The piece that can move, of a pair with one that cannot; else -1.</summary>
    public readonly int Mover => (_kind & MoverAMark) != 0 ? PieceA : (_kind & MoverBMark) != 0 ? PieceB : -1;

    /// <summary>Notes which sides can move, while the pair lasts.</summary>
    public void SetMovers(bool a, bool b)
    {
        int mark = a == b ? 0 : a ? MoverAMark : MoverBMark;
        _kind = (byte)((_kind & ~(MoverAMark | MoverBMark)) | mark);
    }

    /// <summary>True for a pair in the idle list.</summary>
    public readonly bool IsIdle => Color == Idle;

    /// <summary>True if the pair sleeps: both bodies are asleep, or one is and the other does not move.</summary>
    public readonly bool IsDormant => Color == DormantIdle || Color == DormantRow;
}

/// <summary>All pairs, the map from pieces to pairs, and the list of pairs without a row.</summary>
internal sealed class ContactStore
{
    /// <summary>
    /// In the idle list a pair's kind stands above its number: a column holds fewer records than there are numbers below it.
    /// </summary>
    private const int KindShift = 28;
    private const int NumberMask = (1 << KindShift) - 1;

    /// <summary>Records that are moved or made, from one to that asked for.</summary>
    private const int Ahead = 6;

    private readonly ShapeStore _shapes;
    private readonly ColumnSet _set = new ColumnSet();

    // The pairs without a row; behind as many places as there are pairs the records that are free, the last one freed first.
    private readonly Column<int> _idle;
    private readonly Column<int> _idleA;
    private readonly Column<int> _idleB;

    // Of each piece the first of its pairs with what cannot move, and of these pairs the next and the one before; all one more than they
    // are, 0: none. They reach as far as the last such pair: of a pile few have to do with what cannot move.
    private readonly Column<int> _firstAtFixed;
    private readonly Column<int> _nextAtFixed = new Column<int>();
    private readonly Column<int> _previousAtFixed = new Column<int>();
    private readonly Column<IdleBundle> _gaps = new Column<IdleBundle>();

    private bool _keepsManifolds;
    private bool _keepsFriction;

    /// <param name="shapes">The pieces of the pairs.</param>
    public ContactStore(ShapeStore shapes)
    {
        _shapes = shapes;
        Records = _set.Add<ContactRecord>();
        _idle = _set.Add<int>();
        _idleA = _set.Add<int>();
        _idleB = _set.Add<int>();
        _firstAtFixed = shapes.PieceSet.Add<int>();
    }

    public Column<ContactRecord> Records { get; }

    /// <summary>Last manifold of pairs that a listener hears; empty until there is a listener.</summary>
    public Column<Manifold> Manifolds { get; } = new Column<Manifold>();

    /// <summary>Friction when the pair was made, in worlds that freeze it; empty in others.</summary>
    public Column<float> FirstFriction { get; } = new Column<float>();

    /// <summary>Of pairs whose surfaces are not what their colliders say.</summary>
    public PairSurfaces Surfaces { get; } = new PairSurfaces();

    public PairMap Map { get; } = new PairMap();

    /// <summary>How many records there are of a pair of colliders of which one has several pieces.</summary>
    public PairMap Compounds { get; } = new PairMap();

    public int Count { get; private set; }

    /// <summary>One past the highest record in use.</summary>
    public int End { get; private set; }

    public int IdleCount { get; private set; }

    /// <summary>
    /// Bodies of the pairs without a row, in the order of the idle list, for walks on lanes; 0 from the last one to the end of its bundle.
    /// By the records that were a walk over five times as many, most of them free where more pairs were at one time: 1.2 % of a step of
    /// spinner.
    /// </summary>
    public unsafe int* IdleBodyA => _idleA.Pointer;

    /// <inheritdoc cref="IdleBodyA"/>
    public unsafe int* IdleBodyB => _idleB.Pointer;

    public int Idle(int position) => _idle[position] & NumberMask;

    public PairKind IdleKind(int position) => (PairKind)(_idle[position] >> KindShift);

    /// <summary>Motions of the bodies, while gaps are kept.</summary>
    public BodySteps Steps { get; } = new BodySteps();

    /// <summary>The gaps of the pairs without a row are kept: worth their while where there are many.</summary>
    public bool KeepsGaps { get; private set; }

    /// <summary>The gaps of the pairs without a row, while they are kept.</summary>
    public unsafe IdleBundle* Gaps => _gaps.Pointer;

    /// <summary>Keeps gaps from now on or no longer. Of none of the pairs that there are anything is known at first.</summary>
    public void KeepGaps(bool value)
    {
        if (value && !KeepsGaps)
        {
            EnsureGaps();
            for (int i = 0; i < IdleCount; i++)
            {
                NameGap(i, Records[Idle(i)]);
            }
        }

        KeepsGaps = value;
    }

    /// <summary>Takes a pair out of the idle list, to sleep.</summary>
    public void LayDown(int index)
    {
        RemoveIdle(index);
        Records[index].Color = ContactRecord.DormantIdle;
    }

    /// <summary>There is a listener: from now on manifolds are kept.</summary>
    public void KeepManifolds()
    {
        _keepsManifolds = true;
        Manifolds.EnsureCapacity(Records.Capacity);
    }

    /// <summary>Makes room for so many pairs, in all that is kept of them, with their gaps if these are going to be.</summary>
    public void Reserve(int pairs, bool withGaps)
    {
        Map.EnsureCapacity(pairs);
        EnsureCapacity(pairs);
        EnsureLinks(Records.Capacity);
        if (withGaps)
        {
            EnsureGaps();
        }
    }

    /// <summary>
    /// Makes room for so many more pairs at once, if they are many: grown one by one there would be up to a quarter to spare.
    /// </summary>
    public void Expect(int more)
    {
        if (more > Count)
        {
            EnsureCapacity(Count + more);
        }
    }

    /// <summary>
    /// Whether frictions are kept from now on. When that begins, nobody knows any more what they were when the pairs were made, and the
    /// present ones are kept.
    /// </summary>
    /// <returns>True if it begins: the frictions of the pairs that there are must be set.</returns>
    public bool KeepFriction(bool value)
    {
        bool begins = value && !_keepsFriction;
        _keepsFriction = value;
        if (begins)
        {
            FirstFriction.EnsureCapacity(Records.Capacity);
        }

        return begins;
    }

    public int Create(ulong key, in ContactRecord record)
    {
        int index;
        if (Count < End)
        {
            index = _idle[Count];
            AskFor(_idle[Math.Min(Count + Ahead, End - 1)]);
        }
        else
        {
            index = End++;
            EnsureCapacity(End);
        }

        Records[index] = record;
        if (_keepsManifolds)
        {
            Manifolds[index] = default;
        }

        Map.Set(key, index);
        Count++;
        AddIdle(index);
        if (record.Mover >= 0)
        {
            Link(index, record.Mover);
        }

        if (record.OfSeveral)
        {
            ulong colliders = ColliderKey(record);
            Compounds.TryGet(colliders, out int others);
            Compounds.Set(colliders, others + 1);
        }

        return index;
    }

    /// <summary>Asks for a record that is needed soon.</summary>
    public unsafe void AskFor(int index) => Prefetch.Line(Records.Pointer + index);

    public static ulong ColliderKey(int a, int b) => ((ulong)(uint)a << 32) | (uint)b;

    /// <summary>Forgets a pair that is in the idle list but for its place in <see cref="Map"/>, which is for the caller to clear.</summary>
    public void Forget(int index)
    {
        RemoveIdle(index);
        if (Records[index].OfSeveral)
        {
            Leave(ColliderKey(Records[index]));
        }

        if (Records[index].Mover >= 0)
        {
            Unlink(index, Records[index].Mover);
        }

        Records[index] = default;
        Records[index].PieceA = -1;
        _idle[--Count] = index;
    }

    /// <summary>The first of the pairs of a piece that can move with pieces that cannot, in no order; -1: none.</summary>
    public int FirstAtFixed(int piece) => _firstAtFixed[piece] - 1;

    /// <summary>The pair behind one of these; -1: none.</summary>
    public int NextAtFixed(int contact) => _nextAtFixed[contact] - 1;

    private void Link(int contact, int piece)
    {
        int next = _firstAtFixed[piece];
        EnsureLinks(contact + 1);
        _nextAtFixed[contact] = next;
        _previousAtFixed[contact] = 0;
        _firstAtFixed[piece] = contact + 1;
        if (next > 0)
        {
            _previousAtFixed[next - 1] = contact + 1;
        }
    }

    private void EnsureLinks(int contacts)
    {
        _nextAtFixed.EnsureCapacity(contacts);
        _previousAtFixed.EnsureCapacity(contacts);
    }

    private void Unlink(int contact, int piece)
    {
        int next = _nextAtFixed[contact];
        int previous = _previousAtFixed[contact];
        if (previous > 0)
        {
            _nextAtFixed[previous - 1] = next;
        }
        else
        {
            _firstAtFixed[piece] = next;
        }

        if (next > 0)
        {
            _previousAtFixed[next - 1] = previous;
        }
    }

    private ulong ColliderKey(in ContactRecord record) => ColliderKey(_shapes.ColliderOf(record.PieceA), _shapes.ColliderOf(record.PieceB));

    private void Leave(ulong colliders)
    {
        if (Compounds.Remove(colliders, out int records) && records > 1)
        {
            Compounds.Set(colliders, records - 1);
        }
    }

    public void AddIdle(int index)
    {
        ref ContactRecord record = ref Records[index];
        record.Color = ContactRecord.Idle;
        record.Row = IdleCount;
        if (KeepsGaps)
        {
            NameGap(IdleCount, record);
        }

        _idleA[IdleCount] = record.BodyA;
        _idleB[IdleCount] = record.BodyB;
        _idle[IdleCount++] = index | ((int)record.Kind << KindShift);
    }

    public unsafe void RemoveIdle(int index)
    {
        int row = Records[index].Row;
        int last = _idle[--IdleCount];
        AskFor(Idle(Math.Max(IdleCount - Ahead, 0)));
        _idle[row] = last;
        _idleA[row] = _idleA[IdleCount];
        _idleB[row] = _idleB[IdleCount];
        _idleA[IdleCount] = 0;
        _idleB[IdleCount] = 0;
        if (KeepsGaps)
        {
            IdleGap.Move(Gaps, IdleCount, row);
        }

        Records[last & NumberMask].Row = row;
        Records[index].Row = -1;
    }

    private void EnsureCapacity(int pairs)
    {
        _set.EnsureCapacity((pairs + ContactBundle.Lanes - 1) / ContactBundle.Lanes * ContactBundle.Lanes);
        if (KeepsGaps)
        {
            EnsureGaps();
        }

        if (_keepsManifolds)
        {
            Manifolds.EnsureCapacity(Records.Capacity);
        }

        if (_keepsFriction)
        {
            FirstFriction.EnsureCapacity(Records.Capacity);
        }
    }

    private void EnsureGaps() => _gaps.EnsureCapacity((Records.Capacity + IdleBundle.Lanes - 1) / IdleBundle.Lanes);

    private unsafe void NameGap(int place, in ContactRecord record) => IdleGap.Name(Gaps, place, record);

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_firstAtFixed);
        s.Column(_idle);
        s.Column(_idleA);
        s.Column(_idleB);
        s.Column(_nextAtFixed);
        s.Column(_previousAtFixed);
        s.Column(_gaps);
        s.Value(ref _keepsManifolds);
        s.Value(ref _keepsFriction);
        s.Column(Records);
        s.Column(Manifolds);
        s.Column(FirstFriction);
        Map.Visit(s);
        Compounds.Visit(s);
        Count = s.Value(Count);
        End = s.Value(End);
        IdleCount = s.Value(IdleCount);
        Steps.Visit(s);
        Surfaces.Visit(s);
        KeepsGaps = s.Value(KeepsGaps);
    }
}
