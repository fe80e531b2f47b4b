using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// What is struck by a third body in a step meets what lies beside it in the same step. The pair beside it had no row, for nothing
/// moved there when the step began, and was found overlapping by up to the whole way of the blow.
/// </summary>
public class StruckNeighbourTests
{
    /// <summary>What an inelastic blow through two boxes of side 1 may leave; 0.09 and 0.12 it was.</summary>
    private const double Most = 1e-3;

    // The striker moves by a third of a side in a step, a twentieth of it before the impact.
    [Theory]
    [InlineData(1f, 0.025f)]
    [InlineData(1f, 0.05f)]
    [InlineData(0.2f, 0.025f)]
    [InlineData(0.2f, 0.05f)]
    public void Box_StruckTowardsAWallNearBy_IsNotFoundInTheWall(float striker, float gap)
    {
        using PhysicsSimulator simulator = Space();
        Add(simulator, new Vector2(1 + gap, 0), 1, 1, 1, 0).Body.IsStatic = true;
        Add(simulator, Vector2.Zero, 1, 1, 1, 0);
        Body ball = Add(simulator, new Vector2(-0.55f - (0.5f * striker), 0), striker, striker, 1, 0).Body;
        ball.LinearVelocity = new Vector2(20, 0);
        Assert.InRange(DeepestOf(simulator, 20), 0, Most);
    }

    // One end rests on a block, the other is 0.03 above a second one and is struck there: the point of the first block alone was known.
    [Theory]
    [InlineData(0.01f)]
    [InlineData(0.03f)]
    public void Plank_StruckAtItsLooseEnd_IsNotFoundInWhatLiesUnderIt(float gap)
    {
        using PhysicsSimulator simulator = Space();
        float angle = (float)Math.Asin(gap / 1.8);
        Add(simulator, new Vector2(0, -0.6f), 2, 1, 1, 0).Body.IsStatic = true;
        Add(simulator, new Vector2(0, (float)(Math.Sin(angle) + (0.1 * Math.Cos(angle)) - 0.1f)), 2, 0.2f, 0.4f, angle);
        Body ball = Add(simulator, new Vector2(0.85f, 0.3f + (float)(1.9 * Math.Sin(angle))), 0.2f, 0.2f, 1, 0).Body;
        ball.LinearVelocity = new Vector2(0, -8);

        // The blow turns the plank by a tenth of a radian within the step, and the arms are those foreseen before it; 0.021 and 0.053 it
        // was.
        Assert.InRange(DeepestOf(simulator, 20), 0, 0.01);
    }

    // It was left to the search along its own way, on which it meets nothing: up to 0.1 of the 0.13 that the blow moves it in a step.
    [Fact]
    public void Rod_FlyingFastAlongABar_StruckTowardsIt_IsNotFoundInIt()
    {
        var random = new Random(1);
        for (int i = 0; i < 100; i++)
        {
            using PhysicsSimulator simulator = Space();
            Add(simulator, new Vector2(10, -0.5f), 40, 1, 1000, 0);
            float gap = 0.01f + (0.04f * random.NextSingle());
            float speed = 15 + (15 * random.NextSingle());
            Body rod = Add(simulator, new Vector2(0, gap + 0.1f), 2, 0.2f, 1, 0).Body;
            rod.LinearVelocity = new Vector2(speed, 0);
            float place = random.NextSingle() - 0.5f;
            Body striker = Add(simulator, new Vector2(place, gap + 0.31f + (0.3f * random.NextSingle())), 0.2f, 0.2f, 1, 0).Body;
            striker.LinearVelocity = new Vector2(speed, -8);

            // The rod turns within the step, and arms are those foreseen before it.
            Assert.InRange(DeepestOf(simulator, 10), 0, 0.012);
        }
    }

    private static PhysicsSimulator Space() =>
        new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 0, EnableReport = true };

    private static Geom Add(PhysicsSimulator simulator, Vector2 position, float width, float height, float mass, float angle)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, mass);
        body.Position = position;
        body.Rotation = angle;
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height);
        geom.RestitutionCoefficient = 0;
        return geom;
    }

    private static double DeepestOf(PhysicsSimulator simulator, int steps)
    {
        double deepest = 0;
        for (int i = 0; i < steps; i++)
        {
            simulator.Update(1f / 60);
            deepest = Math.Max(deepest, simulator.Report.LargestPenetration);
        }

        return deepest;
    }
}
