using System;
using System.ComponentModel;

namespace Box2D.Dynamics.Joints;

/// <content>Fields of the original that were public, for sources which use them; each says what to call instead.</content>
public abstract partial class b2Joint
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
    public b2Joint? m_next => GetNext();

    /// <summary>A field of the original. Use <see cref="GetType"/> instead.</summary>
    [Obsolete("Use GetType().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public int m_type => GetType();

    /// <summary>A field of the original. Use <see cref="GetBody1"/> instead.</summary>
    [Obsolete("Use GetBody1().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Body m_body1 => GetBody1();

    /// <summary>A field of the original. Use <see cref="GetBody2"/> instead.</summary>
    [Obsolete("Use GetBody2().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Body m_body2 => GetBody2();

    /// <summary>A field of the original: the item of <see cref="b2Body.GetJointList"/> at the first body.</summary>
    [Obsolete("Use GetJointList() of the body.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2JointEdge m_node1 => Edge1;

    /// <summary>A field of the original: the item of <see cref="b2Body.GetJointList"/> at the second body.</summary>
    [Obsolete("Use GetJointList() of the body.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2JointEdge m_node2 => Edge2;

    /// <summary>A field of the original: whether the bodies may collide.</summary>
    [Obsolete("Keep what the joint was made with; b2Body.IsConnected asks for a pair.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public bool m_collideConnected => CollideConnected;

    /// <summary>Whether there is a joint: ActionScript's <c>if (joint)</c>, and <c>for (…; joint; …)</c>.</summary>
    /// <param name="joint">The joint, or null.</param>
    /// <returns>True if it is not null.</returns>
    public static bool operator true(b2Joint? joint) => joint is not null;

    /// <summary>Whether there is no joint.</summary>
    /// <param name="joint">The joint, or null.</param>
    /// <returns>True if it is null.</returns>
    public static bool operator false(b2Joint? joint) => joint is null;

    /// <summary>Whether there is no joint.</summary>
    /// <param name="joint">The joint, or null.</param>
    /// <returns>True if it is null.</returns>
    public static bool operator !(b2Joint? joint) => joint is null;
}
