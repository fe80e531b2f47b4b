using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Interfaces;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>The manual's chapter "Broad phase".</summary>
public class BroadPhaseTests
{
    public static TheoryData<Type> Colliders() => new()
    {
        typeof(SweepAndPruneCollider),
        typeof(SelectiveSweepCollider),
        typeof(BruteForceCollider),
        typeof(GridCollider),
    };

    [Theory]
    [MemberData(nameof(Colliders))]
    [ManualRow("F223")]
    [ManualRow("F224")]
    [ManualRow("F225")]
    public void Collider_TellsOfEachOverlappingPairOnce_TheOlderGeomFirst(Type type)
    {
        var simulator = new PhysicsSimulator();
        IBroadPhaseCollider collider = Use(simulator, type);
        var random = new Random(5);
        var geoms = new List<Geom>();
        for (int i = 0; i < 60; i++)
        {
            // Whole multiples of 10, sides of 19: boxes overlap by at least 9 or are at least 1 apart.
            var place = new Vector2(10 * random.Next(10), 10 * random.Next(10));
            geoms.Add(Sandbox.Box(simulator, place, 19, 19));
        }

        var told = new List<(Geom First, Geom Second)>();
        collider.OnBroadPhaseCollision += (first, second) =>
        {
            told.Add((first, second));
            return false;
        };
        simulator.Update(0.001f);
        var wanted = new HashSet<(Geom, Geom)>();
        for (int i = 0; i < geoms.Count; i++)
        {
            for (int j = i + 1; j < geoms.Count; j++)
            {
                if (AABB.Intersect(geoms[i].AABB, geoms[j].AABB))
                {
                    wanted.Add((geoms[i], geoms[j]));
                }
            }
        }

        Assert.True(wanted.Count > 100);
        Assert.Equal(told.Count, told.Distinct().Count());
        Assert.All(told, pair => Assert.True(pair.First < pair.Second));
        Assert.Subset(told.ToHashSet(), wanted);

        // The boxes of the broad phase may be a share of the size wider, no more: half of it is a generous bound.
        Assert.All(told, pair => Assert.True(Vector2.Distance(pair.First.Position, pair.Second.Position) < 19 * 1.5f * MathF.Sqrt(2)));
        Assert.Empty(simulator.ArbiterList);
    }

    [Fact]
    [ManualRow("F226")]
    [ManualRow("F229")]
    public void BroadPhaseCollider_ByDefault_IsSelectiveSweep()
    {
        var simulator = new PhysicsSimulator();
        Assert.IsType<SelectiveSweepCollider>(simulator.BroadPhaseCollider);
        Assert.Same(simulator.BroadPhaseCollider, simulator.BroadPhaseCollider);
        int heard = 0;
        simulator.BroadPhaseCollider.OnBroadPhaseCollision += (_, _) => ++heard > 0;
        Sandbox.Box(simulator, Vector2.Zero);
        Sandbox.Box(simulator, new Vector2(10, 0));
        simulator.Update(0.01f);
        Assert.Equal(1, heard);
        Assert.Single(simulator.ArbiterList);
    }

    [Fact]
    [ManualRow("F227")]
    [ManualRow("F229")]
    public void BroadPhaseCollider_CanBeSwapped_OnlyWhileThereAreNoGeoms()
    {
        var simulator = new PhysicsSimulator();
        foreach (IBroadPhaseCollider next in new IBroadPhaseCollider[]
        {
            new BruteForceCollider(simulator), new SweepAndPruneCollider(simulator), new GridCollider(simulator),
            new SelectiveSweepCollider(simulator),
        })
        {
            simulator.BroadPhaseCollider = next;
            Assert.Same(next, simulator.BroadPhaseCollider);
            Geom geom = Sandbox.Box(simulator, Vector2.Zero);

            // Waiting to be taken in, taken in, waiting to be let go: all are geoms in use.
            Assert.Throws<InvalidOperationException>(() => simulator.BroadPhaseCollider = new BruteForceCollider(simulator));
            simulator.Update(0.01f);
            Assert.Throws<InvalidOperationException>(() => simulator.BroadPhaseCollider = new BruteForceCollider(simulator));
            simulator.Remove(geom);
            Assert.Throws<InvalidOperationException>(() => simulator.BroadPhaseCollider = new BruteForceCollider(simulator));
            simulator.Update(0.01f);
            Assert.Same(next, simulator.BroadPhaseCollider);
        }

        Assert.Throws<ArgumentNullException>(() => simulator.BroadPhaseCollider = null!);
        Assert.Throws<ArgumentException>(() => simulator.BroadPhaseCollider = new BruteForceCollider(new PhysicsSimulator()));
        Assert.IsType<SelectiveSweepCollider>(simulator.BroadPhaseCollider);
        Assert.Throws<ArgumentNullException>(() => new BruteForceCollider(null!));
    }

    [Theory]
    [MemberData(nameof(Colliders))]
    [ManualRow("F228")]
    public void Teleport_AcrossTheWorld_IsFoundByEveryCollider(Type type)
    {
        // The manual's limit of sweep and prune is gone: what is teleported collides in the next update.
        var simulator = new PhysicsSimulator();
        Use(simulator, type);
        for (int i = 0; i < 20; i++)
        {
            Sandbox.Box(simulator, new Vector2(1000 * i, 0)).Body.IsStatic = true;
        }

        Geom ball = Sandbox.Ball(simulator, new Vector2(-5000, 5000));
        simulator.Update(0.01f);
        Assert.Empty(simulator.ArbiterList);
        for (int i = 19; i >= 0; i -= 3)
        {
            ball.Body.Position = new Vector2(1000 * i, -14);
            ball.Body.LinearVelocity = Vector2.Zero;
            simulator.Update(0.01f);
            Assert.Equal(new Vector2(1000 * i, 0), Assert.Single(simulator.ArbiterList).GeomA.Position);
            Assert.Same(ball, simulator.ArbiterList[0].GeomB);
        }

        ball.Body.Position = new Vector2(0, 5000);
        simulator.Update(0.01f);
        Assert.Empty(simulator.ArbiterList);
    }

    [Theory]
    [MemberData(nameof(Colliders))]
    public void Handler_ThatRefusesAPair_LeavesItOut(Type type)
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        IBroadPhaseCollider collider = Use(simulator, type);
        Geom floor = Sandbox.Floor(simulator);
        Geom refused = Sandbox.Box(simulator, new Vector2(-50, -15));
        Geom wanted = Sandbox.Box(simulator, new Vector2(50, -15));
        int events = 0;
        refused.OnCollision += (_, _, _) => ++events > 0;
        collider.OnBroadPhaseCollision += (first, second) => first != floor || second != refused;
        Sandbox.Run(simulator, 100);
        Assert.True(refused.Body.Position.Y > 20);
        Assert.InRange(wanted.Body.Position.Y, -10.01f, -9.9f);
        Assert.Equal(0, events);
    }

    /// <summary>
    /// In a crowd, whose boxes are all new in each step: a pair whose boxes have overlapped for long is found only because it was refused.
    /// </summary>
    [Theory]
    [MemberData(nameof(Colliders))]
    public void Handler_ThatRefusedPairs_IsAskedAgainWhileTheirBoxesOverlap(Type type)
    {
        var simulator = new PhysicsSimulator();
        IBroadPhaseCollider collider = Use(simulator, type);
        for (int i = 0; i < 80; i++)
        {
            Sandbox.Box(simulator, new Vector2(100 * i, 0)).Body.LinearVelocity = new Vector2(0, 300);
            Sandbox.Box(simulator, new Vector2((100 * i) + 19, 0)).Body.LinearVelocity = new Vector2(0, 300);
        }

        bool refuse = true;
        collider.OnBroadPhaseCollision += (_, _) => !refuse;
        Sandbox.Run(simulator, 10);
        Assert.Empty(simulator.ArbiterList);
        refuse = false;
        Sandbox.Run(simulator, 10);
        Assert.Equal(80, simulator.ArbiterList.Count);
    }

    private static IBroadPhaseCollider Use(PhysicsSimulator simulator, Type type)
    {
        var collider = (IBroadPhaseCollider)Activator.CreateInstance(type, simulator)!;
        simulator.BroadPhaseCollider = collider;
        return collider;
    }
}
