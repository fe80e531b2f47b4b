using System;
using System.ComponentModel;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>Material, filters, events, identity.</content>
public partial class Geom
{
    /// <summary>
    /// Handlers called on every step in which the geom touches another, before the response. Use with +=. Of a pair the geom
    /// created first is asked first. False from a handler cancels the response of the pair in this step; then later handlers of
    /// the pair are not asked. Default null.
    /// </summary>
    public CollisionEventHandler? OnCollision
    {
        get => _extras?.OnCollision;
        set
        {
            if (ExtrasFor(value) is { } extras)
            {
                extras.OnCollision = value;
            }

            Link.PushFlags(this);
        }
    }

    /// <summary>
    /// Handlers called when the geom no longer touches another that it touched, also because one of them was removed or disposed
    /// (see <see cref="Farseer201Quirks.NoSeparationOnRemoval"/>). Use with +=. Default null.
    /// </summary>
    public SeparationEventHandler? OnSeparation
    {
        get => _extras?.OnSeparation;
        set
        {
            if (ExtrasFor(value) is { } extras)
            {
                extras.OnSeparation = value;
            }

            Link.PushFlags(this);
        }
    }

    /// <summary>Friction coefficient; at least 0. <see cref="PhysicsSimulator.FrictionType"/> selects how two combine. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float FrictionCoefficient
    {
        get => Link.Friction;
        set => Link.SetMaterial(Require.NotNegative(value, nameof(FrictionCoefficient)), Link.Restitution);
    }

    /// <summary>
    /// Part of the approach speed that a bounce gives back: 0 none, 1 all of it; at least 0. <see cref="PhysicsSimulator.RestitutionType"/>
    /// selects how the coefficients of two geoms combine, by default as their average. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float RestitutionCoefficient
    {
        get => Link.Restitution;
        set => Link.SetMaterial(Link.Friction, Require.NotNegative(value, nameof(RestitutionCoefficient)));
    }

    /// <summary>Geoms of the same group do not collide with each other; 0 is no group. Default 0.</summary>
    public int CollisionGroup
    {
        get => Link.Group;
        set => Link.SetFilter(this, value, Link.Categories, Link.CollidesWith);
    }

    /// <summary>The categories that the geom belongs to. Default <see cref="CollisionCategory.All"/>.</summary>
    public CollisionCategory CollisionCategories
    {
        get => Link.Categories;
        set => Link.SetFilter(this, Link.Group, value, Link.CollidesWith);
    }

    /// <summary>Another name of <see cref="CollisionCategories"/>, which an example of the manual uses.</summary>
    [Obsolete("Use CollisionCategories.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public CollisionCategory CollisionCategory
    {
        get => CollisionCategories;
        set => CollisionCategories = value;
    }

    /// <summary>
    /// The categories that the geom collides with. Two geoms collide if each wants a category of the other (see
    /// <see cref="Farseer201Quirks.OneSidedCategoryFilter"/>). Default <see cref="CollisionCategory.All"/>.
    /// </summary>
    public CollisionCategory CollidesWith
    {
        get => Link.CollidesWith;
        set => Link.SetFilter(this, Link.Group, Link.Categories, value);
    }

    /// <summary>False keeps everything from colliding with the geom, and no events are raised. Default true.</summary>
    public bool CollisionEnabled
    {
        get => Link.CollisionEnabled;
        set => Link.SetCollisionEnabled(this, value);
    }

    /// <summary>False lets the geom pass through all others; events are still raised. Default true.</summary>
    public bool CollisionResponseEnabled
    {
        get => Link.ResponseEnabled && !Link.IsSensor;
        set => Link.SetResponse(this, value, Link.IsSensor);
    }

    /// <summary>
    /// True makes the geom a sensor: events are raised, but it pushes nothing and nothing pushes it. See also
    /// <see cref="Farseer201Quirks.SensorMakesBodyStatic"/>. Default false.
    /// </summary>
    public bool IsSensor
    {
        get => Link.IsSensor;
        set
        {
            Link.SetResponse(this, !value || Link.ResponseEnabled, value);
            if (_body is not null && (Quirks & Farseer201Quirks.SensorMakesBodyStatic) != 0)
            {
                // What was static before has no inverse mass; what the sensor makes static keeps its own.
                bool bySensor = value && (!_body.IsStatic || _body.IsStaticBySensor);
                _body.IsStatic = value;
                _body.IsStaticBySensor = bySensor;
            }
        }
    }

    private Farseer201Quirks Quirks => (Simulator ?? _body?.Simulator)?.Quirks ?? Farseer201Quirks.None;

    /// <summary>True if both are the same geom, or both are null.</summary>
    /// <param name="geometry1">One geom.</param>
    /// <param name="geometry2">The other geom.</param>
    /// <returns>True if they are the same.</returns>
    public static bool operator ==(Geom? geometry1, Geom? geometry2) => ReferenceEquals(geometry1, geometry2);

    /// <summary>False if both are the same geom, or both are null.</summary>
    /// <param name="geometry1">One geom.</param>
    /// <param name="geometry2">The other geom.</param>
    /// <returns>True if they differ.</returns>
    public static bool operator !=(Geom? geometry1, Geom? geometry2) => !ReferenceEquals(geometry1, geometry2);

    /// <summary>True if the first geom was created before the second.</summary>
    /// <param name="geometry1">One geom.</param>
    /// <param name="geometry2">The other geom.</param>
    /// <returns>True if the first is the older one.</returns>
    /// <exception cref="ArgumentNullException">A geom is null.</exception>
    public static bool operator <(Geom geometry1, Geom geometry2) =>
        Require.NotNull(geometry1, nameof(geometry1))._id < Require.NotNull(geometry2, nameof(geometry2))._id;

    /// <summary>True if the first geom was created after the second.</summary>
    /// <param name="geometry1">One geom.</param>
    /// <param name="geometry2">The other geom.</param>
    /// <returns>True if the first is the younger one.</returns>
    /// <exception cref="ArgumentNullException">A geom is null.</exception>
    public static bool operator >(Geom geometry1, Geom geometry2) =>
        Require.NotNull(geometry1, nameof(geometry1))._id > Require.NotNull(geometry2, nameof(geometry2))._id;

    /// <summary>True if the other is the same geom.</summary>
    /// <param name="other">The geom to compare with.</param>
    /// <returns>True if they are the same.</returns>
    public bool Equals(Geom? other) => ReferenceEquals(this, other);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => ReferenceEquals(this, obj);

    /// <inheritdoc/>
    public override int GetHashCode() => _id;
}
