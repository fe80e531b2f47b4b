using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using Farseer.Hunt.Running;

namespace Farseer.Hunt.Flash;

/// <summary>What is seen of worlds of Box2DFlash 2.0.2.</summary>
internal sealed partial class FlashObserver : Observer
{
    /// <summary>A body that was frozen so deep inside of its world has not left it: its state was none.</summary>
    private const float Inside = 50;

    /// <summary>Where products of masses and speeds are no floats any more.</summary>
    private const float MostMass = 1e9f;

    private readonly Dictionary<object, b2AABB> _rooms = new(ReferenceEqualityComparer.Instance);

    public override void Made(object item, object?[] arguments)
    {
        if (item is b2World && arguments[0] is b2AABB room)
        {
            _rooms[item] = new b2AABB { lowerBound = room.lowerBound.Copy(), upperBound = room.upperBound.Copy() };
        }
    }

    public override void Stepped(object world)
    {
        b2AABB room = _rooms[world];
        foreach (b2Body body in All((b2World)world).Where(b => b.IsFrozen()))
        {
            b2Vec2 place = body.GetWorldCenter();
            if (Math.Min(place.x - room.lowerBound.x, room.upperBound.x - place.x) > Inside && Math.Min(place.y - room.lowerBound.y,
                room.upperBound.y - place.y) > Inside)
            {
                Quarantined.Add(string.Create(CultureInfo.InvariantCulture,
                    $"a body at ({place.x}, {place.y}) is frozen{(body.GetJointList() is null ? "" : " (with joints)")}"));
            }
        }
    }

    public override bool HasContacts(object world)
    {
        for (b2Contact? contact = ((b2World)world).GetContactList(); contact is not null; contact = contact.GetNext())
        {
            if (contact.GetManifoldCount() > 0)
            {
                return true;
            }
        }

        return false;
    }

    public override void SetWorkers(object world, int count) => ((b2World)world).SetWorkerCount(count);

    public override ulong Hash(object world) => ((b2World)world).MotionHash();

    /// <summary>Definitions and boxes are what a user wrote.</summary>
    public override bool IsStepped(object world, object item) => 
        item is b2World or b2Body or b2Shape || (item is b2Joint joint && IsInRange(joint.GetBody1()) && IsInRange(joint.GetBody2()));

    public override List<BodyFact> Bodies(object world) => All((b2World)world).Select(body =>
    {
        b2Vec2 place = body.GetWorldCenter();
        b2Vec2 velocity = body.GetLinearVelocity();
        return new BodyFact(
            place.x, place.y, velocity.x, velocity.y, body.GetAngularVelocity(), body.GetMass(), body.GetInertia(), body.IsDynamic()
                && !body.IsFrozen());
    }).ToList();

    public override (double X, double Y) Gravity(object world) => (((b2World)world).GetGravity().x, ((b2World)world).GetGravity().y);

    public override string? Lists(object world)
    {
        var made = (b2World)world;
        List<b2Body> bodies = All(made);
        HashSet<b2Body> known = new(bodies, ReferenceEqualityComparer.Instance);
        HashSet<b2Joint> joints = new(ReferenceEqualityComparer.Instance);
        for (b2Joint? joint = made.GetJointList(); joint is not null; joint = joint.GetNext())
        {
            if (!joints.Add(joint))
            {
                return "a joint is in the list twice";
            }
        }

        HashSet<b2Shape> shapes = new(ReferenceEqualityComparer.Instance);
        int edges = 0;
        foreach (b2Body body in bodies)
        {
            for (b2Shape? shape = body.GetShapeList(); shape is not null; shape = shape.GetNext())
            {
                if (!ReferenceEquals(shape.GetBody(), body) || !shapes.Add(shape))
                {
                    return "a shape is in the list of another body";
                }
            }

            for (b2JointEdge? edge = body.GetJointList(); edge is not null; edge = edge.next)
            {
                edges++;
                if (!joints.Contains(edge.joint) || !known.Contains(edge.other))
                {
                    return "a body has a joint that is not in the list";
                }
            }
        }

        for (b2Contact? contact = made.GetContactList(); contact is not null; contact = contact.GetNext())
        {
            if (!shapes.Contains(contact.GetShape1()) || !shapes.Contains(contact.GetShape2()))
            {
                return "a contact has a shape that is not in the list";
            }
        }

        // The engine knows the same shapes: a query finds each that is not frozen, and none that is gone.
        List<b2Shape> found = new();
        made.Query(new b2AABB { lowerBound = new b2Vec2(-1e9f, -1e9f), upperBound = new b2Vec2(1e9f, 1e9f) }, found, int.MaxValue);
        if (found.Any(s => !shapes.Contains(s)) || shapes.Any(s => !s.GetBody()!.IsFrozen() && !found.Contains(s))
            || found.Distinct().Count() != found.Count)
        {
            return "a query does not find the shapes that there are";
        }

        return bodies.Count != made.GetBodyCount() || known.Count != bodies.Count ? "the count of bodies is not that of the list"
            : joints.Count != made.GetJointCount() ? "the count of joints is not that of the list"
            : edges != 2 * joints.Count ? "joints are not known to both bodies"
            : null;
    }

    public override string? FallOfANewBody(object world)
    {
        var made = (b2World)world;
        made.SetGravity(new b2Vec2(0, -10));

        // Without a shape, since in extreme worlds there is something everywhere.
        var def = new b2BodyDef { massData = new b2MassData { mass = 1, I = 1 } };
        b2Body late = made.CreateBody(def)!;
        for (int i = 0; i < 4; i++)
        {
            made.Step(0.01f, 4);
        }

        float speed = -late.GetLinearVelocity().y;
        return !(speed > 0.39f && speed < 0.41f) ? string.Create(CultureInfo.InvariantCulture, $"its speed is {speed} after 0.04 s")
            : null;
    }

    private static bool IsInRange(b2Body? body) => body is null || (body.GetMass() <= MostMass
        && body.GetInertia() <= MostMass * MostMass);

    private static List<b2Body> All(b2World world)
    {
        List<b2Body> bodies = new();
        for (b2Body? body = world.GetBodyList(); body is not null; body = body.GetNext())
        {
            bodies.Add(body);
        }

        return bodies;
    }
}
