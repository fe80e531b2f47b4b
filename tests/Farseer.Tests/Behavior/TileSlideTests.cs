using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>What slides over a floor made of parts does not feel where one ends and the next begins.</summary>
public class TileSlideTests
{
    private const float Dt = 1 / 60f;
    private const int Tiles = 110;

    public static TheoryData<string, bool, float, float> Cases()
    {
        var cases = new TheoryData<string, bool, float, float>();
        foreach (string floor in new[] { "bodies", "geoms", "outline" })
        {
            foreach (float speed in new[] { 1f, 10f, 50f, 7f, 31f })
            {
                foreach (float depth in new[] { 0.005f, 0f })
                {
                    cases.Add(floor, true, speed, depth);
                    cases.Add(floor, false, speed, depth);
                }
            }
        }

        return cases;
    }

    // 1 % is what is asked for. With a depth of rest of 0 the box rocks by its sag where it leaves a tile: 0.2 % at 1 m/s; else 1e-5.
    [Theory]
    [MemberData(nameof(Cases))]
    public void Body_Sliding100MetresOverTilesOf1Metre_IsNeitherThrownUpNorSlowed(string floor, bool round, float speed, float depth)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = depth };
        Floor(simulator, floor);
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1 / 6f);
        Sandbox.WithoutDrag(body);
        body.Position = new Vector2(0.2f, 0.5f - depth);
        body.LinearVelocity = new Vector2(speed, 0);
        Smooth(round
            ? GeomFactory.Instance.CreateCircleGeom(simulator, body, 0.5f, 32)
            : GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1));
        float worst = 0;
        int steps = (int)(100 / (speed * Dt));
        for (int i = 0; i < steps; i++)
        {
            simulator.Update(Dt);
            worst = Math.Max(worst, Math.Abs(body.LinearVelocity.Y));
        }

        Assert.True(worst < 0.01f * speed, $"Thrown up at {worst} of {speed}.");
        Assert.Equal(speed, body.LinearVelocity.X, 1e-4f * speed);
    }

    [Fact]
    public void Box_SlidingAgainstATileThatStandsHigher_IsStoppedByIt()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = 0.005f };
        Floor(simulator, "bodies");
        Body ledge = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        ledge.IsStatic = true;
        ledge.Position = new Vector2(10, 0.5f);
        Smooth(GeomFactory.Instance.CreateRectangleGeom(simulator, ledge, 1, 1));
        Body box = BodyFactory.Instance.CreateBody(simulator, 1, 1 / 6f);
        box.Position = new Vector2(5, 0.495f);
        box.LinearVelocity = new Vector2(3, 0);
        Smooth(GeomFactory.Instance.CreateRectangleGeom(simulator, box, 1, 1));
        Sandbox.Run(simulator, 300, Dt);
        Assert.InRange(box.Position.X, 8.9f, 9.01f);
    }

    private static void Floor(PhysicsSimulator simulator, string kind)
    {
        if (kind == "bodies")
        {
            for (int i = -5; i < Tiles; i++)
            {
                Smooth(GeomFactory.Instance.CreateRectangleGeom(simulator, Ground(simulator, new Vector2(i + 0.5f, -0.5f)), 1, 1));
            }

            return;
        }

        Body ground = Ground(simulator, Vector2.Zero);
        if (kind == "geoms")
        {
            for (int i = -5; i < Tiles; i++)
            {
                Smooth(GeomFactory.Instance.CreateRectangleGeom(simulator, ground, 1, 1, new Vector2(i + 0.5f, -0.5f), 0));
            }

            return;
        }

        // A saw on its back: the cuts of the concave outline end all along the surface.
        var outline = new Vertices();
        for (int i = -5; i <= Tiles; i++)
        {
            outline.Add(new Vector2(i, -1 - ((i & 1) * 0.4f)));
        }

        for (int i = Tiles; i >= -5; i--)
        {
            outline.Add(new Vector2(i, 0));
        }

        var geom = new Geom(ground, outline, 0.2f);
        Smooth(geom);
        simulator.Add(geom);
    }

    private static Body Ground(PhysicsSimulator simulator, Vector2 place)
    {
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        body.IsStatic = true;
        body.Position = place;
        return body;
    }

    private static void Smooth(Geom geom)
    {
        geom.FrictionCoefficient = 0;
        geom.RestitutionCoefficient = 0;
    }
}
