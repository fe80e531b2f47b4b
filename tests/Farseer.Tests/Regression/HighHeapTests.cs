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
/// A heap of many levels that begins in itself, in a bin. Where only contacts that are deep themselves were pushed apart without speed, not all of their island, the others
/// answered what these pushed into them by speeds that added up level by level: the heap was thrown up by 29 m, at 20 m/s.
/// </summary>
public class HighHeapTests
{
    private const int Columns = 60;
    private const int Rows = 40;
    private const float Size = 0.7f;
    private const float Spacing = 0.5f;

    [Fact]
    public void Heap_OfFortyLevelsInEachOther_RisesWithoutSpeed()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { Iterations = 4 };
        Fence(simulator, new Vector2(15, -1), 60, 2);
        Fence(simulator, new Vector2(-1.5f, 50), 2, 120);
        Fence(simulator, new Vector2(31, 50), 2, 120);
        var bodies = new List<Body>();
        for (int i = 0; i < Columns * Rows; i++)
        {
            var place = new Vector2(Spacing * (i % Columns), 0.5f + (Spacing * (i / Columns)));
            Geom geom = i % 2 == 0 ? Sandbox.Box(simulator, place, Size, Size) : Sandbox.Ball(simulator, place, Size / 2);
            geom.FrictionCoefficient = 0.1f;
            bodies.Add(geom.Body);
        }

        float start = bodies.Average(body => body.Position.Y);
        float fastest = 0;
        for (int step = 0; step < 120; step++)
        {
            simulator.Update(1 / 60f);
            fastest = Math.Max(fastest, bodies.Max(body => body.LinearVelocity.Length()));
        }

        // The bound of a tower that begins in itself; it is 1.4 here.
        Assert.InRange(fastest, 0, 3);

        // It reaches 0.43, with the area of the bodies 7 m are to come: slow, but no level sinks meanwhile.
        Assert.InRange(bodies.Average(body => body.Position.Y) - start, 0.3f, 7);
    }

    private static void Fence(PhysicsSimulator simulator, Vector2 place, float width, float height) =>
        Sandbox.Box(simulator, place, width, height).Body.IsStatic = true;
}
