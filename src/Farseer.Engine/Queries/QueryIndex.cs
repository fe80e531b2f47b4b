using System;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Queries;

/// <summary>
/// The boxes that queries search, in a packed tree. It is nobody's until the first query and follows the bodies only when one is
/// asked, so a step without queries does not pay for it. A box is larger than its piece, more so for a piece that has left its last
/// one: after a step most boxes still hold.
/// </summary>
internal sealed unsafe class QueryIndex
{
    /// <summary>A box is larger than its piece by this share of the piece's extent.</summary>
    private const float MarginShare = 0.1f;

    /// <summary>And by this many times the way that the piece has gone since its last box was made.</summary>
    private const double TravelShare = 3;

    /// <summary>Refitting a box costs as much as building so many anew.</summary>
    private const int RefitCost = 8;

    /// <summary>So many boxes may lie loose beside the tree, and one more for each <see cref="LooseShare"/> in it.</summary>
    private const int FewLoose = 32;
    private const int LooseShare = 16;

    private const int Nowhere = -1;
    private const long Stale = -1;
    private const int FirstLoose = -2;

    private readonly Column<PieceFit> _fits = new Column<PieceFit>();
    private readonly Column<Box> _boxes = new Column<Box>();
    private readonly IndexList _changed = new IndexList();
    [NotState(Why.OfOneStep)]
    private readonly IndexList _due = new IndexList();
    [NotState(Why.OfOneStep)]
    private readonly IndexList _members = new IndexList();
    private readonly Scratch _scratch = new Scratch();
    private long _version;

    /// <summary>
    /// The version that all boxes are up to, written when they are; <see cref="Stale"/>: some are not, as after a state was gone back to.
    /// </summary>
    private long _fresh = Stale;
    private int _known;
    private int _count;

    public PackedTree Tree { get; } = new PackedTree();

    public LooseBoxes Loose { get; } = new LooseBoxes();

    /// <summary>A query was asked once: from then on changes are to be told.</summary>
    public bool IsUsed { get; private set; }

    /// <summary>A piece was added, or its body's pose was set.</summary>
    public void Changed(int piece)
    {
        Know(piece + 1);
        ref PieceFit fit = ref _fits[piece];
        if (!fit.IsChanged)
        {
            fit.IsChanged = true;
            _fresh = Stale;
            _changed.Add(piece);
        }
    }

    /// <summary>A piece is no more.</summary>
    public void Removed(int piece)
    {
        if (piece >= _known)
        {
            return;
        }

        ref PieceFit fit = ref _fits[piece];
        if (fit.Place >= 0)
        {
            Tree.Remove(fit.Place);
            _count--;
        }
        else if (fit.Place <= FirstLoose)
        {
            int place = FirstLoose - fit.Place;
            int moved = Loose.Remove(place);
            if (moved >= 0)
            {
                _fits[moved].Place = FirstLoose - place;
            }

            _count--;
        }

        fit.Place = Nowhere;
    }

    /// <summary>All boxes are up to a version: whoever asks then only reads.</summary>
    public bool IsFresh(long version) => _fresh == version;

    /// <summary>Says that they are.</summary>
    public void MarkFresh(long version) => _fresh = version;

    /// <summary>Brings the boxes up to the poses.</summary>
    /// <param name="shapes">The pieces.</param>
    /// <param name="bodies">The poses.</param>
    /// <param name="version">Differs from that of the last call if a step has moved bodies since.</param>
    public void Refresh(ShapeStore shapes, BodyStore bodies, long version)
    {
        if (_fresh != version)
        {
            Follow(shapes, bodies, version);
            _fresh = version;
        }
    }

    /// <summary>Brings the boxes up to the poses, and does not say so yet.</summary>
    public void Follow(ShapeStore shapes, BodyStore bodies, long version)
    {
        int end = shapes.PieceIds.End;
        Know(end);
        _due.Clear();
        if (!IsUsed)
        {
            IsUsed = true;
            for (int piece = 0; piece < end; piece++)
            {
                if (shapes.Pieces[piece].VertexCount > 0)
                {
                    Changed(piece);
                }
            }
        }

        if (version != _version)
        {
            _version = version;
            FindMoved(shapes, bodies, end);
        }

        for (int i = 0; i < _changed.Count; i++)
        {
            int piece = _changed[i];
            _fits[piece].IsChanged = false;
            if (shapes.Pieces[piece].VertexCount > 0)
            {
                _due.Add(piece);
            }
        }

        _changed.Clear();
        if (_due.Count > 0)
        {
            Update(shapes, bodies, end);
        }
    }

    private void FindMoved(ShapeStore shapes, BodyStore bodies, int end)
    {
        Piece* pieces = shapes.Pieces.Pointer;
        BodyPose* poses = bodies.Pose.Pointer;
        PieceFit* fits = _fits.Pointer;
        ulong* visited = shapes.VisitedPieces.Words;
        for (int piece = 0; piece < end; piece++)
        {
            if (visited[piece >> 6] == 0)
            {
                piece |= 63;
                continue;
            }

            PieceFit* fit = fits + piece;
            if (fit->Place != Nowhere && !fit->IsChanged
                && !(Travel(*fit, poses[pieces[piece].Body], pieces[piece].Reach) <= fit->Margin))
            {
                _due.Add(piece);
            }
        }
    }

    private static double Travel(in PieceFit fit, in BodyPose pose, float reach) =>
        Math.Abs(pose.X - fit.X) + Math.Abs(pose.Y - fit.Y) + (Math.Abs(pose.Angle - fit.Angle) * reach);

    private void Update(ShapeStore shapes, BodyStore bodies, int end)
    {
        int added = 0;
        for (int i = 0; i < _due.Count; i++)
        {
            int piece = _due[i];
            added += _fits[piece].Place == Nowhere ? 1 : 0;
            Fit(shapes, bodies, piece);
        }

        int refitted = _due.Count - added;
        if (Loose.Count + added > FewLoose + (Tree.Count / LooseShare) || (long)refitted * RefitCost > _count + added)
        {
            Build(shapes, end);
            return;
        }

        for (int i = 0; i < _due.Count; i++)
        {
            int piece = _due[i];
            ref PieceFit fit = ref _fits[piece];
            if (fit.Place >= 0)
            {
                Tree.Refit(fit.Place, _boxes[piece]);
            }
            else if (fit.Place <= FirstLoose)
            {
                Loose.Change(FirstLoose - fit.Place, _boxes[piece]);
            }
            else
            {
                fit.Place = FirstLoose - Loose.Add(piece, _boxes[piece]);
                _count++;
            }
        }
    }

    private void Fit(ShapeStore shapes, BodyStore bodies, int piece)
    {
        ref Piece p = ref shapes.Pieces[piece];
        ref BodyPose pose = ref bodies.Pose[p.Body];
        ref PieceFit fit = ref _fits[piece];
        double travel = fit.Place == Nowhere ? 0 : Travel(fit, pose, p.Reach);
        double spare = Math.Min((MarginShare * p.Extent) + (TravelShare * travel), float.MaxValue / 2);
        Box tight = shapes.TightBox(piece, pose);
        _boxes[piece] = Box.FromDouble(tight.MinX - spare, tight.MinY - spare, tight.MaxX + spare, tight.MaxY + spare);
        fit.X = pose.X;
        fit.Y = pose.Y;
        fit.Angle = pose.Angle;

        // Half of it: the sine and cosine of the pose are floats, which far from the body's centre shift the piece a little.
        fit.Margin = 0.5 * spare;
    }

    private void Build(ShapeStore shapes, int end)
    {
        _members.Clear();
        for (int piece = 0; piece < end; piece++)
        {
            if (shapes.Pieces[piece].VertexCount > 0)
            {
                _members.Add(piece);
            }
        }

        Loose.Clear();
        Loose.Reserve(FewLoose + (_members.Count / LooseShare) + 1);
        _count = _members.Count;
        Tree.Reserve(_boxes.Capacity);
        Tree.Build(_scratch, _boxes.Pointer, _members.Pointer, _members.Count);
        for (int slot = 0; slot < Tree.SlotCount; slot++)
        {
            _fits[Tree.Proxy(slot)].Place = slot;
        }
    }

    private void Know(int end)
    {
        if (end > _known)
        {
            _fits.EnsureCapacity(end);
            _boxes.EnsureCapacity(end);
            for (; _known < end; _known++)
            {
                _fits[_known] = new PieceFit { Place = Nowhere };
            }
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    private struct PieceFit
    {
        public double X;
        public double Y;
        public double Angle;

        /// <summary>How far the piece may go until its box does not hold any more.</summary>
        public double Margin;

        /// <summary>Slot in the tree, or −2 less the place among the loose boxes, or −1.</summary>
        public int Place;

        /// <summary>1: it was moved, added or removed since. No byte of a record is left open: this is state.</summary>
        public int Changed;

        public bool IsChanged
        {
            readonly get => Changed != 0;
            set => Changed = value ? 1 : 0;
        }
    }

    /// <summary>
    /// Writes, or reads, what later queries read of it. How loose its boxes are follows from all that went before, and a step
    /// asks it for what a fast body may meet.
    /// </summary>
    public void Visit(StateStream s)
    {
        _fresh = Stale;
        s.Value(ref _version);
        s.Value(ref _known);
        s.Value(ref _count);
        IsUsed = s.Value(IsUsed);
        s.Column(_fits, _known);
        s.Column(_boxes, _known);
        _changed.Visit(s);
        Tree.Visit(s);
        Loose.Visit(s);
    }
}
