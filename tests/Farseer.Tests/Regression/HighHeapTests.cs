using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// A heap of many levels that begins in itself, in a bin. Where only contacts that are deep themselves were pushed apart without speed, not
/// all of their island, the others answered what these pushed into them by speeds that added up level by level: the heap was thrown up by
/// 29 m, at 20 m/s.
/// </summary>
public class HighHeapTests
{
    private const int Columns = 60;
    private const int Rows = 40;
    private const float Size = 0.7f;
    private const float Spacing = 0.5f;
    private const float Gravity = 10;

    /// <summary>How far its centre rises until no body is in another: they take the area that they have.</summary>
    private const float Rise = 7;

    [Fact]
    public void Heap_OfFortyLevelsInEachOther_RisesWithoutSpeed()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -Gravity)) { Iterations = 4 };
        List<Body> bodies = Fill(simulator, 1);
        float start = bodies.Average(body => body.Position.Y);
        float fastest = 0;
        for (int step = 0; step < 240; step++)
        {
            simulator.Update(1 / 60f);
            fastest = Math.Max(fastest, bodies.Max(body => body.LinearVelocity.Length()));
        }

        // What rides on the heap falls through gaps that open below it: no faster than a fall of all that the heap rises. Thrown up they
        // went at 20.
        Assert.InRange(fastest, 0, Fall(Rise));

        // With the area of the bodies 7 m are to come, and no more. Where sweeps forgot what they had pushed it had risen by 0.9 by then;
        // now it has by 6.1.
        Assert.InRange(bodies.Average(body => body.Position.Y) - start, 5, Rise);
    }

    [Theory]
    [InlineData(1e-9f)]
    [InlineData(1e-4f)]
    [InlineData(1 / 240f)]
    public void Heap_AfterAShortFirstStep_RisesAsWithoutIt(float first)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -Gravity)) { Iterations = 4 };
        List<Body> bodies = Fill(simulator, 1);
        float start = bodies.Average(body => body.Position.Y);
        simulator.Update(first);
        float fastest = 0;
        for (int step = 0; step < 20; step++)
        {
            simulator.Update(1 / 60f);
            fastest = Math.Max(fastest, bodies.Max(body => body.LinearVelocity.Length()));
        }

        // What a body is pushed by is a way: kept as a speed, that of a step of a nanosecond threw bodies off at 200 km/s in the next
        // steps.
        Assert.InRange(fastest, 0, Fall(3));
        Assert.InRange(bodies.Average(body => body.Position.Y) - start, 1, 3);
    }

    [Fact]
    public void Heap_OfTwentyLevelsInEachOther_ComesApartWithinTwoSeconds()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -Gravity)) { Iterations = 4 };
        List<Body> bodies = Fill(simulator, 2);
        for (int step = 0; step < 120; step++)
        {
            simulator.Update(1 / 60f);
        }

        // Bodies that rest in each other by the allowed depth have their centres 0.65 apart, and began 0.5 apart; 34 are nearer than at the
        // start, and were 613 where sweeps forgot.
        Assert.InRange(bodies.Count(body => IsCrowded(body, bodies)), 0, 60);
    }

    private static float Fall(float height) => MathF.Sqrt(2 * Gravity * height);

    private static bool IsCrowded(Body body, List<Body> bodies) =>
        bodies.Exists(other => other != body && (other.Position - body.Position).LengthSquared() < 0.5f * 0.5f);

    private static List<Body> Fill(PhysicsSimulator simulator, int share)
    {
        Fence(simulator, new Vector2(15, -1), 60, 2);
        Fence(simulator, new Vector2(-1.5f, 50), 2, 120);
        Fence(simulator, new Vector2(31, 50), 2, 120);
        var bodies = new List<Body>();
        for (int i = 0; i < Columns * Rows / share; i++)
        {
            var place = new Vector2(Spacing * (i % Columns), 0.5f + (Spacing * (i / Columns)));
            Geom geom = i % 2 == 0 ? Sandbox.Box(simulator, place, Size, Size) : Sandbox.Ball(simulator, place, Size / 2);
            geom.FrictionCoefficient = 0.1f;
            bodies.Add(geom.Body);
        }

        return bodies;
    }

    private static void Fence(PhysicsSimulator simulator, Vector2 place, float width, float height) =>
        Sandbox.Box(simulator, place, width, height).Body.IsStatic = true;
}
