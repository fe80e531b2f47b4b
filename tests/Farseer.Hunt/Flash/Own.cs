using System;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;

namespace Farseer.Hunt.Flash;

/// <summary>A contact listener that calls back.</summary>
public sealed class OwnContacts : b2ContactListener
{
    public event Action Added = delegate { };

    public event Action Persisted = delegate { };

    public event Action Removed = delegate { };

    public event Action Resulted = delegate { };

    public override void Add(b2ContactPoint point) => Added();

    public override void Persist(b2ContactPoint point) => Persisted();

    public override void Remove(b2ContactPoint point) => Removed();

    public override void Result(b2ContactResult point) => Resulted();
}

/// <summary>A filter that asks.</summary>
public sealed class OwnFilter : b2ContactFilter
{
    public event Func<bool> Asked = () => true;

    public override bool ShouldCollide(b2Shape shape1, b2Shape shape2) => Asked() && base.ShouldCollide(shape1, shape2);
}

/// <summary>A listener of what is destroyed with a body.</summary>
public sealed class OwnGoodbyes : b2DestructionListener
{
    public event Action JointGoes = delegate { };

    public event Action ShapeGoes = delegate { };

    public override void SayGoodbyeJoint(b2Joint joint) => JointGoes();

    public override void SayGoodbyeShape(b2Shape shape) => ShapeGoes();
}

/// <summary>A listener of bodies that leave the world.</summary>
public sealed class OwnBoundary : b2BoundaryListener
{
    public event Action Left = delegate { };

    public override void Violation(b2Body body) => Left();
}
