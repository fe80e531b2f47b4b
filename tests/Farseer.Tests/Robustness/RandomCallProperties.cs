using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>Whatever is called in whatever order with whatever numbers: the world stays one of numbers, and steps.</summary>
public class RandomCallProperties
{
    private const int Sequences = 1000;

    private static readonly float[] _numbers =
    {
        0, 1, -1, 0.5f, 10, -30, 100, 1e4f, 1e-4f, float.NaN, float.PositiveInfinity, float.NegativeInfinity, float.MaxValue, float.MinValue,
        float.Epsilon, 1e-30f, 1e-20f, 1e10f, -1e18f, 1e25f,
    };

    private static readonly Action<Play>[] _moves =
    {
        p => p.Body.Mass = p.Number(),
        p => p.Body.MomentOfInertia = p.Number(),
        p => p.Body.Position = p.Point(),
        p => p.Body.SetPosition(p.Number(), p.Number()),
        p => p.Body.Rotation = p.Number(),
        p => p.Body.LinearVelocity = p.Point(),
        p => p.Body.AngularVelocity = p.Number(),
        p => p.Body.LinearDragCoefficient = p.Number(),
        p => p.Body.RotationalDragCoefficient = p.Number(),
        p => p.Body.QuadraticDragCoefficient = p.Number(),
        p => p.Body.IsQuadraticDragEnabled = p.Flag(),
        p => p.Body.ApplyForce(p.Point()),
        p => p.Body.ApplyForceAtLocalPoint(p.Point(), p.Point()),
        p => p.Body.ApplyForceAtWorldPoint(p.Point(), p.Point()),
        p => p.Body.ApplyTorque(p.Number()),
        p => p.Body.ApplyImpulse(p.Point()),
        p => p.Body.ApplyAngularImpulse(p.Number()),
        p => p.Body.ResetDynamics(),
        p => p.Body.IsStatic = p.Flag(),
        p => p.Body.IsKinematic = p.Flag(),
        p => p.Body.IsBullet = p.Flag(),
        p => p.Body.IsContinuousCollisionEnabled = p.Flag(),
        p => p.Body.IterationFactor = p.Pick(20) - 2,
        p => p.Body.Enabled = p.Flag(),
        p => p.Body.Enabled = true,
        p => p.Geom.FrictionCoefficient = p.Number(),
        p => p.Geom.RestitutionCoefficient = p.Number(),
        p => p.Geom.IsSensor = p.Flag(),
        p => p.Geom.CollisionEnabled = p.Flag(),
        p => p.Geom.CollisionGridCellSize = p.Number(),
        p => p.Geom.SetVertices(p.Outline()),
        p => p.Geom.SetBody(p.Body),
        p => p.Simulator.Gravity = p.Point(),
        p => p.Simulator.Iterations = p.Pick(20) - 2,
        p => p.Simulator.AdaptIterations = p.Flag(),
        p => p.Simulator.AllowedPenetration = p.Number(),
        p => p.Simulator.BiasFactor = p.Number(),
        p => p.Simulator.FrictionType = (FrictionType)(p.Pick(4) - 1),
        p => p.Simulator.Quirks = (Farseer201Quirks)p.Pick(16384),
        p => p.Simulator.Update(p.Number()),
        p => p.Simulator.Add(p.Body),
        p => p.Simulator.Add(p.Geom),
        p => p.Simulator.Remove(p.Body),
        p => p.Simulator.Remove(p.Geom),
        p => p.Simulator.Add((Body)null!),
        p => p.Body.Dispose(),
        p => p.Geom.Dispose(),
        p => p.Simulator.Clear(),
        p => p.Simulator.BroadPhaseCollider = p.Collider(),
        p => p.Simulator.Collide(p.Point()),
        p => p.Simulator.ArbiterList.Clear(),
        p => p.Remember(BodyFactory.Instance.CreateRectangleBody(p.Simulator, p.Number(), p.Number(), p.Number())),
        p => p.Remember(BodyFactory.Instance.CreatePolygonBody(p.Simulator, p.Outline(), p.Number())),
        p => p.Remember(GeomFactory.Instance.CreateRectangleGeom(p.Simulator, p.Body, p.Number(), p.Number())),
        p => p.Remember(GeomFactory.Instance.CreateCircleGeom(p.Simulator, p.Body, p.Number(), p.Pick(20), p.Point(), p.Number())),
        p => p.Remember(GeomFactory.Instance.CreateCapsuleGeom(p.Simulator, p.Body, p.Point(), p.Point(), p.Number())),
        p => p.Remember(GeomFactory.Instance.CreateSegmentGeom(p.Simulator, p.Body, p.Point(), p.Point())),
        p => p.Remember(GeomFactory.Instance.CreateChainGeom(p.Simulator, p.Body, p.Outline(), p.Flag())),
        p => p.Remember(new Geom(p.Body, p.Outline(), p.Point(), p.Number(), p.Number())),
    };

    [Fact]
    public void AnySequenceOfCalls_LeavesAWorldOfNumbers()
    {
        Prop.ForAll(ArbMap.Default.ArbFor<DoNotSize<int>[]>(), Survives)
            .Check(Config.QuickThrowOnFailure.WithMaxTest(Sequences).WithEndSize(30).WithReplay(20081, 2009));
    }

    /// <summary>Each number chooses a call and seeds its arguments, so that a failure shrinks to the calls that matter.</summary>
    private static bool Survives(DoNotSize<int>[] seeds)
    {
        var play = new Play();
        foreach (DoNotSize<int> seed in seeds)
        {
            play.Seed(seed.Item);
            Action<Play> move = _moves[play.Pick(_moves.Length)];
            try
            {
                move(play);
            }
            catch (Exception refusal) when (refusal is ArgumentException or InvalidOperationException)
            {
                // A refusal; ObjectDisposedException is one of the second kind.
            }

            play.Simulator.Update(0.01f);
            AssertSound(play.Simulator);
        }

        // A plain body in a new place lives on, whatever has been done to the others.
        PhysicsSimulator simulator = play.Simulator;
        simulator.Gravity = new Vector2(0, 10);
        Body fresh = BodyFactory.Instance.CreateCircleBody(simulator, 1, 1);
        fresh.Position = new Vector2(12345, 777);
        for (int i = 0; i < 3; i++)
        {
            simulator.Update(0.01f);
        }

        AssertSound(simulator);
        Assert.False(fresh.IsQuarantined);
        Assert.InRange(fresh.LinearVelocity.Y, 0.29f, 0.31f);
        return true;
    }

    private static void AssertSound(PhysicsSimulator simulator)
    {
        foreach (Body body in simulator.BodyList)
        {
            if (!body.Enabled)
            {
                // Nobody looks at its velocity before it is enabled.
                Assert.True(float.IsFinite(body.Position.X + body.Position.Y + body.Rotation));
                continue;
            }

            float sum = body.Position.X + body.Position.Y + body.Rotation + body.LinearVelocity.X + body.LinearVelocity.Y + body.AngularVelocity;
            Assert.True(float.IsFinite(sum), "not a number: " + body.Position + " " + body.Rotation + " " + body.LinearVelocity + " " + body.AngularVelocity);
        }

        Assert.All(simulator.GeomList, g => Assert.NotNull(g.Body));
        Assert.False(float.IsNaN(simulator.LargestPenetration));
        _ = simulator.StateHash();
    }

    /// <summary>A scene of a few things, and a source of arguments.</summary>
    private sealed class Play
    {
        private readonly List<Body> _bodies = new List<Body>();
        private readonly List<Geom> _geoms = new List<Geom>();
        private uint _state = 1;

        public Play()
        {
            for (int i = 0; i < 3; i++)
            {
                Body body = BodyFactory.Instance.CreateRectangleBody(Simulator, 10, 10, 1);
                body.Position = new Vector2(0, -10 * i);
                body.IsStatic = i == 0;
                _bodies.Add(body);
                _geoms.Add(GeomFactory.Instance.CreateRectangleGeom(Simulator, body, 10, 10));
            }
        }

        public PhysicsSimulator Simulator { get; } = new PhysicsSimulator(new Vector2(0, 50));

        public Body Body => _bodies[Pick(_bodies.Count)];

        public Geom Geom => _geoms[Pick(_geoms.Count)];

        public void Seed(int seed) => _state = ((uint)seed * 2654435761u) ^ 0x9E3779B9u;

        public void Remember(Body body) => _bodies.Add(body);

        public void Remember(Geom geom) => _geoms.Add(geom);

        public int Pick(int count)
        {
            _state = (_state * 1664525u) + 1013904223u;
            return (int)((_state >> 8) % (uint)count);
        }

        public bool Flag() => Pick(2) == 1;

        /// <summary>Every other number is an ordinary one: with wild ones alone nothing but refusals would be tried.</summary>
        public float Number() => Flag() ? (Pick(400) - 100) * 0.1f : _numbers[Pick(_numbers.Length)];

        public Vector2 Point() => new Vector2(Number(), Number());

        public Vertices Outline()
        {
            var outline = new Vertices();
            int count = Pick(7);
            for (int i = 0; i < count; i++)
            {
                outline.Add(Pick(10) == 0 ? Point() : new Vector2(Pick(20) - 10, Pick(20) - 10));
            }

            return outline;
        }

        public IBroadPhaseCollider Collider() => Pick(4) switch
        {
            0 => new GridCollider(Simulator),
            1 => new SweepAndPruneCollider(Simulator),
            2 => new BruteForceCollider(Simulator),
            _ => new SelectiveSweepCollider(Simulator),
        };
    }
}
