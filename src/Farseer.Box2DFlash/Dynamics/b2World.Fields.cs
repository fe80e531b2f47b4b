using System;
using System.ComponentModel;
using Box2D.Common.Math;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;

namespace Box2D.Dynamics;

/// <content>Fields of the original that were public, for sources which use them; each says what to call instead.</content>
public partial class b2World
{
    /// <summary>A field of the original. Use <see cref="IsLocked()"/> instead.</summary>
    [Obsolete("Use IsLocked().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public bool m_lock => IsLocked();

    /// <summary>A field of the original. Use <see cref="GetBodyList"/> instead.</summary>
    [Obsolete("Use GetBodyList().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Body? m_bodyList => GetBodyList();

    /// <summary>A field of the original. Use <see cref="GetJointList"/> instead.</summary>
    [Obsolete("Use GetJointList().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Joint? m_jointList => GetJointList();

    /// <summary>A field of the original. Use <see cref="GetContactList"/> instead.</summary>
    [Obsolete("Use GetContactList().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Contact? m_contactList => GetContactList();

    /// <summary>A field of the original. Use <see cref="GetBodyCount"/> instead.</summary>
    [Obsolete("Use GetBodyCount().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public int m_bodyCount => GetBodyCount();

    /// <summary>A field of the original. Use <see cref="GetJointCount"/> instead.</summary>
    [Obsolete("Use GetJointCount().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public int m_jointCount => GetJointCount();

    /// <summary>A field of the original. Use <see cref="GetContactCount"/> instead.</summary>
    [Obsolete("Use GetContactCount().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public int m_contactCount => GetContactCount();

    /// <summary>A field of the original. Use <see cref="GetGroundBody"/> instead.</summary>
    [Obsolete("Use GetGroundBody().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Body m_groundBody => GetGroundBody();

    /// <summary>A field of the original: what the world was made with.</summary>
    [Obsolete("Keep what the world was made with.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public bool m_allowSleep => DoSleep;

    /// <summary>A field of the original. Use <see cref="GetGravity"/> and <see cref="SetGravity"/> instead.</summary>
    /// <exception cref="ArgumentException">The value is null or not finite.</exception>
    [Obsolete("Use GetGravity() and SetGravity.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 m_gravity
    {
        get => GetGravity();
        set => SetGravity(value);
    }

    /// <summary>A field of the original. Use <see cref="SetContactListener"/> instead.</summary>
    [Obsolete("Use SetContactListener.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2ContactListener? m_contactListener
    {
        get => ContactListener;
        set => SetContactListener(value);
    }

    /// <summary>A field of the original. Use <see cref="SetContactFilter"/> instead.</summary>
    [Obsolete("Use SetContactFilter.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2ContactFilter? m_contactFilter
    {
        get => ContactFilter;
        set => SetContactFilter(value);
    }

    /// <summary>A name of the manual: <see cref="SetBoundaryListener"/>.</summary>
    /// <param name="listener">The listener, or null for none.</param>
    [Obsolete("Use SetBoundaryListener.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public void SetListener(b2BoundaryListener? listener) => SetBoundaryListener(listener);

    /// <summary>A name of the manual: <see cref="SetDestructionListener"/>.</summary>
    /// <param name="listener">The listener, or null for none.</param>
    [Obsolete("Use SetDestructionListener.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public void SetListener(b2DestructionListener? listener) => SetDestructionListener(listener);

    /// <summary>A field of the original. Use <see cref="SetDestructionListener"/> instead.</summary>
    [Obsolete("Use SetDestructionListener.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2DestructionListener? m_destructionListener
    {
        get => DestructionListener;
        set => SetDestructionListener(value);
    }

    /// <summary>A field of the original. Use <see cref="SetBoundaryListener"/> instead.</summary>
    [Obsolete("Use SetBoundaryListener.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2BoundaryListener? m_boundaryListener
    {
        get => BoundaryListener;
        set => SetBoundaryListener(value);
    }

    /// <summary>A field of the original. Use <see cref="SetDebugDraw"/> instead.</summary>
    [Obsolete("Use SetDebugDraw.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2DebugDraw? m_debugDraw
    {
        get => _debugDraw;
        set => SetDebugDraw(value);
    }

    /// <summary>
    /// Whole seconds. It is here for the compiler to warn: in C# <c>1 / 30</c> is the whole number 0, and a step of 0 does nothing.
    /// </summary>
    /// <param name="dt">Time, seconds; 0 or more.</param>
    /// <param name="iterations">Accuracy, above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
    /// <exception cref="InvalidOperationException">The call comes from a listener.</exception>
    [Obsolete("The time is a whole number of seconds: 1/30 is 0 in C#. Write 1f/30, or 1f for a second.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public void Step(int dt, int iterations) => Step((float)dt, iterations);
}
