using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Interfaces;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>The broad phases differ in speed only, and a user can bring one along.</summary>
public class BroadPhaseAgreementTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [ManualRow("F224")]
    [ManualRow("F227")]
    public void Pile_OnEveryBroadPhase_GoesTheSameWayBitForBit(int seed)
    {
        var piles = new[]
        {
            new RandomPile(seed, 50, 1),
            new RandomPile(seed, 50, 1, simulator => new SelectiveSweepCollider(simulator)),
            new RandomPile(seed, 50, 1, simulator => new SweepAndPruneCollider(simulator)),
            new RandomPile(seed, 50, 1, simulator => new BruteForceCollider(simulator)),
            new RandomPile(seed, 50, 1, simulator => new GridCollider(simulator)),
        };
        for (int i = 0; i < 40; i++)
        {
            foreach (RandomPile pile in piles)
            {
                Sandbox.Run(pile.Simulator, 10);
                Assert.Equal(piles[0].State(), pile.State());
            }
        }

        Assert.True(piles[0].Simulator.ArbiterList.Count > 50, "The scene was to become a pile.");
    }

    [Fact]
    public void UsersCollider_FindsPairs_ThatCollideLikeThoseOfTheLibrary()
    {
        var own = new RandomPile(4, 20, 1, simulator => new BandCollider(simulator, 40));
        var library = new RandomPile(4, 20, 1);
        var collider = (BandCollider)own.Simulator.BroadPhaseCollider;
        Sandbox.Run(own.Simulator, 400);
        Sandbox.Run(library.Simulator, 400);
        Assert.Equal(own.Simulator.GeomList.Count, collider.Taken);

        // The pile lies in its box, nothing sank into the floor or left through a wall.
        Assert.All(own.Bodies, body => Assert.InRange(body.Position.Y, -240, 0));
        Assert.All(own.Bodies, body => Assert.InRange(body.Position.X, -100, 100));
        Assert.True(own.Simulator.ArbiterList.Count > 15);
        Assert.True(library.Simulator.ArbiterList.Count > 15);
    }

    [Fact]
    public void UsersCollider_CollidesOnlyWhatItFinds_RaisesItsEventAndHearsOfRemovals()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        var collider = new BandCollider(simulator, 30);
        simulator.BroadPhaseCollider = collider;
        Assert.Same(collider, simulator.BroadPhaseCollider);
        Geom floor = Sandbox.Floor(simulator);
        Geom wanted = Sandbox.Box(simulator, new System.Numerics.Vector2(-50, -15));
        Geom refused = Sandbox.Box(simulator, new System.Numerics.Vector2(50, -15));
        int collisions = 0;
        int separations = 0;
        wanted.OnCollision += (_, _, _) => ++collisions > 0;
        wanted.OnSeparation += (_, _) => separations++;
        collider.OnBroadPhaseCollision += (a, b) => a != refused && b != refused;
        Sandbox.Run(simulator, 100);
        Assert.InRange(wanted.Body.Position.Y, -10.01f, -9.9f);
        Assert.True(refused.Body.Position.Y > 20);
        Assert.InRange(collisions, 50, 100);
        Assert.Equal(0, separations);
        Arbiter arbiter = Assert.Single(simulator.ArbiterList);
        Assert.Same(floor, arbiter.GeomA);
        Assert.Same(wanted, arbiter.GeomB);
        Assert.Equal(2, arbiter.ContactList.Count);
        Assert.Equal(3, collider.Taken);
        Assert.Equal(0, collider.RemovedCalls);
        simulator.Remove(floor);
        Sandbox.Run(simulator, 1);
        Assert.True(collider.RemovedCalls > 0);
        Assert.Equal(1, separations);
        wanted.Dispose();
        Sandbox.Run(simulator, 1);
        Assert.True(collider.DisposedCalls > 0);
        Assert.Same(refused, Assert.Single(simulator.GeomList));
    }

    /// <summary>A user's broad phase: pairs of geoms whose centres' distance along x leaves their boxes a chance, in bands.</summary>
    private sealed class BandCollider : IBroadPhaseCollider
    {
        private readonly PhysicsSimulator _simulator;
        private readonly float _slack;

        public BandCollider(PhysicsSimulator simulator, float slack)
        {
            _simulator = simulator;
            _slack = slack;
        }

        public event BroadPhaseCollisionHandler? OnBroadPhaseCollision;

        public int Taken { get; private set; }

        public int RemovedCalls { get; private set; }

        public int DisposedCalls { get; private set; }

        public void Add(Geom geom) => Taken++;

        public void ProcessDisposedGeoms() => DisposedCalls++;

        public void ProcessRemovedGeoms() => RemovedCalls++;

        public void Update()
        {
            var sorted = new List<Geom>(_simulator.GeomList);
            sorted.Sort((a, b) => a.AABB.Min.X.CompareTo(b.AABB.Min.X));
            for (int i = 0; i < sorted.Count; i++)
            {
                for (int j = i + 1; j < sorted.Count && sorted[j].AABB.Min.X <= sorted[i].AABB.Max.X + _slack; j++)
                {
                    bool inOrder = sorted[i] < sorted[j];
                    var pair = new Arbiter { GeomA = sorted[inOrder ? i : j], GeomB = sorted[inOrder ? j : i] };
                    if (!_simulator.ArbiterList.Contains(pair) && OnBroadPhaseCollision?.Invoke(pair.GeomA, pair.GeomB) != false)
                    {
                        _simulator.ArbiterList.Add(pair);
                    }
                }
            }
        }
    }
}
