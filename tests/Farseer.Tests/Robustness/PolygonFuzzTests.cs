using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using Xunit.Abstractions;

namespace Farseer.Tests.Robustness;

/// <summary>Random outlines, proper and improper: each makes a geom that simulates, or is refused as an argument, in little time.</summary>
public class PolygonFuzzTests
{
    private const int Outlines = 200;

    /// <summary>A hundred times what the slowest takes on a desk: a limit that only something endless meets.</summary>
    private static readonly TimeSpan _patience = TimeSpan.FromSeconds(20);

    private readonly ITestOutputHelper _output;

    public PolygonFuzzTests(ITestOutputHelper output) => _output = output;

    [Theory]
    [InlineData(1e-3f)]
    [InlineData(1f)]
    [InlineData(1e6f)]
    public void RandomOutline_SimulatesOrIsRefused(float scale)
    {
        int built = 0;
        TimeSpan slowest = TimeSpan.Zero;
        for (int seed = 0; seed < Outlines; seed++)
        {
            Vertices outline = Draw(new Random(seed), scale);
            long start = Stopwatch.GetTimestamp();
            try
            {
                built += Builds(outline, scale) ? 1 : 0;
            }
            catch (Exception exception) when (exception is not Xunit.Sdk.XunitException)
            {
                Assert.Fail("seed " + seed + ", " + outline.Count + " vertices: " + exception);
            }

            TimeSpan taken = Stopwatch.GetElapsedTime(start);
            slowest = taken > slowest ? taken : slowest;
            Assert.True(taken < _patience, "seed " + seed + " took " + taken);
        }

        _output.WriteLine(built + " of " + Outlines + " outlines built; the slowest took " + slowest.TotalMilliseconds + " ms");

        // Both ways must have been tried.
        Assert.InRange(built, Outlines / 5, Outlines * 4 / 5);
    }

    private static bool Builds(Vertices outline, float scale)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 10 * scale)) { AllowedPenetration = 1e-3f * scale };
        Body body;
        try
        {
            body = BodyFactory.Instance.CreatePolygonBody(simulator, outline, 1);
            GeomFactory.Instance.CreatePolygonGeom(simulator, body, outline, 0);
        }
        catch (ArgumentException refusal)
        {
            Assert.Equal("vertices", refusal.ParamName);
            return false;
        }

        body.Position = new Vector2(0, -2 * scale);
        Body floor = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 20 * scale, scale);
        Body second = BodyFactory.Instance.CreateBody(simulator, body);
        second.Position = new Vector2(0.3f * scale, -3 * scale);
        GeomFactory.Instance.CreateGeom(simulator, second, body.GeomAt(0));
        for (int i = 0; i < 10; i++)
        {
            simulator.Update(0.06f);
            Assert.True(
                float.IsFinite(body.Position.X + body.Position.Y + body.LinearVelocity.X + body.LinearVelocity.Y + body.AngularVelocity));
            Assert.True(float.IsFinite(second.Position.X + second.Position.Y + second.AngularVelocity));
            Assert.False(body.IsQuarantined || second.IsQuarantined);
        }

        return true;
    }

    /// <summary>A ring of points around the origin, and then what can go wrong with it.</summary>
    private static Vertices Draw(Random random, float scale)
    {
        int count = random.Next(4) == 0 ? random.Next(30, 201) : random.Next(3, 20);
        double roughness = random.NextDouble();
        var points = new List<Vector2>(count);
        for (int i = 0; i < count; i++)
        {
            double angle = 2 * Math.PI * i / count;
            double radius = 1 - (roughness * random.NextDouble());
            points.Add(new Vector2((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle))));
        }

        int faults = random.Next(4);
        for (int i = 0; i < faults; i++)
        {
            Spoil(points, random);
        }

        if (random.Next(2) == 0)
        {
            points.Reverse();
        }

        var outline = new Vertices();
        foreach (Vector2 point in points)
        {
            outline.Add(point * scale);
        }

        return outline;
    }

    private static void Spoil(List<Vector2> points, Random random)
    {
        int at = random.Next(points.Count);
        Vector2 here = points[at];
        Vector2 next = points[(at + 1) % points.Count];
        switch (random.Next(10))
        {
            case 0: // a vertex twice
                points.Insert(at, here);
                break;
            case 1: // an edge too short to see
                points.Insert(at + 1, here + new Vector2(1e-7f, 2e-7f));
                break;
            case 2: // a short edge
                points.Insert(at + 1, here + ((next - here) * 1e-3f));
                break;
            case 3: // a spike without width
                points.Insert(at + 1, here * 3);
                points.Insert(at + 2, here);
                break;
            case 4: // a thin spike
                points.Insert(at + 1, here * 3);
                points.Insert(at + 2, here + ((next - here) * 1e-4f));
                break;
            case 5: // touches itself
                points.Insert(at, points[random.Next(points.Count)]);
                break;
            case 6: // crosses itself, mostly
                int other = random.Next(points.Count);
                (points[at], points[other]) = (points[other], points[at]);
                break;
            case 7: // vertices on a straight edge
                points.Insert(at + 1, Vector2.Lerp(here, next, 0.3f));
                points.Insert(at + 2, Vector2.Lerp(here, next, 0.6f));
                break;
            case 8: // a notch that nearly cuts through
                points.Insert(at + 1, -0.999f * Vector2.Lerp(here, next, 0.5f));
                break;
            default: // flat
                for (int i = 0; i < points.Count; i++)
                {
                    points[i] *= new Vector2(1, 1e-3f);
                }

                break;
        }
    }
}
