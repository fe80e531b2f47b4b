using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Random heaps of bodies of about a metre in a bin, at the default settings.</summary>
public class HeapSleepTests
{
    private const float Dt = 1 / 60f;

    private const int Heaps = 32;

    // With five substeps the loads of such a heap go to and fro at the limit of friction: a quarter of those of 144 bodies did not sleep
    // within a minute. When the last body of a heap comes to rest is chance, with a long tail (of 64 heaps of each kind the median is 8 to
    // 15 s, and none to three take longer than a minute), so the bound is one over many: half of them within 30 s, seven in eight within a
    // minute.
    [Theory]
    [InlineData("boxes", 36, 0.2f)]
    [InlineData("boxes", 144, 0.6f)]
    [InlineData("polygons", 36, 0.6f)]
    [InlineData("polygons", 144, 0.2f)]
    [InlineData("mixed", 144, 0.2f)]
    [InlineData("mixed", 144, 0.6f)]
    public void Heaps_DroppedIntoABin_FallAsleep(string kind, int count, float friction)
    {
        double[] seconds = [.. Enumerable.Range(1, Heaps).Select(seed => SecondsUntilAsleep(kind, count, friction, seed)).Order()];
        Assert.InRange(seconds[Heaps / 2], 0, 30);
        Assert.InRange(seconds[(Heaps * 7 / 8) - 1], 0, 60);
    }

    [Fact]
    public void Box_OfAMetre_RestsAtTheSurface_WhetherItStandsOrSlides()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10));
        Wall(simulator, 0, -1, 400, 2, 0);
        Body standing = Box(simulator, new Vector2(0, 0.5f));
        Body sliding = Box(simulator, new Vector2(5, 0.5f));
        sliding.LinearVelocity = new Vector2(2, 0);
        Run(simulator, 20);

        // The sag is some hundredths of a millimetre; AllowedPenetration would let them sink in by 5 cm.
        Assert.Equal(0.5f, standing.Position.Y, 1e-4f);
        Assert.Equal(0.5f, sliding.Position.Y, 1e-4f);
    }

    // A steady motion, of 0.8 and of 8 mm in the longer watch of 4 s; a ball's turn counts like its way. 1/256 of its half size is 2 mm.
    [Theory]
    [InlineData(0.0001f, true)]
    [InlineData(0.001f, false)]
    public void Ball_ThatRollsSlowerThanAnybodySees_FallsAsleep(float speed, bool sleeps)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowSleep = true };
        Wall(simulator, 0, -1, 400, 2, 0.6f);
        Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, 1);
        Sandbox.WithoutDrag(ball);
        ball.Position = new Vector2(0, 0.5f);
        Geom geom = GeomFactory.Instance.CreateCircleGeom(simulator, ball, 0.5f, 32);
        geom.FrictionCoefficient = 0.6f;
        ball.LinearVelocity = new Vector2(speed, 0);
        ball.AngularVelocity = -speed / 0.5f;
        Run(simulator, 20);
        Assert.Equal(sleeps, !ball.Awake);
    }

    /// <summary>Infinity: not within a minute.</summary>
    private static double SecondsUntilAsleep(string kind, int count, float friction, int seed)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowSleep = true };
        List<Body> bodies = Drop(simulator, kind, count, friction, seed);
        for (int seconds = 1; seconds <= 60; seconds++)
        {
            Run(simulator, 1);
            if (simulator.SleepingBodyCount == count)
            {
                AssertLying(bodies);
                return seconds;
            }
        }

        return double.PositiveInfinity;
    }

    /// <summary>At rest where they are, not stopped in their fall: none is more than a body's height above the others.</summary>
    private static void AssertLying(List<Body> bodies)
    {
        float[] heights = [.. bodies.Select(b => b.Position.Y).Order()];
        Assert.InRange(heights[0], 0, 1);
        Assert.True(heights.Zip(heights.Skip(1), (low, high) => high - low).Max() < 1.5f);
    }

    private static List<Body> Drop(PhysicsSimulator simulator, string kind, int count, float friction, int seed)
    {
        var random = new Random(seed);
        float width = MathF.Sqrt(count) * 1.1f;
        Wall(simulator, 0, -1, width + 4, 2, friction);
        Wall(simulator, (-width / 2) - 1, 100, 2, 200, friction);
        Wall(simulator, (width / 2) + 1, 100, 2, 200, friction);
        int columns = (int)((width - 0.4f) / 1.5f);
        float gap = width / columns;
        var bodies = new List<Body>();
        for (int i = 0; i < count; i++)
        {
            float x = (-width / 2) + (gap * ((i % columns) + 0.5f)) + Next(random, -0.05f, 0.05f);
            float turn = Next(random, -3, 3);
            Vertices outline = Outline(random, kind == "mixed" ? random.Next(3) : kind == "boxes" ? 0 : 1);
            Body body = BodyFactory.Instance.CreatePolygonBody(simulator, outline, 1);
            Sandbox.WithoutDrag(body);
            body.Position = new Vector2(x, 1 + (1.55f * (i / columns)));
            body.Rotation = turn;
            Geom geom = GeomFactory.Instance.CreatePolygonGeom(simulator, body, outline, 0);
            geom.FrictionCoefficient = friction;
            bodies.Add(body);
        }

        return bodies;
    }

    /// <summary>A box, or a polygon of three to seven, or of sixteen corners.</summary>
    private static Vertices Outline(Random random, int kind)
    {
        if (kind == 0)
        {
            return Vertices.CreateRectangle(Next(random, 0.6f, 1.1f), Next(random, 0.6f, 1.1f));
        }

        int corners = kind == 1 ? random.Next(3, 8) : 16;
        float radius = Next(random, 0.4f, 0.65f);
        var outline = new Vertices();
        for (int i = 0; i < corners; i++)
        {
            float angle = 2 * MathF.PI * (i + (kind == 1 ? Next(random, -0.3f, 0.3f) : 0)) / corners;
            outline.Add(radius * new Vector2(MathF.Cos(angle), MathF.Sin(angle)));
        }

        Vector2 centre = outline.GetCentroid();
        for (int i = 0; i < corners; i++)
        {
            outline[i] -= centre;
        }

        return outline;
    }

    private static float Next(Random random, float least, float most) => least + ((most - least) * random.NextSingle());

    private static Body Box(PhysicsSimulator simulator, Vector2 position)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        Sandbox.WithoutDrag(body);
        body.Position = position;
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1).FrictionCoefficient = 0;
        return body;
    }

    private static void Wall(PhysicsSimulator simulator, float x, float y, float width, float height, float friction)
    {
        Body wall = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, 1);
        wall.IsStatic = true;
        wall.Position = new Vector2(x, y);
        GeomFactory.Instance.CreateRectangleGeom(simulator, wall, width, height).FrictionCoefficient = friction;
    }

    private static void Run(PhysicsSimulator simulator, int seconds)
    {
        for (int i = 0; i < seconds * 60; i++)
        {
            simulator.Update(Dt);
        }
    }
}
