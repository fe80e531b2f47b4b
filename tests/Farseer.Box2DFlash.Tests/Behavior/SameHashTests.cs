using System.Collections.Generic;
using System.Numerics;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>Both facades are thin: the same scene made with either goes the same way, bit for bit.</summary>
public sealed class SameHashTests
{
    // A coefficient whose mixtures by mean, root and maximum are one number.
    private const float Friction = 0.25f;

    [Fact]
    public void SameScene_MadeWithEitherFacade_HasTheSameHash()
    {
        b2World world = Bench.World(-10, 1000, false);

        // Bodies of this facade rest in each other by half a slop, those of the other one at each other.
        world.Engine.MostRestShare = 0;
        PhysicsSimulator simulator = new(new Vector2(0, -10)) { Iterations = 10 };
        Add(world, simulator, 0, -1, 20, 1, 0);
        List<(b2Body Flash, Body Farseer)> bodies = [];
        for (int i = 0; i < 5; i++)
        {
            bodies.Add(Add(world, simulator, 0.125f * i, 0.75f + (1.25f * i), 0.5f, 0.5f, 1));
        }

        bodies[4].Flash.SetLinearVelocity(new b2Vec2(3, 0));
        bodies[4].Farseer.LinearVelocity = new Vector2(3, 0);
        simulator.Update(0);
        for (int step = 0; step < 240; step++)
        {
            world.Step(Bench.Dt, 10);
            simulator.Update(Bench.Dt);
            foreach ((b2Body flash, Body farseer) in bodies)
            {
                Assert.Equal(farseer.Position.X, flash.GetPosition().x);
                Assert.Equal(farseer.Position.Y, flash.GetPosition().y);
            }
        }

        Assert.Equal(simulator.MotionHash(), world.MotionHash());
    }

    private static (b2Body Flash, Body Farseer) Add(
        b2World world, PhysicsSimulator simulator, float x, float y, float hx, float hy, float density)
    {
        b2PolygonDef def = Bench.BoxDef(hx, hy, density);
        def.friction = Friction;
        b2Body flash = Bench.Body(world, x, y, def);
        Body farseer = BodyFactory.Instance.CreateRectangleBody(simulator, 2 * hx, 2 * hy, density > 0 ? flash.GetMass() : 1);
        farseer.Position = new Vector2(x, y);
        farseer.IsStatic = density == 0;
        farseer.LinearDragCoefficient = 0;
        farseer.RotationalDragCoefficient = 0;
        if (density > 0)
        {
            farseer.MomentOfInertia = flash.GetInertia();
        }

        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, farseer, 2 * hx, 2 * hy);
        geom.FrictionCoefficient = Friction;
        geom.RestitutionCoefficient = 0;
        return (flash, farseer);
    }
}
