using System.Collections.Generic;
using System.Numerics;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Serialization.Tables;

namespace FarseerGames.FarseerPhysics.Serialization.States;

/// <summary>Worlds that have one of everything, for <see cref="StateLayout"/>.</summary>
internal static class SampleWorlds
{
    private const float Dt = 1f / 64;

    public static IReadOnlyList<StateNote> SimulatorTrace()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10))
        {
            EnableReport = true, SumImpulses = true, KeepsPoses = true, AllowSleep = true, RecordedEvents = StepEventKinds.All,
            ErrorBudget = ErrorBudget.OfShare(0.001f),
        };
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 64, 1, 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateChainGeom(
            simulator, floor, new Vertices(new[] { new Vector2(32, 0), new Vector2(0, 0), new Vector2(-32, 0) }), false)
            .SetSegmentMaterial(0, new SurfaceMaterial { Friction = 1, Speed = 1 });
        foreach (JointKindOfFile kind in JointTables.Kinds)
        {
            Body first = Box(simulator, -1);
            Body second = Box(simulator, 1);
            simulator.Add(kind.OfPair is not null ? kind.OfPair(first, second) : kind.OfOne!(second));
        }

        foreach (SpringKindOfFile kind in SpringTables.Kinds)
        {
            Spring spring = kind.Make();
            kind.Tie(spring, Box(simulator, -1), Box(simulator, 1));
            simulator.Add(spring);
        }

        foreach (ControllerKindOfFile kind in ControllerTables.Kinds)
        {
            Controller controller = kind.Make(simulator);
            if (controller is FluidDragController fluid)
            {
                fluid.Initialize(new AABBFluidContainer(new AABB(-Vector2.One, Vector2.One)), 1, 1, 1, -Vector2.UnitY);
                fluid.AddGeom(floor.Geoms[0]);
            }

            simulator.Add(controller);
        }

        simulator.Update(Dt);
        simulator.Update(Dt);
        var stream = new StateStream { Trace = new StateTrace() };
        simulator.Write(stream, new Bridge.StateRoster());
        return stream.Trace.Notes;
    }

    public static IReadOnlyList<StateNote> WorldTrace()
    {
        var world =
            new b2World(new b2AABB { lowerBound = new b2Vec2(-64, -64), upperBound = new b2Vec2(64, 64) }, new b2Vec2(0, -10), true);
        b2Body ground = world.GetGroundBody();
        ground.CreateShape(Rectangle(32, 1));
        b2Body first = Ball(world, -1);
        b2Body second = Ball(world, 1);
        var hinge = new b2RevoluteJointDef();
        hinge.Initialize(ground, first, new b2Vec2(-1, 2));
        var slider = new b2PrismaticJointDef();
        slider.Initialize(ground, second, new b2Vec2(1, 2), new b2Vec2(1, 0));
        var gear =
            new b2GearJointDef { joint1 = world.CreateJoint(hinge), joint2 = world.CreateJoint(slider), body1 = first, body2 = second };
        world.CreateJoint(gear);
        var rod = new b2DistanceJointDef();
        rod.Initialize(first, second, new b2Vec2(-1, 1), new b2Vec2(1, 1));
        world.CreateJoint(rod);
        var rope = new b2PulleyJointDef();
        rope.Initialize(first, second, new b2Vec2(-1, 9), new b2Vec2(1, 9), new b2Vec2(-1, 1), new b2Vec2(1, 1), 1);
        world.CreateJoint(rope);
        world.CreateJoint(new b2MouseJointDef { body1 = ground, body2 = second, target = new b2Vec2(1, 1), maxForce = 1 });
        world.Step(Dt, 10);
        world.Step(Dt, 10);
        var stream = new StateStream { Trace = new StateTrace() };
        world.Write(stream, new Box2D.Bridge.StateRoster());
        return stream.Trace.Notes;
    }

    private static Body Box(PhysicsSimulator simulator, float x)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        body.Position = new Vector2(x, 0.5f);
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1);
        return body;
    }

    private static b2PolygonDef Rectangle(float x, float y)
    {
        var def = new b2PolygonDef { density = 1 };
        def.SetAsBox(x, y);
        return def;
    }

    private static b2Body Ball(b2World world, float x)
    {
        b2Body body = world.CreateBody(new b2BodyDef { position = new b2Vec2(x, 1.5f) });
        body.CreateShape(new b2CircleDef { radius = 0.5f, density = 1 });
        body.SetMassFromShapes();
        return body;
    }
}
