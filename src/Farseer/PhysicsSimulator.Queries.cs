using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics;

/// <content>
/// Rays, boxes, points and shapes against the geoms where they are now: also those that wait for the next update, and not those that wait
/// to leave. They may be asked at any time, also from handlers, and change nothing. What is found comes in the order in which the geoms
/// were made, if not said otherwise. Without a list that must grow, nothing is allocated. (Additions to the original.)
/// </content>
public partial class PhysicsSimulator
{
    [NotState(Why.Fixed)]
    private readonly QueryCrowd _queries;

    /// <summary>The first geom that a ray meets. A geom that the ray starts in or on is met at once.</summary>
    /// <param name="start">Start of the ray, world coordinates; finite, within ±9.2E18.</param>
    /// <param name="end">End of the ray, as <paramref name="start"/>.</param>
    /// <param name="hit">The hit; the default value if there is none.</param>
    /// <param name="filter">Selects the geoms that are seen; null: all that push others away.</param>
    /// <returns>True if a geom is met.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A point is not finite or too far away.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from the filter of another query.</exception>
    public bool RayCast(Vector2 start, Vector2 end, out RayCastHit hit, QueryFilter? filter = null)
    {
        ThrowIfDisposed();
        Require.Place(start, nameof(start));
        Require.Place(end, nameof(end));
        using QueryTurn turn = _queries.Enter();
        return turn.Link.CastRay(start, end, filter, out hit);
    }

    /// <summary>The first geom on each of many rays, as <see cref="RayCast"/> finds it.</summary>
    /// <param name="starts">Starts of the rays, world coordinates; finite, within ±9.2E18.</param>
    /// <param name="ends">Their ends, as many.</param>
    /// <param name="hits">The hits, as many as rays; <see cref="RayCastHit.Geom"/> is null for those that meet none.</param>
    /// <param name="filter">Selects the geoms that are seen; null: all that push others away.</param>
    /// <returns>The number of rays that meet a geom.</returns>
    /// <exception cref="ArgumentException">The spans differ in length.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A point is not finite or too far away: no ray is cast then.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from the filter of another query.</exception>
    public int RayCastEach(ReadOnlySpan<Vector2> starts, ReadOnlySpan<Vector2> ends, Span<RayCastHit> hits, QueryFilter? filter = null)
    {
        ThrowIfDisposed();
        RequireAsMany(starts.Length, ends.Length, nameof(ends));
        RequireAsMany(starts.Length, hits.Length, nameof(hits));
        for (int i = 0; i < starts.Length; i++)
        {
            Require.Place(starts[i], nameof(starts));
            Require.Place(ends[i], nameof(ends));
        }

        int found = 0;
        using QueryTurn turn = _queries.Enter();
        for (int i = 0; i < starts.Length; i++)
        {
            found += turn.Link.CastRay(starts[i], ends[i], filter, out hits[i]) ? 1 : 0;
        }

        return found;
    }

    /// <summary>All geoms that a ray meets, each where the ray first enters it, the nearest first.</summary>
    /// <param name="start">Start of the ray, world coordinates; finite, within ±9.2E18.</param>
    /// <param name="end">End of the ray, as <paramref name="start"/>.</param>
    /// <param name="hits">The list to fill; it is emptied first.</param>
    /// <param name="filter">Selects the geoms that are seen; null: all that push others away.</param>
    /// <returns>Number of geoms.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A point is not finite or too far away.</exception>
    /// <exception cref="ArgumentNullException"><paramref name="hits"/> is null.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from the filter of another query.</exception>
    public int RayCastAll(Vector2 start, Vector2 end, List<RayCastHit> hits, QueryFilter? filter = null)
    {
        ThrowIfDisposed();
        Require.Place(start, nameof(start));
        Require.Place(end, nameof(end));
        using QueryTurn turn = _queries.Enter();
        return turn.Link.CastRayAll(start, end, filter, Require.NotNull(hits, nameof(hits)));
    }

    /// <summary>The geoms whose bounding boxes share a point with a box.</summary>
    /// <param name="aabb">The box, world coordinates.</param>
    /// <param name="geoms">The list to fill; it is emptied first.</param>
    /// <param name="filter">Selects the geoms that are seen; null: all that push others away.</param>
    /// <returns>Number of geoms.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="aabb"/> or <paramref name="geoms"/> is null.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from the filter of another query.</exception>
    public int Query(AABB aabb, List<Geom> geoms, QueryFilter? filter = null)
    {
        ThrowIfDisposed();
        using QueryTurn turn = _queries.Enter();
        return turn.Link.FindInBox(Require.NotNull(aabb, nameof(aabb)), filter, Require.NotNull(geoms, nameof(geoms)));
    }

    /// <summary>
    /// The geoms that a point is in or on. Lines contain nothing. Circles are true circles, unlike for <see cref="CollideAll(Vector2)"/>.
    /// </summary>
    /// <param name="point">The point, world coordinates; finite, within ±9.2E18.</param>
    /// <param name="geoms">The list to fill; it is emptied first.</param>
    /// <param name="filter">Selects the geoms that are seen; null: all that push others away.</param>
    /// <returns>Number of geoms.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="point"/> is not finite or too far away.</exception>
    /// <exception cref="ArgumentNullException"><paramref name="geoms"/> is null.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from the filter of another query.</exception>
    public int QueryPoint(Vector2 point, List<Geom> geoms, QueryFilter? filter = null)
    {
        ThrowIfDisposed();
        Require.Place(point, nameof(point));
        using QueryTurn turn = _queries.Enter();
        return turn.Link.FindAtPoint(point, filter, Require.NotNull(geoms, nameof(geoms)));
    }

    /// <summary>The geoms that a disc overlaps or touches.</summary>
    /// <param name="center">Centre of the disc, world coordinates; finite, within ±9.2E18.</param>
    /// <param name="radius">Its radius, a length of the scene above 0, from 1.1E-19 to 9.2E18.</param>
    /// <param name="geoms">The list to fill; it is emptied first.</param>
    /// <param name="filter">Selects the geoms that are seen; null: all that push others away.</param>
    /// <returns>Number of geoms.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="center"/> or <paramref name="radius"/> is out of range.</exception>
    /// <exception cref="ArgumentNullException"><paramref name="geoms"/> is null.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from the filter of another query.</exception>
    public int QueryCircle(Vector2 center, float radius, List<Geom> geoms, QueryFilter? filter = null)
    {
        ThrowIfDisposed();
        Require.Place(center, nameof(center));
        Require.Length(radius, nameof(radius));
        using QueryTurn turn = _queries.Enter();
        return turn.Link.FindInCircle(center, radius, filter, Require.NotNull(geoms, nameof(geoms)));
    }

    /// <summary>The geoms that a given geom overlaps or touches. Geoms of its own body are left out.</summary>
    /// <param name="geometry">A geom that is in the simulator.</param>
    /// <param name="geoms">The list to fill; it is emptied first.</param>
    /// <param name="filter">Selects the geoms that are seen; null: all that push others away.</param>
    /// <returns>Number of geoms.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="geometry"/> or <paramref name="geoms"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="geometry"/> was not added to the simulator, or was removed.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from the filter of another query.</exception>
    public int QueryGeom(Geom geometry, List<Geom> geoms, QueryFilter? filter = null)
    {
        ThrowIfDisposed();
        Require.NotNull(geoms, nameof(geoms));
        RequireInside(geometry);
        using QueryTurn turn = _queries.Enter();
        return turn.Link.FindTouching(geometry, filter, geoms);
    }

    /// <summary>The first geom that a disc meets on its way. One that it overlaps or touches at the start is met at once.</summary>
    /// <param name="center">Centre of the disc at the start, world coordinates; finite, within ±9.2E18.</param>
    /// <param name="radius">Its radius, a length of the scene above 0, from 1.1E-19 to 9.2E18.</param>
    /// <param name="translation">The way; finite, within ±9.2E18.</param>
    /// <param name="hit">The hit; the default value if there is none.</param>
    /// <param name="filter">Selects the geoms that are seen; null: all that push others away.</param>
    /// <returns>True if a geom is met.</returns>
    /// <exception cref="ArgumentOutOfRangeException">An argument is out of range.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from the filter of another query.</exception>
    public bool CircleCast(Vector2 center, float radius, Vector2 translation, out RayCastHit hit, QueryFilter? filter = null)
    {
        ThrowIfDisposed();
        Require.Place(center, nameof(center));
        Require.Length(radius, nameof(radius));
        Require.Place(translation, nameof(translation));
        using QueryTurn turn = _queries.Enter();
        return turn.Link.CastCircle(center, radius, translation, filter, out hit);
    }

    /// <summary>
    /// The first geom that a given geom would meet if it moved along a straight line without turning. One that it overlaps or touches at
    /// the start is met at once. Geoms of its own body are left out.
    /// </summary>
    /// <param name="geometry">A geom that is in the simulator; it stays where it is.</param>
    /// <param name="translation">The way; finite, within ±9.2E18.</param>
    /// <param name="hit">The hit; the default value if there is none.</param>
    /// <param name="filter">Selects the geoms that are seen; null: all that push others away.</param>
    /// <returns>True if a geom is met.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="geometry"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="geometry"/> was not added to the simulator, or was removed.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="translation"/> is not finite or too long.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from the filter of another query.</exception>
    public bool ShapeCast(Geom geometry, Vector2 translation, out RayCastHit hit, QueryFilter? filter = null)
    {
        ThrowIfDisposed();
        Require.Place(translation, nameof(translation));
        RequireInside(geometry);
        using QueryTurn turn = _queries.Enter();
        return turn.Link.CastGeom(geometry, translation, filter, out hit);
    }

    /// <summary>The geom whose border is nearest to a point, or that the point is deepest in.</summary>
    /// <param name="point">The point, world coordinates; finite, within ±9.2E18.</param>
    /// <param name="maximumDistance">The distance to search, a length of the scene; finite and at least 0.</param>
    /// <param name="hit">The geom and its nearest point; the default value if there is none.</param>
    /// <param name="filter">Selects the geoms that are seen; null: all that push others away.</param>
    /// <returns>True if there is one.</returns>
    /// <exception cref="ArgumentOutOfRangeException">An argument is out of range.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from the filter of another query.</exception>
    public bool ClosestPoint(Vector2 point, float maximumDistance, out ClosestPointHit hit, QueryFilter? filter = null)
    {
        ThrowIfDisposed();
        Require.Place(point, nameof(point));
        Require.NotNegative(maximumDistance, nameof(maximumDistance));
        using QueryTurn turn = _queries.Enter();
        return turn.Link.FindNearest(point, maximumDistance, filter, out hit);
    }

    private static void RequireAsMany(int wanted, int given, string name)
    {
        if (given != wanted)
        {
            throw new ArgumentException($"{given} are given for {wanted} ways.", name);
        }
    }

    private void RequireInside(Geom geometry)
    {
        Require.NotNull(geometry, nameof(geometry)).ThrowIfDisposed();
        if (!ReferenceEquals(geometry.Simulator, this) || geometry.Membership == Membership.RemoveQueued)
        {
            throw new ArgumentException("The geom is not in this simulator.", nameof(geometry));
        }
    }
}
