using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Queries;

/// <summary>
/// Rays, boxes, shapes and points against all colliders at the present poses. The answers are those of a look at every collider in turn;
/// equal ones come in the order in which the colliders were made.
/// </summary>
internal sealed unsafe partial class WorldQueries
{
    private readonly ShapeStore _shapes;
    private readonly BodyStore _bodies;
    private readonly QueryIndex _index;

    // Who the world tells of changes: this one, or that with which it shares the index.
    [NotState(Why.Fixed)]
    private readonly WorldQueries _told;
    private readonly NearSearch<RayProbe> _rays = new NearSearch<RayProbe>();
    private readonly NearSearch<PointProbe> _points = new NearSearch<PointProbe>();
    [NotState(Why.OfOneStep)]
    private readonly IndexList _found = new IndexList();
    [NotState(Why.OfOneStep)]
    private readonly Column<ulong> _keys = new Column<ulong>();
    [NotState(Why.OfOneStep)]
    private readonly Column<int> _values = new Column<int>();
    [NotState(Why.OfOneStep)]
    private readonly Column<RayHit> _hits = new Column<RayHit>();
    private readonly RadixSort _sort = new RadixSort();
    [NotState(Why.OfOneStep)]
    private QueryFilter _filter;
    [NotState(Why.Calm)]
    private bool _isAsking;

    public WorldQueries(ShapeStore shapes, BodyStore bodies)
    {
        _shapes = shapes;
        _bodies = bodies;
        _index = new QueryIndex();
        _told = this;
    }

    /// <summary>
    /// Asks the same world, with memory of its own: two threads may ask by one each at a time, while the world is left alone.
    /// </summary>
    public WorldQueries(WorldQueries other)
    {
        _shapes = other._shapes;
        _bodies = other._bodies;
        _index = other._index;
        _told = other._told;
    }

    /// <summary>A query was asked once: from then on <see cref="Changed"/> and <see cref="Removed"/> must be called.</summary>
    public bool IsUsed => _index.IsUsed;

    /// <summary>Differs from step to step: bodies have moved.</summary>
    public long Version { get; set; }

    /// <summary>Writes, or reads, what later queries read of it.</summary>
    public void Visit(StateStream s)
    {
        Version = s.Value(Version);
        _index.Visit(s);
    }

    /// <summary>True while joints of the user's own see the poses of a substep: then no two queries find the same ones.</summary>
    [NotState(Why.Calm)]
    public bool PosesChange { get; set; }

    /// <summary>The next query only reads; within a step in which poses change for each, one thread asks alone.</summary>
    public bool IsFresh => PosesChange || _index.IsFresh(Version);

    /// <summary>Does what the next query would do first; <see cref="MarkFresh"/> says that it is done.</summary>
    public void Follow() => _index.Follow(_shapes, _bodies, Version);

    public void MarkFresh() => _index.MarkFresh(Version);

    public void Changed(int piece) => _index.Changed(piece);

    public void Removed(int piece) => _index.Removed(piece);

    /// <summary>Finds the colliders whose boxes share a point with a box, in the order of their making.</summary>
    public void FindInBox(in Box box, in QueryFilter filter, IndexList colliders)
    {
        Begin(filter);
        try
        {
            Gather(box);
            int kept = 0;
            for (int i = 0; i < _found.Count; i++)
            {
                int piece = _found[i];
                if (Sees(piece) && Box.Overlap(_shapes.TightBox(piece, PoseOf(piece)), box))
                {
                    _found.Pointer[kept++] = _shapes.Pieces[piece].Collider;
                }
            }

            _found.SetCount(kept);
            Deliver(colliders);
        }
        finally
        {
            _isAsking = false;
        }
    }

    /// <summary>Finds the colliders that a world point is in or on, in the order of their making.</summary>
    public void FindAtPoint(double x, double y, in QueryFilter filter, IndexList colliders)
    {
        Begin(filter);
        try
        {
            Gather(Box.FromDouble(x, y, x, y));
            int kept = 0;
            for (int i = 0; i < _found.Count; i++)
            {
                int piece = _found[i];
                if (Sees(piece) && LocalPath(piece, new RayInput { X = x, Y = y }).StartsIn(_shapes, piece))
                {
                    _found.Pointer[kept++] = _shapes.Pieces[piece].Collider;
                }
            }

            _found.SetCount(kept);
            Deliver(colliders);
        }
        finally
        {
            _isAsking = false;
        }
    }

    /// <summary>Finds the collider whose outline is nearest to a point, or that the point is deepest in.</summary>
    public bool FindNearest(double x, double y, double most, in QueryFilter filter, out NearHit hit)
    {
        hit = default;
        hit.Distance = most;
        bool found = false;
        Begin(filter);
        try
        {
            _points.Begin(_index.Tree, _index.Loose, new PointProbe(x, y));
            while (_points.Next(Above(Math.Max(hit.Distance, 0)), out int piece, out _))
            {
                if (!Sees(piece))
                {
                    continue;
                }

                int collider = _shapes.Pieces[piece].Collider;
                NearHit near = PointQuery.Nearest(_shapes, collider, PoseOf(piece), x, y);
                if (near.Distance < hit.Distance || (near.Distance == hit.Distance && (!found || IsOlder(collider, hit.Collider))))
                {
                    hit = near;
                    found = true;
                }
            }
        }
        finally
        {
            _isAsking = false;
        }

        return found;
    }

    /// <summary>
    /// Smallest float that is not below a share or a distance: a bound for boxes, whose own bounds err by less than the last factor.
    /// </summary>
    private static float Above(double value) => value >= float.MaxValue ? float.MaxValue : (float)(value * 1.000001);

    private ref BodyPose PoseOf(int piece) => ref _bodies.Pose[_shapes.Pieces[piece].Body];

    private bool IsOlder(int collider, int than) => _shapes.Order[collider] < _shapes.Order[than];

    private void Begin(in QueryFilter filter)
    {
        if (_isAsking)
        {
            throw new InvalidOperationException("A query must not be asked from within the filter of another.");
        }

        _isAsking = true;
        _filter = filter;
        if (_told.PosesChange)
        {
            _told.Version++;
        }

        _index.Refresh(_shapes, _bodies, _told.Version);
    }

    private bool Sees(int piece)
    {
        const BodyFlags Present = BodyFlags.Alive | BodyFlags.Enabled;
        ref Piece p = ref _shapes.Pieces[piece];
        ref ColliderInfo info = ref _shapes.Colliders[p.Collider];
        ColliderFlags required = _filter.Required | ColliderFlags.Alive;
        return (info.Flags & required) == required
            && (info.Categories & _filter.Categories) != 0
            && (_bodies.Flags[p.Body] & Present) == Present
            && (p.Body == 0 || (p.Body != _filter.IgnoredBody && p.Body != _filter.OtherIgnoredBody))
            && (_filter.Predicate == null || _filter.Predicate.Accept(p.Collider));
    }

    /// <summary>Lists the pieces whose boxes of the index share a point with a box.</summary>
    private void Gather(in Box box)
    {
        _found.Clear();
        _index.Tree.Overlap(box, _found);
        var spread = new SpreadBox(box);
        for (int first = 0; first < _index.Loose.Count; first += WideBoxes.Width)
        {
            for (uint mask = _index.Loose.Boxes.Overlaps(first, spread); mask != 0; mask &= mask - 1)
            {
                _found.Add(_index.Loose.Proxy(first + WideBoxes.LowestLane(mask)));
            }
        }
    }

    /// <summary>Hands over the colliders found, each once, in the order of their making.</summary>
    private void Deliver(IndexList colliders)
    {
        colliders.Clear();
        SortByOrder(_found.Count);
        for (int i = 0; i < _found.Count; i++)
        {
            int collider = _values[i];
            if (i == 0 || collider != _values[i - 1])
            {
                colliders.Add(collider);
            }
        }
    }

    private void SortByOrder(int count)
    {
        _keys.EnsureCapacity(Math.Max(1, count));
        _values.EnsureCapacity(Math.Max(1, count));
        for (int i = 0; i < count; i++)
        {
            _keys[i] = (uint)_shapes.Order[_found[i]];
            _values[i] = _found[i];
        }

        _sort.Sort(_keys.Pointer, _values.Pointer, count);
    }

    /// <summary>A way in the coordinates of a piece's body.</summary>
    private RayPath LocalPath(int piece, in RayInput ray)
    {
        ref BodyPose pose = ref PoseOf(piece);
        double dx = ray.X - pose.X;
        double dy = ray.Y - pose.Y;

        // The rotor is unit only to float rounding; dividing by its square makes this the exact inverse of the pose.
        double inverse = 1 / (((double)pose.Cos * pose.Cos) + ((double)pose.Sin * pose.Sin));
        double cos = pose.Cos * inverse;
        double sin = pose.Sin * inverse;
        RayPath path = default;
        path.X = (cos * dx) + (sin * dy);
        path.Y = (cos * dy) - (sin * dx);
        path.DirectionX = (cos * ray.DirectionX) + (sin * ray.DirectionY);
        path.DirectionY = (cos * ray.DirectionY) - (sin * ray.DirectionX);
        return path;
    }

    private static Vector2 WorldNormal(in BodyPose pose, double x, double y)
    {
        double worldX = (pose.Cos * x) - (pose.Sin * y);
        double worldY = (pose.Sin * x) + (pose.Cos * y);
        double length = Math.Sqrt((worldX * worldX) + (worldY * worldY));
        return length > 0 ? new Vector2((float)(worldX / length), (float)(worldY / length)) : Vector2.Zero;
    }
}
