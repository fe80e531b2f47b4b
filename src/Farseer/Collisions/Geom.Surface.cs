using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>
/// Surfaces: belts, resistance to rolling, one-way platforms, materials by segment, who touches. (Additions to the original.)
/// </content>
public partial class Geom
{
    /// <summary>
    /// Speed of the surface relative to its body, as of a conveyor belt, length/s. It runs along (n.Y, -n.X), with the outward normal n,
    /// all around the outline: on top of a belt towards +x where y points up, and towards -x where y points down. It acts by friction on
    /// what lies on it, and back on the body of the belt, once a substep, after the contacts. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float SurfaceSpeed
    {
        get => _extras is null ? 0 : _extras.Surface.Speed;
        set
        {
            Require.Finite(value, nameof(SurfaceSpeed));
            if (value != SurfaceSpeed)
            {
                (_extras ??= new GeomExtras()).Surface.Speed = value;
                SurfaceChanged();
            }
        }
    }

    /// <summary>
    /// Resistance against rolling, of this geom and on it; at least 0. It is a share of the load, at the arm of half the width of the
    /// smaller body: a ball of resistance c slows down by c·g and stays on slopes up to the tangent c. Of two geoms the larger value
    /// counts. In the plane it also resists spinning on the spot. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float RollingResistance
    {
        get => _extras is null ? 0 : _extras.Surface.RollingResistance;
        set
        {
            Require.NotNegative(value, nameof(RollingResistance));
            if (value != RollingResistance)
            {
                (_extras ??= new GeomExtras()).Surface.RollingResistance = value;
                SurfaceChanged();
            }
        }
    }

    /// <summary>
    /// The side from which a one-way platform is solid, in body coordinates, of any length: (0, 1) for its top where y points up. What
    /// comes from there is stopped. What comes from elsewhere passes, until it has left. (0, 0), the default, makes the geom solid on all
    /// sides.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 OneWayDirection
    {
        get => _extras is null ? Vector2.Zero : _extras.OneWay;
        set
        {
            Require.Finite(value, nameof(OneWayDirection));
            if (value != OneWayDirection)
            {
                (_extras ??= new GeomExtras()).OneWay = value;
                Link.PushFlags(this);
            }
        }
    }

    /// <summary>The number of segments of a chain, each of which may have a material of its own; 1 for any other geom.</summary>
    public int SegmentCount => _form is { Kind: FormKind.Chain } chain ? chain.Points.Length - (chain.IsLoop ? 0 : 1) : 1;

    /// <summary>It has materials by segment.</summary>
    internal bool HasSegments => _extras?.Segments is not null;

    /// <summary>Pairs of the geom are asked about.</summary>
    internal bool HasSurface =>
        _extras is not null && (_extras.Segments is not null || _extras.Surface.Speed != 0 || _extras.Surface.RollingResistance > 0);

    /// <summary>
    /// Gives a segment of a chain a material of its own, in place of the geom's. Segment i leads from point i to the next.
    /// </summary>
    /// <param name="segment">From 0 to below <see cref="SegmentCount"/>.</param>
    /// <param name="material">Its material.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such segment.</exception>
    /// <exception cref="ObjectDisposedException">The geom is disposed.</exception>
    public void SetSegmentMaterial(int segment, SurfaceMaterial material)
    {
        ThrowIfDisposed();
        Require.Within(segment, 0, SegmentCount - 1, nameof(segment));
        GeomExtras extras = _extras ??= new GeomExtras();
        if (extras.Segments is null || extras.Segments.Length != SegmentCount)
        {
            extras.Segments = new SurfaceMaterial?[SegmentCount];
        }

        extras.Segments[segment] = material;
        SurfaceChanged();
    }

    /// <summary>The material of a segment of a chain: its own, or that of the geom.</summary>
    /// <param name="segment">From 0 to below <see cref="SegmentCount"/>.</param>
    /// <returns>The material.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such segment.</exception>
    public SurfaceMaterial GetSegmentMaterial(int segment) => MaterialOf(Require.Within(segment, 0, SegmentCount - 1, nameof(segment)));

    /// <summary>
    /// Lists the geoms that touched this one in the last update, in the order of their creation; for a sensor, those that are in it. What
    /// was removed since is left out. It looks at all contacts of the simulator. Nothing is allocated once the list has its size.
    /// </summary>
    /// <param name="geoms">The list to fill; it is emptied first.</param>
    /// <returns>Number of geoms; 0 for a geom that is in no simulator.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="geoms"/> is null.</exception>
    public int GetTouching(System.Collections.Generic.List<Geom> geoms)
    {
        Require.NotNull(geoms, nameof(geoms)).Clear();
        if (Simulator is null)
        {
            return 0;
        }

        System.Collections.Generic.List<Dynamics.Arbiter> arbiters = Simulator.ArbiterList;
        for (int i = 0; i < arbiters.Count; i++)
        {
            Geom? other = ReferenceEquals(arbiters[i].GeomA, this)
                ? arbiters[i].GeomB
                : ReferenceEquals(arbiters[i].GeomB, this) ? arbiters[i].GeomA : null;
            if (other is { IsDisposed: false } && other.Membership != Membership.RemoveQueued)
            {
                geoms.Add(other);
            }
        }

        geoms.Sort(static (a, b) => a.Id.CompareTo(b.Id));
        return geoms.Count;
    }

    /// <summary>Name, shape, position and state, for a debugger.</summary>
    /// <returns>A line of text.</returns>
    public override string ToString() => string.Format(
        System.Globalization.CultureInfo.InvariantCulture,
        "Geom {0}{1} at ({2:G5}, {3:G5}){4}",
        Name ?? Tag ?? _id,
        _form is null ? "" : " " + _form.Kind.ToString().ToLowerInvariant(),
        Position.X,
        Position.Y,
        IsDisposed ? ", disposed" : Simulator is null ? ", in no simulator" : IsSensor ? ", sensor" : "");

    /// <summary>The material of a piece, by its place.</summary>
    internal SurfaceMaterial MaterialOf(int segment)
    {
        if (_extras?.Segments is { } segments && segment < segments.Length && segments[segment] is { } own)
        {
            return own;
        }

        return new SurfaceMaterial
        {
            Friction = Link.Friction,
            Restitution = Link.Restitution,
            Speed = SurfaceSpeed,
            RollingResistance = RollingResistance,
        };
    }

    /// <summary>The material that a segment has of its own, if it has one.</summary>
    internal SurfaceMaterial? OwnMaterial(int segment) =>
        _extras?.Segments is { } segments && segment < segments.Length ? segments[segment] : null;

    private void CopySurface(Geom geometry)
    {
        if (geometry._extras is { } from && (from.OneWay != Vector2.Zero || geometry.HasSurface))
        {
            GeomExtras extras = _extras ??= new GeomExtras();
            extras.OneWay = from.OneWay;
            extras.Surface = from.Surface;
            extras.Segments = (SurfaceMaterial?[]?)from.Segments?.Clone();
        }
    }

    private void SurfaceChanged()
    {
        Simulator?.UseSurfaces();
        Link.PushFlags(this);
    }
}
