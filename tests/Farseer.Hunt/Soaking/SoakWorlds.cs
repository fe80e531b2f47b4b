using System;
using System.Numerics;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;

namespace Farseer.Hunt.Soaking;

/// <summary>Worlds that are made, run with workers, and dropped in every way.</summary>
internal static class SoakWorlds
{
    public const int Kinds = 6;
    private const int Bodies = 1600;
    private const int Columns = 40;
    private const int Steps = 30;
    private const float Dt = 1 / 60f;

    /// <summary>Makes and runs a world, and lets go of it.</summary>
    /// <returns>Body-steps.</returns>
    public static long Run(long number) => (number % Kinds) switch
    {
        0 => RunDisposed(),
        1 => RunDropped(number),
        2 => RunWithScheduler(new Thrower()),
        3 => RunWithScheduler(new Sleeper()),
        4 => RunWithBadHandlers(),
        _ => RunFlash(),
    };

    private static long RunDisposed()
    {
        using PhysicsSimulator simulator = Pile(2);
        return Step(simulator, Steps);
    }

    /// <summary>Without a word of farewell, and with all that it can hold: states, joints, bodies that came and went.</summary>
    private static long RunDropped(long number)
    {
        PhysicsSimulator simulator = Pile(4);
        long steps = Step(simulator, Steps / 2);
        PhysicsSimulatorState state = simulator.Capture();
        for (int i = 1; i < simulator.BodyList.Count; i += 3)
        {
            if (number % 2 == 0)
            {
                simulator.BodyList[i].Dispose();
            }
            else
            {
                JointFactory.Instance.CreateRevoluteJoint(
                    simulator, simulator.BodyList[i], simulator.BodyList[i - 1], simulator.BodyList[i].Position);
            }
        }

        steps += Step(simulator, Steps / 2);
        simulator.Restore(state);
        return steps + Step(simulator, 1);
    }

    private static long RunWithScheduler(IStepScheduler scheduler)
    {
        PhysicsSimulator simulator = Pile(4);
        simulator.StepScheduler = scheduler;
        return Step(simulator, Steps);
    }

    private static long RunWithBadHandlers()
    {
        PhysicsSimulator simulator = Pile(2);
        int told = 0;
        simulator.Update(0);
        foreach (Geom geom in simulator.GeomList)
        {
            geom.OnCollision += (_, _, _) => ++told % 50 == 0 ? throw new SoakException() : true;
        }

        return Step(simulator, Steps);
    }

    private static long RunFlash()
    {
        var bounds = new b2AABB { lowerBound = new b2Vec2(-100, -100), upperBound = new b2Vec2(100, 100) };
        var world = new b2World(bounds, new b2Vec2(0, -10), false);
        world.SetWorkerCount(4);
        for (int i = -1; i < Bodies; i++)
        {
            var def = new b2BodyDef();
            def.position.Set(i < 0 ? 0 : ((i % Columns) - (0.5f * Columns)) * 1.1f, i < 0 ? -1 : 0.5f + (1.1f * (i / Columns)));
            b2Body body = world.CreateBody(def);
            var shape = new b2PolygonDef { density = i < 0 ? 0 : 1 };
            shape.SetAsBox(i < 0 ? 50 : 0.5f, i < 0 ? 1 : 0.5f);
            body.CreateShape(shape);
            body.SetMassFromShapes();
        }

        for (int i = 0; i < Steps; i++)
        {
            world.Step(Dt, 10);
        }

        return (long)Bodies * Steps;
    }

    private static PhysicsSimulator Pile(int workers)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 10)) { WorkerCount = workers };
        for (int i = -1; i < Bodies; i++)
        {
            float width = i < 0 ? 100 : 1;
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, 1, 1);
            body.Position = i < 0
                ? new Vector2(0, 0.5f)
                : new Vector2(((i % Columns) - (0.5f * Columns)) * 1.1f, -0.5f - (1.1f * (i / Columns)));
            body.IsStatic = i < 0;
            GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, 1);
        }

        return simulator;
    }

    private static long Step(PhysicsSimulator simulator, int steps)
    {
        for (int i = 0; i < steps; i++)
        {
            try
            {
                simulator.Update(Dt);
            }
            catch (SoakException)
            {
                // What handlers and schedulers throw on purpose comes out after the step.
            }
        }

        return (long)simulator.BodyList.Count * steps;
    }

    private sealed class SoakException : Exception;

    /// <summary>A host that cannot help.</summary>
    private sealed class Thrower : IStepScheduler
    {
        public void Start(int count, Action help) => throw new SoakException();
    }

    /// <summary>A host that never comes to it.</summary>
    private sealed class Sleeper : IStepScheduler
    {
        public void Start(int count, Action help)
        {
        }
    }
}
