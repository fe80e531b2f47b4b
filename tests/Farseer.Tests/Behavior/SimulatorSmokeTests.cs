using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>The facade and the engine together, in small.</summary>
public class SimulatorSmokeTests
{
    private const float Step = 0.01f;

    [Fact]
    public void Box_DroppedOnAFloor_ComesToRestOnIt()
    {
        PhysicsSimulator simulator = Floor(out _);
        Body box = Box(simulator, new Vector2(0, -30), out _);
        Run(simulator, 300);

        // Resting depth is AllowedPenetration, 0.05, on a floor whose surface is at -10.
        Assert.InRange(box.Position.Y, -20.01f, -19.9f);
        Assert.InRange(box.LinearVelocity.Length(), 0, 0.05f);
    }

    [Fact]
    public void Events_OfABounce_ComeInOrderAndNameTheOlderGeomFirst()
    {
        PhysicsSimulator simulator = Floor(out Geom floor);
        Body box = Box(simulator, new Vector2(0, -25), out Geom geom);
        geom.RestitutionCoefficient = 1;
        floor.RestitutionCoefficient = 1;
        var log = new List<string>();
        floor.OnCollision += (a, b, contacts) =>
        {
            log.Add("floor");
            Assert.Same(floor, a);
            Assert.Same(geom, b);
            Assert.True(contacts.Count > 0);
            Assert.True(contacts[0].Normal.Y < -0.9f);
            return true;
        };
        geom.OnCollision += (a, b, contacts) =>
        {
            log.Add("box");
            Assert.Same(geom, a);
            Assert.True(contacts[0].Normal.Y > 0.9f);
            return true;
        };
        geom.OnSeparation += (a, b) => log.Add("part");
        Run(simulator, 100);
        Assert.Equal("floor", log[0]);
        Assert.Equal("box", log[1]);
        Assert.Contains("part", log);
        Assert.True(box.Position.Y < -20);
    }

    [Fact]
    public void OnCollision_ReturningFalse_LetsTheBoxFallThrough()
    {
        PhysicsSimulator simulator = Floor(out _);
        Body box = Box(simulator, new Vector2(0, -25), out Geom geom);
        geom.OnCollision += (_, _, _) => false;
        Run(simulator, 200);
        Assert.True(box.Position.Y > 50);
    }

    [Fact]
    public void RemovedFloor_TellsOfTheSeparation_AndLetsTheBoxFall()
    {
        PhysicsSimulator simulator = Floor(out Geom floor);
        Body box = Box(simulator, new Vector2(0, -20), out Geom geom);
        int parted = 0;
        geom.OnSeparation += (_, _) => parted++;
        Run(simulator, 50);
        Assert.Equal(0, parted);
        Assert.Single(simulator.ArbiterList);
        simulator.Remove(floor);
        Run(simulator, 100);
        Assert.Equal(1, parted);
        Assert.Empty(simulator.ArbiterList);
        Assert.True(box.Position.Y > 0);
        Assert.Single(simulator.GeomList);
    }

    [Fact]
    public void DisposedBody_TakesItsGeomsAlong()
    {
        PhysicsSimulator simulator = Floor(out Geom floor);
        Box(simulator, new Vector2(0, -20), out Geom geom);
        int parted = 0;
        geom.OnSeparation += (_, _) => parted++;
        Run(simulator, 50);
        floor.Body.Dispose();
        Run(simulator, 1);
        Assert.True(floor.IsDisposed);
        Assert.Single(simulator.GeomList);
        Assert.Single(simulator.BodyList);
        Assert.Equal(1, parted);
    }

    [Fact]
    public void Velocity_IsAssignableInAllThreeWays()
    {
        var body = new Body { LinearVelocity = new Vector2(1, 2), AngularVelocity = 3 };
        body.LinearVelocity.X = 5;
        body.LinearVelocity += Vector2.One;
        Assert.Equal(new Vector2(6, 3), body.LinearVelocity);
        Assert.Equal(3, body.AngularVelocity);
    }

    [Fact]
    public void ApplyImpulse_ChangesTheVelocityByJOverM_AndByJOverMSquaredWithTheQuirk()
    {
        foreach (bool quirk in new[] { false, true })
        {
            var simulator = new PhysicsSimulator { Quirks = quirk ? Farseer201Quirks.ImpulseDividedByMassTwice : Farseer201Quirks.None };
            Body body = BodyFactory.Instance.CreateBody(simulator, 4, 1);
            body.LinearDragCoefficient = 0;
            body.ApplyImpulse(new Vector2(8, 0));
            Run(simulator, 1);
            Assert.Equal(quirk ? 0.5f : 2f, body.LinearVelocity.X, 5);
        }
    }

    [Fact]
    public void RemovedBody_KeepsItsState_AndCanBeAddedAgain()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 10));
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        Run(simulator, 10);
        Vector2 velocity = body.LinearVelocity;
        Vector2 position = body.Position;
        Assert.True(velocity.Y > 0);
        simulator.Remove(body);
        Run(simulator, 5);
        Assert.Empty(simulator.BodyList);
        Assert.Equal(velocity, body.LinearVelocity);
        Assert.Equal(position, body.Position);
        simulator.Add(body);
        Run(simulator, 1);
        Assert.True(body.Position.Y > position.Y);
    }

    [Fact]
    public void Concave_Outline_RestsOnItsLongSide()
    {
        PhysicsSimulator simulator = Floor(out _);
        var outline = new Vertices
        {
            new Vector2(0, 0), new Vector2(30, 0), new Vector2(30, -10), new Vector2(10, -10), new Vector2(10, -30), new Vector2(0, -30),
        };
        Body body = BodyFactory.Instance.CreatePolygonBody(simulator, outline, 2);
        GeomFactory.Instance.CreatePolygonGeom(simulator, body, outline, 0);
        body.Position += new Vector2(0, -15);
        Run(simulator, 300);
        Assert.InRange(Math.Abs(body.TotalRotation), 0, 0.01f);
        Assert.InRange(body.LinearVelocity.Length(), 0, 0.05f);
    }

    [Fact]
    public void Updates_WithHandlers_AllocateNothing()
    {
        PhysicsSimulator simulator = Floor(out Geom floor);
        int heard = 0;
        for (int i = 0; i < 5; i++)
        {
            Box(simulator, new Vector2(0.3f * i, -20 - (21 * i)), out Geom geom);
            geom.OnCollision += (_, _, _) => ++heard > 0;
            geom.OnSeparation += (_, _) => heard++;
            geom.Body.Updated += (ref Vector2 _, ref float _) => heard++;
        }

        Run(simulator, 200);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Run(simulator, 100);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        Assert.True(heard > 0);
        _ = floor;
    }

    [Fact]
    public void UsersOwnCollider_FindsThePairs()
    {
        PhysicsSimulator simulator = new PhysicsSimulator(new Vector2(0, 100));
        simulator.BroadPhaseCollider = new EveryPair(simulator);
        AddFloor(simulator, out _);
        Body box = Box(simulator, new Vector2(0, -30), out _);
        Run(simulator, 300);
        Assert.InRange(box.Position.Y, -20.01f, -19.9f);
    }

    private static PhysicsSimulator Floor(out Geom floor)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        AddFloor(simulator, out floor);
        return simulator;
    }

    private static void AddFloor(PhysicsSimulator simulator, out Geom floor)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 400, 20, 1);
        body.IsStatic = true;
        floor = GeomFactory.Instance.CreateRectangleGeom(simulator, body, 400, 20);
    }

    private static Body Box(PhysicsSimulator simulator, Vector2 place, out Geom geom)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 20, 20, 1);
        body.Position = place;
        geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, 20, 20);
        return body;
    }

    private static void Run(PhysicsSimulator simulator, int steps)
    {
        for (int i = 0; i < steps; i++)
        {
            simulator.Update(Step);
        }
    }

    private sealed class EveryPair : FarseerGames.FarseerPhysics.Interfaces.IBroadPhaseCollider
    {
        private readonly PhysicsSimulator _simulator;

        public EveryPair(PhysicsSimulator simulator) => _simulator = simulator;

        public event FarseerGames.FarseerPhysics.Interfaces.BroadPhaseCollisionHandler? OnBroadPhaseCollision;

        public void Add(Geom geom)
        {
        }

        public void ProcessDisposedGeoms()
        {
        }

        public void ProcessRemovedGeoms()
        {
        }

        public void Update()
        {
            GeomList geoms = _simulator.GeomList;
            for (int i = 0; i < geoms.Count; i++)
            {
                for (int j = i + 1; j < geoms.Count; j++)
                {
                    var arbiter = new Arbiter { GeomA = geoms[i], GeomB = geoms[j] };
                    if (!_simulator.ArbiterList.Contains(arbiter) && OnBroadPhaseCollision?.Invoke(geoms[i], geoms[j]) != false)
                    {
                        _simulator.ArbiterList.Add(arbiter);
                    }
                }
            }
        }
    }
}
