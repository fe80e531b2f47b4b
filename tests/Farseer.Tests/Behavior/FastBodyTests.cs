using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Bodies that move or turn by more than their own size in a step.</summary>
public class FastBodyTests
{
    private const float Dt = 1 / 60f;

    [Theory]
    [InlineData(10f)]
    [InlineData(100f)]
    [InlineData(333f)]
    [InlineData(1000f)]
    [InlineData(10000f)]
    public void Shot_AtAThinStaticWall_DoesNotPass(float speed)
    {
        for (int start = 0; start < 40; start++)
        {
            using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
            Wall(simulator, Vector2.Zero, 0.02f, 10);
            Body shot = Shot(simulator, new Vector2(-5 - (speed * Dt * (start % 20) / 20), 0), start < 20);
            shot.LinearVelocity = new Vector2(speed, 0);
            for (int i = 0; i < (10 / (speed * Dt)) + 5; i++)
            {
                simulator.Update(Dt);
                Assert.True(shot.Position.X < 0.05f, $"Start {start}: passed in step {i}.");
            }

            // It does not bounce: it lies at the wall, whose surface is at -0.01, or 0.1 before its centre.
            Assert.Equal(-0.11f, shot.Position.X, 0.002f);
        }
    }

    [Theory]
    [InlineData(100f)]
    [InlineData(10000f)]
    public void Shot_AtAnElasticWall_IsWhereItsMirroredFlightEnds(float speed)
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
        Geom wall = Wall(simulator, Vector2.Zero, 0.02f, 10);
        wall.RestitutionCoefficient = 1;
        Body shot = Shot(simulator, new Vector2(-5, 0), round: true, restitution: 1);
        shot.LinearVelocity = new Vector2(speed, 0);
        int steps = (int)(8 / (speed * Dt)) + 1;
        Sandbox.Run(simulator, steps, Dt);

        // The impact is found to 0.001 of the radius of 0.1, at which it turns back.
        double end = (2 * -0.11) - (-5 + ((double)speed * steps * Dt));
        Assert.Equal(end, shot.Position.X, 3e-4 + (1e-6 * Math.Abs(end)));
        Assert.Equal(-speed, shot.LinearVelocity.X, 1e-6f * speed);
    }

    [Theory]
    [InlineData(1000f)]
    [InlineData(10000f)]
    public void Shot_BetweenTwoElasticWalls_IsHeldByTheOneThatItFliesAwayFrom(float speed)
    {
        for (int start = 0; start < 20; start++)
        {
            using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
            Wall(simulator, new Vector2(-5, 0), 0.02f, 10).RestitutionCoefficient = 1;
            Wall(simulator, new Vector2(5, 0), 0.02f, 10).RestitutionCoefficient = 1;
            Body shot = Shot(simulator, new Vector2(-4.5f + (0.4f * start), 0), round: start % 2 == 0, restitution: 1);
            shot.LinearVelocity = new Vector2(speed, 0);
            for (int i = 0; i < 50; i++)
            {
                simulator.Update(Dt);
                Assert.InRange(shot.Position.X, -4.95f, 4.95f);
            }

            Assert.Equal(speed, Math.Abs(shot.LinearVelocity.X), 1e-4f * speed);
        }
    }

    [Fact]
    public void Swarm_ThatFallsCloserThanAStepsMotion_DoesNotFallIntoItself()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { Iterations = 4, AllowedPenetration = 0.005f };
        Wall(simulator, new Vector2(0, -0.5f), 20, 1);
        for (int i = 0; i < 200; i++)
        {
            // Each flies by 0.27 in a step and is 0.01 from the next.
            Body box = BodyFactory.Instance.CreateRectangleBody(simulator, 0.2f, 0.2f, 1);
            GeomFactory.Instance.CreateRectangleGeom(simulator, box, 0.2f, 0.2f);
            box.Position = new Vector2((i % 20 * 0.21f) - 2, 0.15f + (i / 20 * 0.21f));
            box.LinearVelocity = new Vector2(0, -16);
        }

        // Before neighbours were foreseen to be stopped, boxes lay in each other whole: 0.2 deep.
        for (int i = 0; i < 60; i++)
        {
            simulator.Update(Dt);
            Assert.InRange(simulator.LargestPenetration, 0, 0.1f);
        }
    }

    [Fact]
    public void Ball_BetweenTwoElasticWallsWithinAStep_KeepsItsSpeed()
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
        Wall(simulator, new Vector2(-2, 0), 0.1f, 10).RestitutionCoefficient = 1;
        Wall(simulator, new Vector2(2, 0), 0.1f, 10).RestitutionCoefficient = 1;
        Body shot = Shot(simulator, Vector2.Zero, round: true, restitution: 1);
        shot.LinearVelocity = new Vector2(1000, 0);
        for (int i = 0; i < 600; i++)
        {
            simulator.Update(Dt);
            Assert.InRange(shot.Position.X, -1.86f, 1.86f);
            Assert.Equal(1000, Math.Abs(shot.LinearVelocity.X), 0.01f);
        }
    }

    // What the library once got wrong: the wall, 40 clear of the way, took two thirds of the speed.
    [Fact]
    public void Ball_PassingAWall_KeepsItsVelocity()
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero);
        Wall(simulator, new Vector2(500, 0), 100, 1000);
        Body ball = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        Sandbox.WithoutDrag(ball);
        ball.Position = new Vector2(400, -2000);
        ball.LinearVelocity = new Vector2(0, 10000);
        GeomFactory.Instance.CreateCircleGeom(simulator, ball, 10, 32);
        Sandbox.Run(simulator, 40, Dt);
        Assert.Equal(new Vector2(0, 10000), ball.LinearVelocity);
    }

    // Friction 0 and restitution 0: no impact may add energy.
    [Theory]
    [InlineData(10f)]
    [InlineData(20f)]
    [InlineData(60f)]
    [InlineData(100f)]
    [InlineData(200f)]
    [InlineData(1000f)]
    public void SpinningRod_AtAWall_NeitherPassesNorGainsEnergy(float spin)
    {
        for (int start = 0; start < 8; start++)
        {
            using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
            Wall(simulator, new Vector2(0.1f, 0), 0.2f, 10);
            float inertia = 0.2f * (4 + 0.01f) / 12;
            Body rod = BodyFactory.Instance.CreateBody(simulator, 0.2f, inertia);
            Sandbox.WithoutDrag(rod);
            rod.Position = new Vector2(-1.3f, 0);
            rod.Rotation = start * MathF.PI / 8;
            rod.LinearVelocity = new Vector2(5, 0);
            rod.AngularVelocity = spin;
            Smooth(GeomFactory.Instance.CreateRectangleGeom(simulator, rod, 0.1f, 2));
            double before = Energies.Kinetic(rod);
            for (int i = 0; i < 120; i++)
            {
                simulator.Update(Dt);

                // Rounding of the float velocities.
                Assert.True(Energies.Kinetic(rod) <= before * (1 + 1e-6), $"Start {start}, step {i}: {Energies.Kinetic(rod)} of {before}.");
                Assert.True(rod.Position.X < 0, $"Start {start}: passed in step {i}.");
            }
        }
    }

    [Fact]
    public void FastBall_AtAWall_RaisesOneCollision_AndOneSeparation()
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
        Geom wall = Wall(simulator, Vector2.Zero, 0.02f, 10);
        wall.RestitutionCoefficient = 1;
        Body shot = Shot(simulator, new Vector2(-5, 0), round: true, restitution: 1);
        shot.LinearVelocity = new Vector2(500, 0);
        int collisions = 0;
        int separations = 0;
        wall.OnCollision += (_, _, contacts) =>
        {
            collisions++;
            Assert.Equal(-0.01f, contacts[0].Position.X, 1e-3f);
            return true;
        };
        wall.OnSeparation += (_, _) => separations++;
        Sandbox.Run(simulator, 10, Dt);
        Assert.Equal(1, collisions);
        Assert.Equal(1, separations);
        Assert.Equal(-500, shot.LinearVelocity.X, 0.01f);
    }

    [Fact]
    public void FastBall_AtAWallThatRefusesIt_GoesOn()
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
        Geom wall = Wall(simulator, Vector2.Zero, 0.02f, 10);
        int collisions = 0;
        wall.OnCollision += (_, _, _) =>
        {
            collisions++;
            return false;
        };
        Body shot = Shot(simulator, new Vector2(-5, 0), round: true);
        shot.LinearVelocity = new Vector2(500, 0);
        Sandbox.Run(simulator, 10, Dt);
        Assert.Equal(new Vector2(500, 0), shot.LinearVelocity);
        Assert.Equal(1, collisions);
    }

    [Fact]
    public void FastBall_ThroughASensor_IsReportedAndNotSlowed()
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
        Geom gate = Wall(simulator, Vector2.Zero, 0.02f, 10);
        gate.CollisionResponseEnabled = false;
        int collisions = 0;
        gate.OnCollision += (_, _, _) => ++collisions > 0;
        Body shot = Shot(simulator, new Vector2(-5, 0), round: true);
        shot.LinearVelocity = new Vector2(500, 0);
        Sandbox.Run(simulator, 10, Dt);
        Assert.Equal(1, collisions);
        Assert.Equal(new Vector2(500, 0), shot.LinearVelocity);
    }

    [Theory]
    [InlineData(100f)]
    [InlineData(1000f)]
    [InlineData(10000f)]
    public void Bullet_AtAThinWallThatMoves_DoesNotPass_AndTheMomentumStays(float speed)
    {
        for (int start = 0; start < 20; start++)
        {
            using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
            Body wall = Wall(simulator, Vector2.Zero, 0.02f, 2).Body;
            wall.IsStatic = false;
            wall.Mass = 40;
            wall.MomentOfInertia = 40 * 4 / 12f;
            Sandbox.WithoutDrag(wall);
            wall.LinearVelocity = new Vector2(-3, 0);
            Body shot = Shot(simulator, new Vector2(-3 - (speed * Dt * start / 20), 0), round: true);
            shot.IsBullet = true;
            shot.LinearVelocity = new Vector2(speed, 0);
            double before = speed - (40.0 * 3);
            for (int i = 0; i < (6 / (speed * Dt)) + 3; i++)
            {
                simulator.Update(Dt);
                double momentum = shot.LinearVelocity.X + (40.0 * wall.LinearVelocity.X);

                // Rounding of float velocities.
                Assert.Equal(before, momentum, 1e-6 * (speed + 120));
                Assert.True(shot.Position.X < wall.Position.X, $"Start {start}: passed in step {i}.");
            }

            Assert.Equal(shot.LinearVelocity.X, wall.LinearVelocity.X, 1e-4f * speed);
        }
    }

    // It meets the static wall behind first, comes back within the step, and the plate in front is in nobody's foresight.
    [Fact]
    public void Bullet_ComingBackFromAWallWithinAStep_DoesNotPassAPlateThatCanMove()
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
        Wall(simulator, new Vector2(2, 0), 0.1f, 10).RestitutionCoefficient = 1;
        Body plate = Wall(simulator, new Vector2(-1, 0), 0.02f, 2).Body;
        plate.IsStatic = false;
        Body shot = Shot(simulator, Vector2.Zero, round: true, restitution: 1);
        shot.IsBullet = true;
        shot.LinearVelocity = new Vector2(600, 0);
        for (int i = 0; i < 5; i++)
        {
            simulator.Update(Dt);
            Assert.True(shot.Position.X > plate.Position.X, $"Passed in step {i}.");
        }
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void FastBall_NotLookedAfter_PassesAThinWall(bool forAll)
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 1e-5f };
        Wall(simulator, Vector2.Zero, 0.02f, 10);
        Body shot = Shot(simulator, new Vector2(-5, 0), round: true);
        shot.LinearVelocity = new Vector2(500, 0);
        simulator.IsContinuousCollisionEnabled = !forAll;
        shot.IsContinuousCollisionEnabled = forAll;
        Sandbox.Run(simulator, 3, Dt);
        Assert.Equal(20, shot.Position.X, 1e-3f);
    }

    [Fact]
    public void Pyramid_HitByABullet_StaysFinite_AndNothingPassesTheFloor()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = 0.005f };
        Wall(simulator, new Vector2(0, -0.5f), 200, 1).FrictionCoefficient = 0.6f;
        for (int row = 0; row < 8; row++)
        {
            for (int i = 0; i < 8 - row; i++)
            {
                Body box = BodyFactory.Instance.CreateBody(simulator, 1, 1 / 6f);
                box.Position = new Vector2(i - 3.5f + (row * 0.5f), row + 0.5f);
                GeomFactory.Instance.CreateRectangleGeom(simulator, box, 1, 1).FrictionCoefficient = 0.6f;
            }
        }

        Body shot = Shot(simulator, new Vector2(-50, 2.3f), round: true);
        shot.IsBullet = true;
        shot.Mass = 20;
        shot.LinearVelocity = new Vector2(3000, -20);
        for (int i = 0; i < 300; i++)
        {
            simulator.Update(Dt);
            foreach (Body body in simulator.BodyList)
            {
                Assert.False(body.IsQuarantined);
                Assert.True(body.IsStatic || body.Position.Y > -0.1f || Math.Abs(body.Position.X) > 100, $"Through the floor in step {i}.");
            }
        }
    }

    [Fact]
    public void FastBall_InAScaledWorld_GoesTheSameWayBitForBit()
    {
        Assert.Equal(Bounces(1), Bounces(1024));
    }

    private static double[] Bounces(float scale)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10 * scale)) { AllowedPenetration = 1e-3f * scale };
        foreach (Vector2 place in new[] { new Vector2(-3, 0), new Vector2(3, 0), new Vector2(0, -3), new Vector2(0, 3) })
        {
            bool side = place.Y == 0;
            Wall(simulator, place * scale, (side ? 0.1f : 6) * scale, (side ? 6 : 0.1f) * scale).RestitutionCoefficient = 0.9f;
        }

        Body rod = BodyFactory.Instance.CreateBody(simulator, 1, 0.2f * scale * scale);
        Sandbox.WithoutDrag(rod);
        rod.LinearVelocity = new Vector2(150, 70) * scale;
        rod.AngularVelocity = 90;
        GeomFactory.Instance.CreateRectangleGeom(simulator, rod, 0.2f * scale, 1.2f * scale);
        var states = new double[120];
        for (int i = 0; i < 120; i++)
        {
            simulator.Update(Dt);
            states[i] = (i & 1) == 0 ? rod.Position.X / scale : rod.TotalRotation;
            Assert.InRange(Math.Abs(rod.Position.X) / scale, 0, 3);
            Assert.InRange(Math.Abs(rod.Position.Y) / scale, 0, 3);
        }

        return states;
    }

    private static Geom Wall(PhysicsSimulator simulator, Vector2 place, float width, float height)
    {
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        body.IsStatic = true;
        body.Position = place;
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height);
        Smooth(geom);
        return geom;
    }

    private static Body Shot(PhysicsSimulator simulator, Vector2 place, bool round, float restitution = 0)
    {
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 0.005f);
        Sandbox.WithoutDrag(body);
        body.Position = place;
        Geom geom = round
            ? GeomFactory.Instance.CreateCircleGeom(simulator, body, 0.1f, 32)
            : GeomFactory.Instance.CreateRectangleGeom(simulator, body, 0.2f, 0.2f);
        Smooth(geom);
        geom.RestitutionCoefficient = restitution;
        return body;
    }

    private static void Smooth(Geom geom)
    {
        geom.FrictionCoefficient = 0;
        geom.RestitutionCoefficient = 0;
    }
}
