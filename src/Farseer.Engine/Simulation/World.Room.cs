using System;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.Simulation;

/// <content>
/// Room for contacts to come. Bodies that touch nothing yet will pile up, and a pile has several contacts a body: what grew with them
/// went on allocating for seconds. A pile that was built as one and does not bounce has its contacts in its first step, and gets no more room
/// than these need. What is not used is address space that nobody touches.
/// </content>
internal sealed partial class World
{
    /// <summary>
    /// Pairs and rows for each piece: of the timing scenes smash and spinner come to 9 pairs and 4.9 rows, piles of discs or polygons to 4
    /// and 2.7.
    /// </summary>
    private const int PairsAPiece = 10;
    private const int RowsAPiece = 5;

    /// <summary>Twice the rows for each piece from which on a world lies as dense as it will: 2.97 in a large pyramid, 2 in a grid of boxes.</summary>
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

    /// <summary>What a fast body may meet, for which there is room before there is one.</summary>
    private const int FewCandidates = 16;

    private bool _roomIsDue;

    /// <summary>Makes room once colliders have come, after their first contacts are known.</summary>
    private void MakeRoomAhead()
    {
        MakeRoomToSleep();
        _sweep.Reserve(Math.Min(_contacts.Records.Capacity, FewCandidates));
        _secondSweep.Reserve(Math.Min(_contacts.Records.Capacity, FewCandidates));
        if (!_roomIsDue || _contacts.Count == 0)
        {
            return;
        }

        _roomIsDue = false;
        _islands.Reserve(Bodies.State.Capacity, _graph.RowCount);
        int pieces = CountPieces(out int hulls, out int immovable, out bool anySeveral);
        _immovable.Reserve(Math.Min(immovable, MostInARow + 1));
        if (pieces > FewPieces && _graph.RowCount * 2L >= (long)DenseTwice * pieces && !_contactStage.AnyBounce)
        {
            return;
        }

        Bodies.EnsureResiduals();
        _sagForecast.Reserve(Bodies.State.Capacity);
        _feedForward.Reserve(Bodies.State.Capacity);
        _carriedPushes.Reserve(Bodies.State.Capacity);
        pieces = Math.Min(pieces, MostPieces);

        // In a small world each with each other comes to less.
        int pairs = (int)Math.Min(PairsAPiece * pieces, ((pieces - 1L) * pieces / 2) + ((long)pieces * immovable));
        int rows = Math.Min(RowsAPiece * pieces, pairs);
        _contacts.Reserve(pairs, withGaps: hulls * 2 > pieces);
        _contacts.Compounds.EnsureCapacity(anySeveral ? Math.Max(2 * _contacts.Compounds.Count, pieces / 4) : 0);
        _pairs.Expect(pairs);
        _graph.Reserve(rows);
        _solver.Reserve(_graph.Arena.Capacity);
        _islands.Reserve(Bodies.State.Capacity, rows);
        Scratch.Reserve(ScratchBesides + (ScratchAPair * pairs) + (ScratchARow * rows) + (ScratchAPiece * Shapes.PieceIds.End));
        if (hulls * 2 > pieces)
        {
            _contactStage.ReserveForGaps(this, _contacts);
        }
    }

    /// <summary>Room for as many bodies and contacts as there are to fall asleep and to wake, which may be after a thousand steps.</summary>
    private void MakeRoomToSleep()
    {
        if (Settings.AllowSleep && Bodies.Ids.End > 1)
        {
            int bodies = Bodies.State.Capacity;
            _rest.Reserve(bodies);
            _flood.Reserve(bodies);
            _handled.Reserve(bodies);
            _layDown.Reserve(_contacts.Records.Capacity);
            _dormant.Reserve(_contacts.Records.Capacity, bodies);
        }
    }

    /// <summary>Pieces that can move and may collide with any other, how many of them are neither boxes nor discs, those that cannot move, and whether a collider has several.</summary>
    private int CountPieces(out int hulls, out int immovable, out bool anySeveral)
    {
        int count = 0;
        anySeveral = false;
        hulls = 0;
        immovable = 0;
        for (int i = 0; i < Shapes.PieceIds.End; i++)
        {
            ref Piece piece = ref Shapes.Pieces[i];
            if (!Shapes.PieceIds.IsUsed(i))
            {
                continue;
            }

            anySeveral |= Shapes.NextPiece[i] >= 0;
            if (!IsMovable(piece.Body))
            {
                immovable++;
            }
            else if (Shapes.Colliders[piece.Collider].Group == 0)
            {
                count++;
                hulls += piece.Kind != ShapeKind.Box && piece.Kind != ShapeKind.Circle ? 1 : 0;
            }
        }

        return count;
    }
}
