using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Queries;

/// <summary>Rays: the way of a point.</summary>
internal sealed unsafe partial class WorldQueries
{
    /// <summary>The first collider on a way. One that the way starts in or on is met at once.</summary>
    public bool CastRay(in RayInput ray, in QueryFilter filter, out RayHit hit)
    {
        hit = default;
        hit.Fraction = double.PositiveInfinity;
        Begin(filter);
        try
        {
            _rays.Begin(_index.Tree, _index.Loose, new RayProbe(ray.X, ray.Y, ray.DirectionX, ray.DirectionY, 0, 0));
            double limit = 1;
            while (_rays.Next(Above(limit), out int piece, out float nearest))
            {
                if (Sees(piece) && CastRay(piece, ray, nearest, limit, out RayHit found) && IsBetter(found, hit))
                {
                    hit = found;
                    limit = found.Fraction;
                }
            }
        }
        finally
        {
            _isAsking = false;
        }

        return hit.Fraction <= 1;
    }

    /// <summary>All colliders on a way, each where the way first enters it, the nearest first.</summary>
    /// <returns>How many; read them by <see cref="Hit"/> until the next query.</returns>
    public int CastRayAll(in RayInput ray, in QueryFilter filter)
    {
        int count = 0;
        Begin(filter);
        try
        {
            _rays.Begin(_index.Tree, _index.Loose, new RayProbe(ray.X, ray.Y, ray.DirectionX, ray.DirectionY, 0, 0));
            while (_rays.Next(1, out int piece, out float nearest))
            {
                if (Sees(piece) && CastRay(piece, ray, nearest, 1, out RayHit found))
                {
                    _hits.EnsureCapacity(count + 1);
                    _hits[count++] = found;
                }
            }

            return SortHits(count);
        }
        finally
        {
            _isAsking = false;
        }
    }

    /// <summary>A ray against one collider, whether or not queries see it.</summary>
    public bool CastRay(int collider, in RayInput ray, out RayHit hit)
    {
        hit = default;
        hit.Fraction = double.PositiveInfinity;
        for (int piece = _shapes.Colliders[collider].FirstPiece; piece >= 0; piece = _shapes.NextPiece[piece])
        {
            if (CastRay(piece, ray, 0, 1, out RayHit found) && (found.Fraction < hit.Fraction || found.StartsInside))
            {
                hit = found;
            }
        }

        return hit.Fraction <= 1;
    }

    public ref RayHit Hit(int index) => ref _hits[_values[index]];

    /// <summary>The nearer of two; of equals the one that has the start inside, then the older.</summary>
    private bool IsBetter(in RayHit a, in RayHit b)
    {
        if (a.Fraction != b.Fraction)
        {
            return a.Fraction < b.Fraction;
        }

        return a.StartsInside != b.StartsInside ? a.StartsInside : IsOlder(a.Collider, b.Collider);
    }

    /// <param name="piece">The piece.</param>
    /// <param name="ray">The way.</param>
    /// <param name="nearest">Above 0 if the piece's box is known not to hold the start.</param>
    /// <param name="limit">Share of the way beyond which an entry does not count.</param>
    /// <param name="hit">The entry.</param>
    private bool CastRay(int piece, in RayInput ray, float nearest, double limit, out RayHit hit)
    {
        ref BodyPose pose = ref PoseOf(piece);
        RayPath path = LocalPath(piece, ray);
        hit = default;
        hit.Collider = _shapes.Pieces[piece].Collider;
        if (nearest == 0 && path.StartsIn(_shapes, piece))
        {
            hit.StartsInside = true;
            hit.X = ray.X;
            hit.Y = ray.Y;
            return true;
        }

        // The next double: an entry at the limit itself may still be that of an older collider.
        path.Fraction = limit * (1 + 3e-16);
        if (!path.Enter(_shapes, piece) || path.Fraction > limit)
        {
            return false;
        }

        hit.Fraction = path.Fraction;
        hit.X = ray.X + (ray.DirectionX * path.Fraction);
        hit.Y = ray.Y + (ray.DirectionY * path.Fraction);
        hit.Normal = WorldNormal(pose, path.NormalX, path.NormalY);
        return true;
    }

    /// <summary>Keeps the best hit of each collider, and sorts these by their share of the way; equal ones by age.</summary>
    private int SortHits(int count)
    {
        _found.Clear();
        for (int i = 0; i < count; i++)
        {
            _found.Add(_hits[i].Collider);
        }

        // First by collider; then what is left by share, which keeps that order among equals.
        _keys.EnsureCapacity(Math.Max(1, count));
        _values.EnsureCapacity(Math.Max(1, count));
        for (int i = 0; i < count; i++)
        {
            _keys[i] = (uint)_shapes.Order[_hits[i].Collider];
            _values[i] = i;
        }

        _sort.Sort(_keys.Pointer, _values.Pointer, count);
        int kept = 0;
        for (int i = 0; i < count; i++)
        {
            int next = _values[i];
            if (kept > 0 && _hits[_values[kept - 1]].Collider == _hits[next].Collider)
            {
                if (IsBetter(_hits[next], _hits[_values[kept - 1]]))
                {
                    _values[kept - 1] = next;
                }
            }
            else
            {
                _values[kept++] = next;
            }
        }

        for (int i = 0; i < kept; i++)
        {
            // Shares are 0 or more: their bits have their order. Whoever starts inside comes before who is met at 0.
            double fraction = _hits[_values[i]].Fraction;
            ulong bits = *(ulong*)&fraction;
            _keys[i] = (bits << 1) | (_hits[_values[i]].StartsInside ? 0UL : 1UL);
        }

        _sort.Sort(_keys.Pointer, _values.Pointer, kept);
        return kept;
    }
}
