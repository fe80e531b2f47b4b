using System;
using System.ComponentModel;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics.Joints;

namespace Box2D.Dynamics;

/// <content>Fields of the original that were public, for sources which use them; each says what to call instead.</content>
public partial class b2Body
{
    /// <summary>A field of the original. Use <see cref="GetUserData"/> and <see cref="SetUserData"/> instead.</summary>
    [Obsolete("Use GetUserData() and SetUserData.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public object? m_userData
    {
        get => _userData;
        set => SetUserData(value);
    }

    /// <summary>A name of the manual: <see cref="SetMassFromShapes"/>.</summary>
    [Obsolete("Use SetMassFromShapes().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public void SetMassFromShape() => SetMassFromShapes();

    /// <summary>A name of the manual: <see cref="GetWorldCenter"/>.</summary>
    /// <returns>The centre of mass in the world, metres.</returns>
    [Obsolete("Use GetWorldCenter().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 GetCenterPosition() => GetWorldCenter();

    /// <summary>A field of the original. Use <see cref="GetNext"/> instead.</summary>
    [Obsolete("Use GetNext().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Body? m_next => GetNext();

    /// <summary>A field of the original. Use <see cref="GetWorld"/> instead.</summary>
    [Obsolete("Use GetWorld().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2World m_world => GetWorld();

    /// <summary>A field of the original. Use <see cref="GetShapeList"/> instead.</summary>
    [Obsolete("Use GetShapeList().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Shape? m_shapeList => GetShapeList();

    /// <summary>A field of the original: how many shapes there are in <see cref="GetShapeList"/>.</summary>
    [Obsolete("Count GetShapeList().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public int m_shapeCount
    {
        get
        {
            int count = 0;
            for (b2Shape? shape = Shapes; shape is not null; shape = shape.Next)
            {
                count++;
            }

            return count;
        }
    }

    /// <summary>A field of the original. Use <see cref="GetJointList"/> instead.</summary>
    [Obsolete("Use GetJointList().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2JointEdge? m_jointList => GetJointList();

    /// <summary>A field of the original. Use <see cref="GetXForm"/> instead.</summary>
    [Obsolete("Use GetXForm().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2XForm m_xf => GetXForm();

    /// <summary>A field of the original. Use <see cref="GetLinearVelocity"/> and <see cref="SetLinearVelocity"/> instead.</summary>
    /// <exception cref="ArgumentException">The value is null or not finite.</exception>
    [Obsolete("Use GetLinearVelocity() and SetLinearVelocity.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 m_linearVelocity
    {
        get => GetLinearVelocity();
        set => SetLinearVelocity(value);
    }

    /// <summary>A field of the original. Use <see cref="GetAngularVelocity"/> and <see cref="SetAngularVelocity"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or out of its range.</exception>
    [Obsolete("Use GetAngularVelocity() and SetAngularVelocity.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_angularVelocity
    {
        get => GetAngularVelocity();
        set => SetAngularVelocity(value);
    }

    /// <summary>A field of the original. Use <see cref="GetLinearDamping"/> and <see cref="SetLinearDamping"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    [Obsolete("Use GetLinearDamping() and SetLinearDamping.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_linearDamping
    {
        get => GetLinearDamping();
        set => SetLinearDamping(value);
    }

    /// <summary>A field of the original. Use <see cref="GetAngularDamping"/> and <see cref="SetAngularDamping"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    [Obsolete("Use GetAngularDamping() and SetAngularDamping.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_angularDamping
    {
        get => GetAngularDamping();
        set => SetAngularDamping(value);
    }

    /// <summary>A field of the original. Use <see cref="GetMass"/> instead.</summary>
    [Obsolete("Use GetMass().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_mass => GetMass();

    /// <summary>A field of the original: 1 / <see cref="GetMass"/>, 0 for a static body.</summary>
    [Obsolete("Use 1 / GetMass().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_invMass => Link.Mass > 0 ? 1 / Link.Mass : 0;

    /// <summary>A field of the original. Use <see cref="GetInertia"/> instead.</summary>
    [Obsolete("Use GetInertia().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_I => GetInertia();

    /// <summary>A field of the original: 1 / <see cref="GetInertia"/>, 0 for a body that does not turn.</summary>
    [Obsolete("Use 1 / GetInertia().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_invI => Link.Inertia > 0 ? 1 / Link.Inertia : 0;

    /// <summary>A field of the original: <see cref="e_staticType"/> or <see cref="e_dynamicType"/>.</summary>
    [Obsolete("Use IsStatic().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public uint m_type => IsStatic() ? e_staticType : e_dynamicType;

    /// <summary>A field of the original: its flags for what is frozen, sleeps, may sleep, is a bullet and does not turn.</summary>
    [Obsolete("Use IsFrozen(), IsSleeping() and IsBullet().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public uint m_flags =>
        (IsFrozen() ? e_frozenFlag : 0) | (IsSleeping() ? e_sleepFlag : 0) | (Link.MaySleep ? e_allowSleepFlag : 0)
        | (IsBullet() ? e_bulletFlag : 0) | (_fixedRotation ? e_fixedRotationFlag : 0);

    /// <summary>Whether there is a body: ActionScript's <c>if (body)</c>, and <c>for (…; body; …)</c>.</summary>
    /// <param name="body">The body, or null.</param>
    /// <returns>True if it is not null.</returns>
    public static bool operator true(b2Body? body) => body is not null;

    /// <summary>Whether there is no body.</summary>
    /// <param name="body">The body, or null.</param>
    /// <returns>True if it is null.</returns>
    public static bool operator false(b2Body? body) => body is null;

    /// <summary>Whether there is no body.</summary>
    /// <param name="body">The body, or null.</param>
    /// <returns>True if it is null.</returns>
    public static bool operator !(b2Body? body) => body is null;
}
