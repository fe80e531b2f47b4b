using Box2D.Bridge;
using Box2D.Common.Math;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics.Joints;

/// <summary>Holds two bodies together. Joints are made by <see cref="b2World.CreateJoint"/> and go with their bodies.</summary>
/// <example>
/// <code>
/// for (b2Joint j = world.GetJointList(); j != null; j = j.GetNext())
/// {
///     Console.WriteLine(j.GetReactionForce().Length());
/// }
/// </code>
/// </example>
public abstract partial class b2Joint
{
    /// <summary>No kind of joint.</summary>
    public const int e_unknownJoint = 0;

    /// <summary>A hinge.</summary>
    public const int e_revoluteJoint = 1;

    /// <summary>A slider.</summary>
    public const int e_prismaticJoint = 2;

    /// <summary>A rod or spring.</summary>
    public const int e_distanceJoint = 3;

    /// <summary>A rope over two points.</summary>
    public const int e_pulleyJoint = 4;

    /// <summary>A spring towards a point.</summary>
    public const int e_mouseJoint = 5;

    /// <summary>A gear between two joints.</summary>
    public const int e_gearJoint = 6;

    /// <summary>State of a limit in the original: it does not act.</summary>
    public const int e_inactiveLimit = 0;

    /// <summary>State of a limit in the original: at its lower end.</summary>
    public const int e_atLowerLimit = 1;

    /// <summary>State of a limit in the original: at its upper end.</summary>
    public const int e_atUpperLimit = 2;

    /// <summary>State of a limit in the original: both ends are one.</summary>
    public const int e_equalLimits = 3;

    private readonly int _type;
    private readonly b2Body _body1;
    private readonly b2Body _body2;
    [NotState(Why.Users)]
    private object? _userData;

    private protected b2Joint(b2JointDef def, b2World world, JointKind kind, b2Body body1, b2Body body2)
    {
        _type = def.type;
        _userData = def.userData;
        _body1 = body1;
        _body2 = body2;
        World = world;
        CollideConnected = def.collideConnected;
        Link = world.Engine.Tie(kind, def.collideConnected);
        Edge1 = new b2JointEdge(this, body2);
        Edge2 = new b2JointEdge(this, body1);
    }

    internal b2World World { get; }

    internal JointTie Link { get; }

    internal bool CollideConnected { get; }

    internal b2Joint? Next { get; set; }

    internal b2JointEdge Edge1 { get; }

    internal b2JointEdge Edge2 { get; }

    /// <summary>
    /// The kind of joint, for example <see cref="e_revoluteJoint"/>. It hides the type of the object, as the name is that of the original.
    /// </summary>
    /// <returns>The kind.</returns>
    public new int GetType() => _type;

    /// <summary>The anchor at the first body, in the world.</summary>
    /// <returns>A new vector.</returns>
    public abstract b2Vec2 GetAnchor1();

    /// <summary>The anchor at the second body, in the world.</summary>
    /// <returns>A new vector.</returns>
    public abstract b2Vec2 GetAnchor2();

    /// <summary>The force on the second body at its anchor in the last step, newtons.</summary>
    /// <returns>A new vector.</returns>
    public virtual b2Vec2 GetReactionForce() => new b2Vec2(Reactions.Of(Link.ForceX), Reactions.Of(Link.ForceY));

    /// <summary>The torque on the second body in the last step, N·m.</summary>
    /// <returns>Positive counter-clockwise.</returns>
    public virtual float GetReactionTorque() => Reactions.Of(Link.Torque);

    /// <summary>First body.</summary>
    /// <returns>The body.</returns>
    public b2Body GetBody1() => _body1;

    /// <summary>Second body.</summary>
    /// <returns>The body.</returns>
    public b2Body GetBody2() => _body2;

    /// <summary>The next joint of the world: the one made before this one.</summary>
    /// <returns>The joint, or null after the last.</returns>
    public b2Joint? GetNext() => Next;

    /// <summary>The object that the user attached.</summary>
    /// <returns>The object, or null.</returns>
    public object? GetUserData() => _userData;

    /// <summary>Attaches an object.</summary>
    /// <param name="data">Any object, or null.</param>
    public void SetUserData(object? data) => _userData = data;

    internal virtual void Attach() => Link.Attach(_body1.Link, _body2.Link);

    internal virtual bool DependsOn(b2Joint joint) => false;

    /// <summary>Hands changed settings and flags on, and wakes the bodies.</summary>
    private protected void Changed()
    {
        Link.Push((World.Quirks & Box2DFlash202Quirks.SettersWakeNobody) == 0);
        _body1.WakeBySetter();
        _body2.WakeBySetter();
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    internal virtual void Visit(StateStream s)
    {
        Link.Visit(s);
        Next = s.Reference(Next);
        Edge1.Visit(s);
        Edge2.Visit(s);
    }
}
