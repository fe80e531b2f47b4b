using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Which pairs pass through one-way surfaces: that is said when their contact begins and holds until it ends, so that nobody who is half
/// way through is thrown out.
/// </summary>
internal sealed class OneWayPairs
{
    /// <summary>Cosine of the angle at the most between the normal and the direction of the surface.</summary>
    private const float LeastAlong = 0.5f;

    /// <summary>Share of the other's size by which it may be in the surface when the contact begins.</summary>
    private const float DeepShare = 1f / 16;

    private readonly HashSet<ulong> _passing = new HashSet<ulong>();

    [NotState(Why.OfOneStep)]
    private readonly List<ulong> _sorted = new List<ulong>();

    /// <summary>Pairs that pass now, by <see cref="PairOrder"/>.</summary>
    public IReadOnlyCollection<ulong> Passing => _passing;

    /// <param name="a">The older geom.</param>
    /// <param name="b">The other geom.</param>
    /// <param name="points">With normals from the one to the other.</param>
    /// <param name="flip">The normals point the other way.</param>
    /// <param name="began">They did not touch before.</param>
    /// <returns>False if they pass through each other.</returns>
    public bool Accepts(Geom a, Geom b, ReadOnlySpan<ContactPoint> points, bool flip, bool began)
    {
        ulong key = PairOrder.Of(a, b);
        if (began)
        {
            bool passes = Passes(a, b, points, flip ? -1 : 1) || Passes(b, a, points, flip ? 1 : -1);
            if (passes)
            {
                _passing.Add(key);
            }
            else
            {
                _passing.Remove(key);
            }

            return !passes;
        }

        return !_passing.Contains(key);
    }

    /// <summary>The pair touches no more, or neither of it is one-way any more.</summary>
    /// <returns>True if it passed.</returns>
    public bool End(Geom a, Geom b) => _passing.Count > 0 && _passing.Remove(PairOrder.Of(a, b));

    public void Clear() => _passing.Clear();

    /// <summary>In one order, or two states of the same would differ.</summary>
    public void Visit(StateStream s)
    {
        _sorted.Clear();
        _sorted.AddRange(_passing);
        _sorted.Sort();
        s.List(_sorted);
        if (s.IsReading)
        {
            _passing.Clear();
            foreach (ulong pair in _sorted)
            {
                _passing.Add(pair);
            }
        }
    }

    /// <summary>Whether the other passes through a one-way geom.</summary>
    private static bool Passes(Geom way, Geom other, ReadOnlySpan<ContactPoint> points, float sign)
    {
        Vector2 local = way.OneWayDirection;
        if (local == Vector2.Zero || points.IsEmpty)
        {
            return false;
        }

        Body body = way.Body;
        Vector2 along = Vector2.Normalize((local.X * body.XVectorInWorldCoordinates) + (local.Y * body.YVectorInWorldCoordinates));
        float deepest = float.MaxValue;
        for (int i = 0; i < points.Length; i++)
        {
            deepest = Math.Min(deepest, points[i].Separation);
            if (Vector2.Dot(sign * points[i].Normal, along) < LeastAlong)
            {
                return true;
            }
        }

        var point = new Vector2((float)points[0].X, (float)points[0].Y);
        other.Body.GetVelocityAtWorldPoint(ref point, out Vector2 velocity);
        body.GetVelocityAtWorldPoint(ref point, out Vector2 own);
        float rises = Vector2.Dot(velocity - own, along);
        return (rises > 0 && deepest < 0) || deepest < -DeepShare * other.AABB.GetShortestSide();
    }
}
