using System;
using System.ComponentModel;
using Box2D.Dynamics;

namespace Box2D.Collision.Shapes;

/// <content>Fields of the original that were public, for sources which use them; each says what to call instead.</content>
public abstract partial class b2Shape
{
    /// <summary>A field of the original. Use <see cref="GetUserData"/> and <see cref="SetUserData"/> instead.</summary>
    [Obsolete("Use GetUserData() and SetUserData.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public object? m_userData
    {
        get => _userData;
        set => SetUserData(value);
    }

    /// <summary>A field of the original. Use <see cref="GetNext"/> instead.</summary>
    [Obsolete("Use GetNext().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Shape? m_next => GetNext();

    /// <summary>A field of the original. Use <see cref="GetBody"/> instead.</summary>
    [Obsolete("Use GetBody().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Body? m_body => GetBody();

    /// <summary>A field of the original. Use <see cref="GetType"/> instead.</summary>
    [Obsolete("Use GetType().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public int m_type => GetType();

    /// <summary>A field of the original. Use <see cref="GetFriction"/> and <see cref="SetFriction"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    [Obsolete("Use GetFriction() and SetFriction.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_friction
    {
        get => GetFriction();
        set => SetFriction(value);
    }

    /// <summary>A field of the original. Use <see cref="GetRestitution"/> and <see cref="SetRestitution"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    [Obsolete("Use GetRestitution() and SetRestitution.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_restitution
    {
        get => GetRestitution();
        set => SetRestitution(value);
    }

    /// <summary>A field of the original. Use <see cref="GetDensity"/> and <see cref="SetDensity"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    [Obsolete("Use GetDensity() and SetDensity.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_density
    {
        get => GetDensity();
        set => SetDensity(value);
    }

    /// <summary>A field of the original. Use <see cref="IsSensor"/> and <see cref="SetSensor"/> instead.</summary>
    [Obsolete("Use IsSensor() and SetSensor.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public bool m_isSensor
    {
        get => IsSensor();
        set => SetSensor(value);
    }

    /// <summary>
    /// A field of the original. Use <see cref="GetFilterData"/> and <see cref="SetFilterData"/> instead. It returns a copy.
    /// </summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    [Obsolete("Use GetFilterData() and SetFilterData.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2FilterData m_filter
    {
        get => GetFilterData();
        set => SetFilterData(value);
    }

    /// <summary>A field of the original. Use <see cref="GetSweepRadius"/> instead.</summary>
    [Obsolete("Use GetSweepRadius().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_sweepRadius => GetSweepRadius();

    /// <summary>Whether there is a shape: ActionScript's <c>if (shape)</c>, and <c>for (…; shape; …)</c>.</summary>
    /// <param name="shape">The shape, or null.</param>
    /// <returns>True if it is not null.</returns>
    public static bool operator true(b2Shape? shape) => shape is not null;

    /// <summary>Whether there is no shape.</summary>
    /// <param name="shape">The shape, or null.</param>
    /// <returns>True if it is null.</returns>
    public static bool operator false(b2Shape? shape) => shape is null;

    /// <summary>Whether there is no shape.</summary>
    /// <param name="shape">The shape, or null.</param>
    /// <returns>True if it is null.</returns>
    public static bool operator !(b2Shape? shape) => shape is null;
}
