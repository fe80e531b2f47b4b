using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Numerics;
using Farseer.Engine.Queries;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using QueryFilter = FarseerGames.FarseerPhysics.Collisions.QueryFilter;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Hands queries to the engine and turns what it finds into geoms.</summary>
internal sealed class QueryLink : IQueryPredicate
{
    private readonly World _world;
    private readonly ObjectTable _table;
    private readonly IndexList _found = new IndexList();
    private Predicate<Geom>? _accept;

    public QueryLink(World world, ObjectTable table)
    {
        _world = world;
        _table = table;
    }

    bool IQueryPredicate.Accept(int collider)
    {
        Geom? geom = _table.Geom(collider);
        return geom is { IsDisposed: false } && (_accept is null || _accept(geom));
    }

    public bool CastRay(Vector2 start, Vector2 end, QueryFilter? filter, out RayCastHit hit)
    {
        bool found = _world.Queries.CastRay(Way(start, end), Translate(filter, null), out RayHit first);
        hit = found ? HitOf(first) : default;
        return found;
    }

    public int CastRayAll(Vector2 start, Vector2 end, QueryFilter? filter, List<RayCastHit> hits)
    {
        int count = _world.Queries.CastRayAll(Way(start, end), Translate(filter, null));
        hits.Clear();
        for (int i = 0; i < count; i++)
        {
            hits.Add(HitOf(_world.Queries.Hit(i)));
        }

        return count;
    }

    public int FindInBox(AABB box, QueryFilter? filter, List<Geom> geoms)
    {
        var bounds = new Box(box.Min.X, box.Min.Y, box.Max.X, box.Max.Y);
        _world.Queries.FindInBox(bounds, Translate(filter, null), _found);
        return Deliver(geoms);
    }

    public int FindAtPoint(Vector2 point, QueryFilter? filter, List<Geom> geoms)
    {
        _world.Queries.FindAtPoint(point.X, point.Y, Translate(filter, null), _found);
        return Deliver(geoms);
    }

    public int FindInCircle(Vector2 center, float radius, QueryFilter? filter, List<Geom> geoms)
    {
        _world.Queries.SetDisc(center.X, center.Y, radius);
        _world.Queries.FindOverlapping(Translate(filter, null), _found);
        return Deliver(geoms);
    }

    public int FindTouching(Geom geom, QueryFilter? filter, List<Geom> geoms)
    {
        geoms.Clear();
        global::Farseer.Engine.Queries.QueryFilter translated = Translate(filter, geom);
        ShapeStore shapes = _world.Shapes;
        for (int piece = FirstPiece(geom); piece >= 0; piece = shapes.NextPiece[piece])
        {
            _world.Queries.SetPiece(piece);
            _world.Queries.FindOverlapping(translated, _found);
            for (int i = 0; i < _found.Count; i++)
            {
                Geom other = _table.Geom(_found[i])!;
                int place = geoms.Count;
                while (place > 0 && geoms[place - 1].Id > other.Id)
                {
                    place--;
                }

                if (place == 0 || !ReferenceEquals(geoms[place - 1], other))
                {
                    geoms.Insert(place, other);
                }
            }
        }

        return geoms.Count;
    }

    public bool CastCircle(Vector2 center, float radius, Vector2 translation, QueryFilter? filter, out RayCastHit hit)
    {
        _world.Queries.SetDisc(center.X, center.Y, radius);
        bool found = _world.Queries.CastShape(translation.X, translation.Y, Translate(filter, null), out RayHit first);
        hit = found ? HitOf(first) : default;
        return found;
    }

    public bool CastGeom(Geom geom, Vector2 translation, QueryFilter? filter, out RayCastHit hit)
    {
        global::Farseer.Engine.Queries.QueryFilter translated = Translate(filter, geom);
        bool found = false;
        RayHit best = default;
        ShapeStore shapes = _world.Shapes;
        for (int piece = FirstPiece(geom); piece >= 0; piece = shapes.NextPiece[piece])
        {
            _world.Queries.SetPiece(piece);
            if (_world.Queries.CastShape(translation.X, translation.Y, translated, out RayHit next) && (!found || next.Fraction < best.Fraction))
            {
                best = next;
                found = true;
            }
        }

        hit = found ? HitOf(best) : default;
        return found;
    }

    public bool FindNearest(Vector2 point, float maximumDistance, QueryFilter? filter, out ClosestPointHit hit)
    {
        bool found = _world.Queries.FindNearest(point.X, point.Y, maximumDistance, Translate(filter, null), out NearHit near);
        hit = found
            ? new ClosestPointHit(_table.Geom(near.Collider)!, new Vector2((float)near.X, (float)near.Y), (float)near.Distance)
            : default;
        return found;
    }

    private static RayInput Way(Vector2 start, Vector2 end) => new RayInput
    {
        X = start.X,
        Y = start.Y,
        DirectionX = (double)end.X - start.X,
        DirectionY = (double)end.Y - start.Y,
    };

    private int FirstPiece(Geom geom) => _world.Shapes.Colliders[geom.Link.Handle.Index].FirstPiece;

    private RayCastHit HitOf(in RayHit hit) => new RayCastHit(
        _table.Geom(hit.Collider)!, new Vector2((float)hit.X, (float)hit.Y), hit.Normal, (float)hit.Fraction, hit.StartsInside);

    private int Deliver(List<Geom> geoms)
    {
        geoms.Clear();
        for (int i = 0; i < _found.Count; i++)
        {
            geoms.Add(_table.Geom(_found[i])!);
        }

        return geoms.Count;
    }

    /// <param name="filter">The user's.</param>
    /// <param name="self">A geom that looks: the geoms of its body are not seen.</param>
    private global::Farseer.Engine.Queries.QueryFilter Translate(QueryFilter? filter, Geom? self)
    {
        _accept = filter?.Accept;
        global::Farseer.Engine.Queries.QueryFilter translated = global::Farseer.Engine.Queries.QueryFilter.All;
        translated.Predicate = this;
        translated.Required = filter is { IncludeSensors: true }
            ? ColliderFlags.CollisionEnabled
            : ColliderFlags.CollisionEnabled | ColliderFlags.ResponseEnabled;
        if (filter is not null)
        {
            translated.Categories = (uint)filter.Categories;
            translated.IgnoredBody = filter.IgnoredBody is { } ignored && ReferenceEquals(ignored.Link.World, _world) ? ignored.Link.Handle.Index : 0;
        }

        translated.OtherIgnoredBody = self is null ? 0 : self.Link.AttachedBody!.Link.Handle.Index;
        return translated;
    }
}
