using System;
using System.Collections.Generic;
using System.Numerics;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Farseer.Hunt.Calls;
using Farseer.Hunt.Running;

namespace Farseer.Hunt.Flash;

/// <summary>The model of Box2DFlash 2.0.2.</summary>
internal sealed class FlashFacade : Facade
{
    public FlashFacade()
        : base(
            new Catalogue(new FlashNames()),
            new StepMember(
                typeof(b2World),
                (world, dt, iterations) => ((b2World)world).Step(dt, iterations),
                (world, dt, iterations) => $"{world}.Step({dt}, {iterations})",
                new IntegerKind(1, 12, 1, 50)),
            Array.Empty<Member>())
    {
    }

    public override string Name => "flash";

    public override Type World => typeof(b2World);

    public override IReadOnlyList<string> Namespaces { get; } = new[]
    {
        "System", "System.Collections.Generic", "Box2D.Collision", "Box2D.Collision.Shapes", "Box2D.Common.Math", "Box2D.Dynamics",
            "Box2D.Dynamics.Contacts",
        "Box2D.Dynamics.Joints",
    };

    public override Observer Observe() => new FlashObserver();

    public override void Open(Decoder decoder)
    {
        Choices choices = decoder.Choices;
        bool isFree = decoder.Profile == Profile.Free;
        int world = AddWorld(decoder, isFree ? Vector2.Zero : new Vector2(0, -10));
        if (!isFree)
        {
            int def = decoder.Emit("newb2BodyDef()");
            decoder.Emit("b2BodyDef.set_position(b2Vec2)", def, new Vector2(0, -1));
            int floor = decoder.Emit("b2World.CreateBody(b2BodyDef)", world, def);
            int box = decoder.Emit("newb2PolygonDef()");
            decoder.Emit("b2PolygonDef.SetAsBox(Single,Single)", box, 100f, 1f);
            decoder.Emit("b2Body.CreateShape(b2ShapeDef)", floor, box);
        }

        int count = 1 + choices.Below(choices.OneIn(8) ? 60 : 10);
        int columns = 1 + choices.Below(8);
        var bodies = new List<int>();
        for (int i = 0; i < count && !choices.AreSpent; i++)
        {
            Vector2 place = PlaceOf(i, columns);
            bodies.Add(AddBody(decoder, world, place));
            if (i > 0 && choices.OneIn(4))
            {
                int before = choices.Below(i);
                AddJoint(decoder, world, bodies[before], bodies[i], (place + PlaceOf(before, columns)) / 2);
            }
        }
    }

    public override void Compose(Decoder decoder)
    {
        if (decoder.Pick(typeof(b2World)) is not { } world)
        {
            return;
        }

        switch (decoder.Choices.Below(8))
        {
            case 0 or 1 or 2:
                AddBody(decoder, world, null);
                break;
            case 3 or 4 when decoder.Pick(typeof(b2Body)) is { } one && decoder.Pick(typeof(b2Body)) is { } other:
                AddJoint(decoder, world, one, other, null);
                break;
            case 5 when decoder.Pick(typeof(b2JointDef)) is { } def:
                decoder.Emit("b2World.CreateJoint(b2JointDef)", world, def);
                break;
            case 6 when decoder.Pick(typeof(b2Body)) is { } body:
                AddShape(decoder, body);
                decoder.Emit("b2Body.SetMassFromShapes()", body);
                break;
            case 7 when decoder.Choices.OneIn(3):
                Listen(decoder, world);
                break;
            default:
                decoder.Emit(Step.Key, world);
                break;
        }
    }

    private static int AddWorld(Decoder decoder, Vector2 gravity)
    {
        int box = decoder.Emit("newb2AABB()");
        decoder.Emit("b2AABB.set_lowerBound(b2Vec2)", box, new Vector2(-1000, -1000));
        decoder.Emit("b2AABB.set_upperBound(b2Vec2)", box, new Vector2(1000, 1000));
        int world = decoder.Emit("newb2World(b2AABB,b2Vec2,Boolean)", box, gravity);
        if (decoder.Profile >= Profile.Ordinary)
        {
            for (int i = decoder.Choices.Below(4); i > 0; i--)
            {
                Listen(decoder, world);
            }
        }

        return world;
    }

    private static void Listen(Decoder decoder, int world)
    {
        switch (decoder.Choices.Below(4))
        {
            case 0: decoder.Emit("b2World.SetContactListener(b2ContactListener)", world, decoder.Emit("newOwnContacts()")); break;
            case 1: decoder.Emit("b2World.SetContactFilter(b2ContactFilter)", world, decoder.Emit("newOwnFilter()")); break;
            case 2: decoder.Emit("b2World.SetDestructionListener(b2DestructionListener)", world, decoder.Emit("newOwnGoodbyes()")); break;
            default: decoder.Emit("b2World.SetBoundaryListener(b2BoundaryListener)", world, decoder.Emit("newOwnBoundary()")); break;
        }
    }

    private static int AddBody(Decoder decoder, int world, Vector2? place)
    {
        Choices choices = decoder.Choices;
        int def = decoder.Emit("newb2BodyDef()");
        decoder.Emit("b2BodyDef.set_position(b2Vec2)", def, place);
        decoder.Emit("b2BodyDef.set_angle(Single)", def);
        bool isSpecial = choices.OneIn(6);
        if (isSpecial)
        {
            decoder.Emit(choices.Flag() ? "b2BodyDef.set_isBullet(Boolean)" : "b2BodyDef.set_fixedRotation(Boolean)", def, true);
        }

        int body = decoder.Emit("b2World.CreateBody(b2BodyDef)", world, def);
        for (int i = choices.OneIn(6) ? 2 : 1; i > 0; i--)
        {
            AddShape(decoder, body);
        }

        if (decoder.Profile < Profile.Ordinary || !choices.OneIn(8))
        {
            decoder.Emit("b2Body.SetMassFromShapes()", body);
        }

        decoder.Emit("b2Body.SetLinearVelocity(b2Vec2)", body);
        if (!isSpecial && choices.Flag())
        {
            decoder.Emit("b2Body.SetAngularVelocity(Single)", body);
        }

        return body;
    }

    private static void AddShape(Decoder decoder, int body)
    {
        Choices choices = decoder.Choices;
        int shape;
        switch (choices.Below(4))
        {
            case 0:
                shape = decoder.Emit("newb2CircleDef()");
                decoder.Emit("b2CircleDef.set_radius(Single)", shape);
                break;
            case 1:
                shape = decoder.Emit("newb2PolygonDef()");
                decoder.Emit("b2PolygonDef.SetAsOrientedBox(Single,Single,b2Vec2,Single)", shape);
                break;
            default:
                shape = decoder.Emit("newb2PolygonDef()");
                decoder.Emit("b2PolygonDef.SetAsBox(Single,Single)", shape);
                break;
        }

        decoder.Emit("b2ShapeDef.set_density(Single)", shape, decoder.Profile < Profile.Ordinary ? choices.Between(0.2f, 5) : null);
        decoder.Emit("b2ShapeDef.set_friction(Single)", shape);
        decoder.Emit("b2ShapeDef.set_restitution(Single)", shape, decoder.Profile < Profile.Ordinary ? choices.Between(0, 0.8f) : null);
        decoder.Emit("b2Body.CreateShape(b2ShapeDef)", body, shape);
    }

    /// <summary>A joint that holds as the bodies stand, without motors.</summary>
    private static void AddJoint(Decoder decoder, int world, int one, int other, Vector2? middle)
    {
        int def;
        switch (decoder.Choices.Below(5))
        {
            case 0 or 1:
                def = decoder.Emit("newb2RevoluteJointDef()");
                decoder.Emit("b2RevoluteJointDef.Initialize(b2Body,b2Body,b2Vec2)", def, one, other, middle);
                break;
            case 2:
                def = decoder.Emit("newb2PrismaticJointDef()");
                decoder.Emit("b2PrismaticJointDef.Initialize(b2Body,b2Body,b2Vec2,b2Vec2)", def, one, other, middle, Vector2.UnitX);
                break;
            case 3 when decoder.Profile >= Profile.Ordinary:
                def = decoder.Emit("newb2MouseJointDef()");
                decoder.Emit("b2JointDef.set_body1(b2Body)", def, one);
                decoder.Emit("b2JointDef.set_body2(b2Body)", def, other);
                decoder.Emit("b2MouseJointDef.set_target(b2Vec2)", def);
                decoder.Emit("b2MouseJointDef.set_maxForce(Single)", def);
                break;
            default:
                def = decoder.Emit("newb2DistanceJointDef()");
                Vector2? end = middle is { } m ? m + Vector2.UnitY : null;
                decoder.Emit("b2DistanceJointDef.Initialize(b2Body,b2Body,b2Vec2,b2Vec2)", def, one, other, middle, end);
                break;
        }

        decoder.Emit("b2World.CreateJoint(b2JointDef)", world, def);
    }
}
