using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Behavior;

/// <summary>A warm simulation allocates nothing, whatever finds the pairs and whoever listens.</summary>
public class AllocationTests
{
    // The pieces bounce for ever, so pairs may pile up later than ever before: 600 steps did not reach the most of one pair finder.
    private const int WarmSteps = 900;
    private const int CountedSteps = 400;

    public static TheoryData<string> Colliders => new() { "default", "sweep", "prune", "brute", "grid", "own" };

    [Theory]
    [MemberData(nameof(Colliders))]
    public void WarmUpdates_WithEveryHandlerAttached_AllocateNothing(string name)
    {
        // A first run compiles every method that the second one will use.
        Count(name);

        (long bytes, int told) = Count(name);

        Assert.Equal(0, bytes);
        Assert.True(told > 1000, "The handlers were called " + told + " times.");
    }

    [Fact]
    public void ReadersOfContacts_OnceWarm_AllocateNothing()
    {
        long bytes = 0;
        for (int run = 0; run < 2; run++)
        {
            // A pile at rest: arbiters are made when there are more pairs than ever before.
            PhysicsSimulator simulator = WithFloor(out _);
            for (int i = 0; i < 5; i++)
            {
                Box(simulator, new Vector2(0, -11 - (21 * i)));
            }

            Run(simulator, WarmSteps);
            Read(simulator);
            Run(simulator, 1);

            // The second reading is the first to put arbiters back.
            Read(simulator);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < CountedSteps; i++)
            {
                simulator.Update(Step);
                Read(simulator);
            }

            bytes = GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.Equal(0, bytes);
    }

    // A background collection would count the unused rest of the thread's buffer as allocated.
    [Fact]
    public void Counting_WhileTestsRun_IsNotDisturbedByABackgroundCollector() =>
        Assert.Equal(GCLatencyMode.Batch, GCSettings.LatencyMode);

    private static void Read(PhysicsSimulator simulator)
    {
        ArbiterList arbiters = simulator.ArbiterList;
        for (int i = 0; i < arbiters.Count; i++)
        {
            Assert.NotNull(arbiters[i].GeomA);
        }

        for (int i = 0; i < simulator.GeomList.Count; i++)
        {
            _ = simulator.GeomList[i].AABB;
        }
    }

    private static (long Bytes, int Told) Count(string name)
    {
        int told = 0;
        PhysicsSimulator simulator = Busy(name, geom =>
        {
            geom.OnCollision += (_, _, contacts) =>
            {
                told += contacts.Count;
                return true;
            };
            geom.OnSeparation += (_, _) => told++;
            geom.Body.Updated += (ref Vector2 _, ref float _) => told++;
        });
        simulator.BroadPhaseCollider.OnBroadPhaseCollision += (_, _) => ++told > 0;
        Run(simulator, WarmSteps);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Run(simulator, CountedSteps);
        return (GC.GetAllocatedBytesForCurrentThread() - before, told);
    }

    /// <summary>Elastic balls, a box, an L and a dumbbell that never come to rest between four walls.</summary>
    private static PhysicsSimulator Busy(string name, Action<Geom> watch)
    {
        PhysicsSimulator simulator = Falling(20);
        simulator.BroadPhaseCollider = name switch
        {
            "sweep" => new SelectiveSweepCollider(simulator),
            "prune" => new SweepAndPruneCollider(simulator),
            "brute" => new BruteForceCollider(simulator),
            "grid" => new GridCollider(simulator),
            "own" => new ThriftyCollider(simulator),
            _ => simulator.BroadPhaseCollider,
        };
        List<Geom> geoms =
        [
            Wall(simulator, new Vector2(0, 110), 240, 20), Wall(simulator, new Vector2(0, -110), 240, 20),
            Wall(simulator, new Vector2(110, 0), 20, 240), Wall(simulator, new Vector2(-110, 0), 20, 240),
        ];
        for (int i = 0; i < 6; i++)
        {
            geoms.Add(Ball(simulator, new Vector2((25 * i) - 60, (11 * i) - 60), 8));
        }

        geoms.Add(Box(simulator, new Vector2(50, -50), 24, 16));
        Vertices outline = Outline(0, 0, 30, 0, 30, 10, 10, 10, 10, 30, 0, 30);
        Body corner = BodyFactory.Instance.CreatePolygonBody(simulator, outline, 1);
        corner.Position = new Vector2(-50, 50);
        geoms.Add(GeomFactory.Instance.CreatePolygonGeom(simulator, corner, outline, 0));
        Body dumbbell = BodyFactory.Instance.CreateRectangleBody(simulator, 30, 10, 1);
        dumbbell.Position = new Vector2(50, 50);
        geoms.Add(GeomFactory.Instance.CreateCircleGeom(simulator, dumbbell, 6, 16, new Vector2(-15, 0), 0));
        geoms.Add(GeomFactory.Instance.CreateCircleGeom(simulator, dumbbell, 6, 16, new Vector2(15, 0), 0));
        for (int i = 0; i < geoms.Count; i++)
        {
            WithoutDrag(geoms[i].Body);
            geoms[i].RestitutionCoefficient = 1;
            geoms[i].Body.LinearVelocity = geoms[i].Body.IsStatic ? Vector2.Zero : new Vector2(60 - (37 * (i % 4)), 25 - (19 * (i % 5)));
            watch(geoms[i]);
        }

        return simulator;
    }

    private static Geom Wall(PhysicsSimulator simulator, Vector2 place, float width, float height)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, 1);
        body.IsStatic = true;
        body.Position = place;
        return GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height);
    }

    /// <summary>A user's own collider that keeps its arbiters: what is counted is the library's.</summary>
    private sealed class ThriftyCollider : IBroadPhaseCollider
    {
        private readonly PhysicsSimulator _simulator;
        private readonly List<Arbiter> _pairs = [];

        public ThriftyCollider(PhysicsSimulator simulator) => _simulator = simulator;

        public event BroadPhaseCollisionHandler? OnBroadPhaseCollision;

        public void Add(Geom geom)
        {
            foreach (Geom other in _simulator.GeomList)
            {
                if (other != geom && other.Body != geom.Body)
                {
                    _pairs.Add(new Arbiter { GeomA = other, GeomB = geom });
                }
            }
        }

        public void ProcessDisposedGeoms()
        {
        }

        public void ProcessRemovedGeoms()
        {
        }

        public void Update()
        {
            for (int i = 0; i < _pairs.Count; i++)
            {
                Arbiter pair = _pairs[i];
                if (AABB.Intersect(pair.GeomA.AABB, pair.GeomB.AABB) && !_simulator.ArbiterList.Contains(pair)
                    && OnBroadPhaseCollision?.Invoke(pair.GeomA, pair.GeomB) != false)
                {
                    _simulator.ArbiterList.Add(pair);
                }
            }
        }
    }
}
