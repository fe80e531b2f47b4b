using System;
using System.Collections.Generic;
using System.Numerics;
using System.Threading;
using Farseer.Engine.Numerics;
using Farseer.Engine.Queries;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using EngineFilter = Farseer.Engine.Queries.QueryFilter;
using QueryFilter = FarseerGames.FarseerPhysics.Collisions.QueryFilter;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Hands queries to the engine and turns what it finds into geoms: those that it simulates, and those that wait for the next update. One
/// thread at a time uses it; several use one each, which <see cref="QueryCrowd"/> hands out.
/// </summary>
internal sealed class QueryLink
{
    private readonly PhysicsSimulator _simulator;
    private readonly Target _here;
    private readonly Target _coming;
    private readonly WaitingGeoms _waiting = new WaitingGeoms();
    private readonly IndexList _found = new IndexList();

    /// <summary>The number of the thread that uses it; 0: none.</summary>
    private int _user;

    /// <param name="simulator">Whose geoms are looked for.</param>
    /// <param name="world">Its world.</param>
    /// <param name="queries">Who asks it.</param>
    /// <param name="table">What its colliders stand for.</param>
    public QueryLink(PhysicsSimulator simulator, World world, WorldQueries queries, ObjectTable table)
    {
        _simulator = simulator;
        _here = new Target(() => world, queries, table.Geom, waits: false);
        _coming = new Target(() => _waiting.World, null, _waiting.Find, waits: true);
    }

    /// <summary>Takes it, if nobody uses it.</summary>
    /// <param name="thread">The number of the thread.</param>
    public bool TryUse(int thread) => Interlocked.CompareExchange(ref _user, thread, 0) == 0;

    public bool IsUsedBy(int thread) => Volatile.Read(ref _user) == thread;

    public void Leave() => Volatile.Write(ref _user, 0);

    public bool CastRay(Vector2 start, Vector2 end, QueryFilter? filter, out RayCastHit hit)
    {
        RayInput way = Way(start, end);
        bool found = _here.Queries.CastRay(way, _here.Translate(filter, null), out RayHit first);
        hit = found ? _here.HitOf(first) : default;
        if (AnyWaits && _coming.Queries.CastRay(way, _coming.Translate(filter, null), out first))
        {
            found = Better(found, _coming.HitOf(first), ref hit);
        }

        return found;
    }

    public int CastRayAll(Vector2 start, Vector2 end, QueryFilter? filter, List<RayCastHit> hits)
    {
        hits.Clear();
        RayInput way = Way(start, end);
        Gather(_here, way, filter, hits);
        if (AnyWaits)
        {
            Gather(_coming, way, filter, hits);
        }

        return hits.Count;
    }

    public int FindInBox(AABB box, QueryFilter? filter, List<Geom> geoms)
    {
        var bounds = new Box(box.Min.X, box.Min.Y, box.Max.X, box.Max.Y);
        geoms.Clear();
        _here.Queries.FindInBox(bounds, _here.Translate(filter, null), _found);
        Deliver(_here, geoms);
        if (AnyWaits)
        {
            _coming.Queries.FindInBox(bounds, _coming.Translate(filter, null), _found);
            Deliver(_coming, geoms);
        }

        return geoms.Count;
    }

    public int FindAtPoint(Vector2 point, QueryFilter? filter, List<Geom> geoms)
    {
        geoms.Clear();
        _here.Queries.FindAtPoint(point.X, point.Y, _here.Translate(filter, null), _found);
        Deliver(_here, geoms);
        if (AnyWaits)
        {
            _coming.Queries.FindAtPoint(point.X, point.Y, _coming.Translate(filter, null), _found);
            Deliver(_coming, geoms);
        }

        return geoms.Count;
    }

    public int FindInCircle(Vector2 center, float radius, QueryFilter? filter, List<Geom> geoms)
    {
        geoms.Clear();
        _here.Queries.SetDisc(center.X, center.Y, radius);
        FindOverlapping(filter, null, geoms);
        return geoms.Count;
    }

    public int FindTouching(Geom geom, QueryFilter? filter, List<Geom> geoms)
    {
        geoms.Clear();
        Target own = TargetOf(geom, out int piece);
        ShapeStore shapes = own.World.Shapes;
        for (; piece >= 0; piece = shapes.NextPiece[piece])
        {
            SetPiece(own, piece);
            FindOverlapping(filter, geom, geoms);
        }

        return geoms.Count;
    }

    public bool CastCircle(Vector2 center, float radius, Vector2 translation, QueryFilter? filter, out RayCastHit hit)
    {
        hit = default;
        _here.Queries.SetDisc(center.X, center.Y, radius);
        return CastShape(translation.X, translation.Y, filter, null, false, ref hit);
    }

    /// <summary>A capsule on its way, in double precision.</summary>
    public bool CastCapsule(in CapsuleWay way, QueryFilter? filter, out RayCastHit hit)
    {
        hit = default;
        _here.Queries.SetCapsule(way.X, way.Y, way.X + way.AxisX, way.Y + way.AxisY, way.Radius);
        return CastShape(way.WayX, way.WayY, filter, null, false, ref hit);
    }

    public bool CastGeom(Geom geom, Vector2 translation, QueryFilter? filter, out RayCastHit hit)
    {
        hit = default;
        bool found = false;
        Target own = TargetOf(geom, out int piece);
        ShapeStore shapes = own.World.Shapes;
        for (; piece >= 0; piece = shapes.NextPiece[piece])
        {
            SetPiece(own, piece);
            found = CastShape(translation.X, translation.Y, filter, geom, found, ref hit);
        }

        return found;
    }

    public bool FindNearest(Vector2 point, float maximumDistance, QueryFilter? filter, out ClosestPointHit hit)
    {
        bool found = _here.Queries.FindNearest(point.X, point.Y, maximumDistance, _here.Translate(filter, null), out NearHit near);
        hit = found ? _here.HitOf(near) : default;
        float most = found ? Math.Min(maximumDistance, Math.Max(0, hit.Distance)) : maximumDistance;
        if (AnyWaits && _coming.Queries.FindNearest(point.X, point.Y, most, _coming.Translate(filter, null), out near))
        {
            ClosestPointHit other = _coming.HitOf(near);
            if (!found || other.Distance < hit.Distance || (other.Distance == hit.Distance && IsOlder(other.Geom, hit.Geom)))
            {
                hit = other;
                found = true;
            }
        }

        return found;
    }

    /// <summary>Geoms wait; their world then is up to date.</summary>
    private bool AnyWaits => _waiting.Refresh(_simulator);

    private static bool IsOlder(Geom? geom, Geom? than) => geom is not null && than is not null && geom.Id < than.Id;

    private static RayInput Way(Vector2 start, Vector2 end) => new RayInput
    {
        X = start.X,
        Y = start.Y,
        DirectionX = (double)end.X - start.X,
        DirectionY = (double)end.Y - start.Y,
    };

    /// <summary>Takes a hit if it comes before another, if there is one; of two at once the geom that was made first.</summary>
    private static bool Better(bool found, in RayCastHit other, ref RayCastHit hit)
    {
        bool before = !found || other.Fraction < hit.Fraction
            || (other.Fraction == hit.Fraction
                && (other.StartsInside == hit.StartsInside ? IsOlder(other.Geom, hit.Geom) : other.StartsInside));
        hit = before ? other : hit;
        return true;
    }

    private static void Gather(Target target, in RayInput way, QueryFilter? filter, List<RayCastHit> hits)
    {
        int count = target.Queries.CastRayAll(way, target.Translate(filter, null));
        for (int i = 0; i < count; i++)
        {
            RayCastHit hit = target.HitOf(target.Queries.Hit(i));
            int place = hits.Count;
            while (place > 0 && target.Waits && (hits[place - 1].Fraction > hit.Fraction
                || (hits[place - 1].Fraction == hit.Fraction && IsOlder(hit.Geom, hits[place - 1].Geom))))
            {
                place--;
            }

            hits.Insert(place, hit);
        }
    }

    /// <summary>Which world a geom is in, and its first piece there.</summary>
    private Target TargetOf(Geom geom, out int piece)
    {
        piece = AnyWaits ? _waiting.FirstPiece(geom) : -1;
        if (piece >= 0)
        {
            return _coming;
        }

        piece = _here.World.Shapes.Colliders[geom.Link.Handle.Index].FirstPiece;
        return _here;
    }

    private void SetPiece(Target own, int piece)
    {
        own.Queries.SetPiece(piece);
        if (own.Waits)
        {
            _here.Queries.SetShape(own.Queries);
        }
    }

    /// <summary>Adds what the shape of the queries overlaps.</summary>
    private void FindOverlapping(QueryFilter? filter, Geom? self, List<Geom> geoms)
    {
        _here.Queries.FindOverlapping(_here.Translate(filter, self), _found);
        Deliver(_here, geoms);
        if (AnyWaits)
        {
            _coming.Queries.SetShape(_here.Queries);
            _coming.Queries.FindOverlapping(_coming.Translate(filter, self), _found);
            Deliver(_coming, geoms);
        }
    }

    private bool CastShape(double x, double y, QueryFilter? filter, Geom? self, bool found, ref RayCastHit hit)
    {
        if (_here.Queries.CastShape(x, y, _here.Translate(filter, self), out RayHit next))
        {
            found = Better(found, _here.HitOf(next), ref hit);
        }

        if (AnyWaits)
        {
            _coming.Queries.SetShape(_here.Queries);
            if (_coming.Queries.CastShape(x, y, _coming.Translate(filter, self), out next))
            {
                found = Better(found, _coming.HitOf(next), ref hit);
            }
        }

        return found;
    }

    /// <summary>Adds the geoms found, each once, in the order in which they were made.</summary>
    private void Deliver(Target target, List<Geom> geoms)
    {
        for (int i = 0; i < _found.Count; i++)
        {
            Geom geom = target.Find(_found[i])!;
            int place = geoms.Count;
            while (place > 0 && geoms[place - 1].Id > geom.Id)
            {
                place--;
            }

            if (place == 0 || !ReferenceEquals(geoms[place - 1], geom))
            {
                geoms.Insert(place, geom);
            }
        }
    }

    /// <summary>A world that is asked, and what its colliders stand for.</summary>
    private sealed class Target : IQueryPredicate
    {
        private readonly Func<World> _world;
        private readonly WorldQueries? _queries;
        private readonly Func<int, Geom?> _find;
        private Predicate<Geom>? _accept;
        private Body? _ignored;
        private Body? _self;

        public Target(Func<World> world, WorldQueries? queries, Func<int, Geom?> find, bool waits)
        {
            _world = world;
            _queries = queries;
            _find = find;
            Waits = waits;
        }

        public World World => _world();

        public WorldQueries Queries => _queries ?? _world().Queries;

        /// <summary>Its geoms wait for the next update.</summary>
        public bool Waits { get; }

        public Geom? Find(int collider) => _find(collider);

        bool IQueryPredicate.Accept(int collider)
        {
            Geom? geom = _find(collider);
            return geom is { IsDisposed: false } && IsSeen(geom) && (_accept is null || _accept(geom));
        }

        public RayCastHit HitOf(in RayHit hit) => new RayCastHit(
            _find(hit.Collider)!, new Vector2((float)hit.X, (float)hit.Y), hit.Normal, (float)hit.Fraction, hit.StartsInside);

        public ClosestPointHit HitOf(in NearHit near) =>
            new ClosestPointHit(_find(near.Collider)!, new Vector2((float)near.X, (float)near.Y), (float)near.Distance);

        /// <param name="filter">The user's.</param>
        /// <param name="self">A geom that looks: the geoms of its body are not seen.</param>
        public EngineFilter Translate(QueryFilter? filter, Geom? self)
        {
            _accept = filter?.Accept;
            _ignored = filter?.IgnoredBody;
            _self = self?.Body;
            EngineFilter translated = EngineFilter.All;
            translated.Predicate = this;
            translated.Required = filter is { IncludeSensors: true }
                ? ColliderFlags.CollisionEnabled
                : ColliderFlags.CollisionEnabled | ColliderFlags.ResponseEnabled;
            translated.Categories = filter is null ? translated.Categories : (uint)filter.Categories;
            return translated;
        }

        /// <summary>Those that wait to leave, or to come back with another outline or body, are not here any more.</summary>
        private bool IsSeen(Geom geom) =>
            !ReferenceEquals(geom.Body, _ignored) && !ReferenceEquals(geom.Body, _self)
            && (Waits || (geom.Membership != Membership.RemoveQueued && !geom.WaitsForRemake));
    }
}
