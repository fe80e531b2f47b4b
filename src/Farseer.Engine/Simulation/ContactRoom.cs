using System;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Room for contacts to come. Bodies that touch nothing yet will pile up, and a pile has several contacts a body: what grew with them
/// went on allocating for seconds. A pile that was built as one and does not bounce has its contacts in its first step, and gets no more
/// room than these need. What is not used is address space that nobody touches.
/// </summary>
internal sealed class ContactRoom : WorldPhase
{
    /// <summary>
    /// Pairs and rows for each piece: of the timing scenes smash and spinner come to 9 pairs and 4.9 rows, piles of discs or polygons to 4
    /// and 2.7.
    /// </summary>
    private const int PairsAPiece = 10;
    private const int RowsAPiece = 5;

    /// <summary>
    /// Twice the rows for each piece from which on a world lies as dense as it will: 2.97 in a large pyramid, 2 in a grid of boxes.
    /// </summary>
    private const int DenseTwice = 5;

    /// <summary>So few pieces get room for a crowd all the same: it is little, and they may be heaped up later.</summary>
    private const int FewPieces = 256;

    /// <summary>Of more pieces the rest comes by need: a growth by a quarter is seldom then, and the room would be gigabytes.</summary>
    private const int MostPieces = 1 << 15;

    /// <summary>Bytes of scratch memory for each pair, each row and each piece: what the narrow phase notes of them.</summary>
    private const int ScratchAPair = 16;
    private const int ScratchARow = 12;
    private const int ScratchAPiece = 64;

    /// <summary>And for what some steps note besides.</summary>
    private const int ScratchBesides = 1 << 13;

    /// <summary>Steps of a dense world after which it is known what a step takes.</summary>
    private const int StepsToTrim = 16;

    private readonly SleepStage _sleep;
    private readonly ContactStage _contactStage;
    private readonly PairFinder _pairs;
    private readonly SweepStage _sweeps;
    private readonly SolveStage _solve;
    private bool _roomIsDue;

    /// <summary>Steps until memory that only the first ones needed is given back; 0: it was, or it is not to be.</summary>
    [NotState(Why.Room)]
    private int _trimIn;

    public ContactRoom(
        WorldStores stores, SleepStage sleep, ContactStage contactStage, PairFinder pairs, SweepStage sweeps, SolveStage solve)
        : base(stores)
    {
        _sleep = sleep;
        _contactStage = contactStage;
        _pairs = pairs;
        _sweeps = sweeps;
        _solve = solve;
    }

    /// <summary>Colliders have come.</summary>
    public void NoteDue() => _roomIsDue = true;

    /// <summary>Makes room once colliders have come, after their first contacts are known.</summary>
    public void MakeAhead()
    {
        _sleep.Reserve();
        _sweeps.ReserveFew();
        if (!_roomIsDue || _contacts.Count == 0)
        {
            AwaitTrim();
            return;
        }

        _roomIsDue = false;
        _islands.Reserve(_bodies.State.Capacity, _graph.RowCount);
        int pieces = CountPieces(out int hulls, out int immovable, out bool anySeveral);
        _sweeps.Reserve(immovable);
        if (pieces > FewPieces && _graph.RowCount * 2L >= (long)DenseTwice * pieces && !_contactStage.AnyBounce)
        {
            _trimIn = StepsToTrim;
            return;
        }

        _trimIn = 0;
        _bodies.EnsureResiduals();
        _solve.ReserveBodies(_bodies.State.Capacity);
        pieces = Math.Min(pieces, MostPieces);

        // In a small world each with each other comes to less.
        int pairs = (int)Math.Min(PairsAPiece * pieces, ((pieces - 1L) * pieces / 2) + ((long)pieces * immovable));
        int rows = Math.Min(RowsAPiece * pieces, pairs);
        _contacts.Reserve(pairs, withGaps: hulls * 2 > pieces);
        _contacts.Compounds.EnsureCapacity(anySeveral ? Math.Max(2 * _contacts.Compounds.Count, pieces / 4) : 0);
        _pairs.Expect(pairs);
        _graph.Reserve(rows);
        _solve.ReserveRows(_graph.Arena.Capacity);
        _islands.Reserve(_bodies.State.Capacity, rows);
        _stores.Scratch.Reserve(ScratchBesides + (ScratchAPair * pairs) + (ScratchARow * rows) + (ScratchAPiece * _shapes.PieceIds.End));
        if (hulls * 2 > pieces)
        {
            _contactStage.ReserveForGaps(_stores, _contacts);
        }
    }

    /// <summary>
    /// The first step of a world that lies dense finds all its pairs, and takes twice as much memory for that as any later one. What
    /// nobody has needed for some steps is given back.
    /// </summary>
    private void AwaitTrim()
    {
        if (_trimIn > 0 && _proxies.HasScratch)
        {
            _trimIn--;
            if (_trimIn == StepsToTrim - 1)
            {
                _stores.Scratch.Watch();
            }

            _stores.TrimIsDue = _trimIn == 0;
        }
    }

    /// <summary>
    /// Pieces that can move and may collide with any other, how many of them are neither boxes nor discs, those that cannot move, and
    /// whether a collider has several.
    /// </summary>
    private int CountPieces(out int hulls, out int immovable, out bool anySeveral)
    {
        int count = 0;
        anySeveral = false;
        hulls = 0;
        immovable = 0;
        for (int i = 0; i < _shapes.PieceIds.End; i++)
        {
            ref Piece piece = ref _shapes.Pieces[i];
            if (!_shapes.PieceIds.IsUsed(i))
            {
                continue;
            }

            anySeveral |= _shapes.NextPiece[i] >= 0;
            if (!_bodies.IsMovable(piece.Body))
            {
                immovable++;
            }
            else if (_shapes.Colliders[piece.Collider].Group == 0)
            {
                count++;
                hulls += piece.Kind != ShapeKind.Box && piece.Kind != ShapeKind.Circle ? 1 : 0;
            }
        }

        return count;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Of(nameof(ContactRoom)).Value(ref _roomIsDue);
        _roomIsDue |= s.IsReading && s.Room is not null;
    }
}
