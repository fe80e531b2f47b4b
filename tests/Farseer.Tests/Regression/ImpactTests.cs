using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>Impacts that do not bounce, and what comes right after them.</summary>
public class ImpactTests
{
    private const float ArmX = 4;
    private const float ArmY = 16;
    private const double Inertia = 40.0 * 40.0 / 6;

    // In the step of the impact the gap is 0 to 0.6 of the arm of 16: with arms to the middle of the gap, as they once were,
    // the spin was wrong by up to 2 %.
    [Theory]
    [InlineData(24f)]
    [InlineData(24.2f)]
    [InlineData(24.4f)]
    public void InelasticImpact_WithinAStep_TurnsTheBodyByTheArmsOfItsOwnCorner(float drop)
    {
        PhysicsSimulator simulator = Sandbox.WithFloor(out Geom floor);
        Body body = OffCentre(simulator, floor, drop);
        int steps = (int)Math.Ceiling(Math.Sqrt(2 * drop / 100) / Sandbox.Step);
        Sandbox.Run(simulator, steps);

        // Stopping is linear in the velocity: what weight adds after the impact is stopped in the same proportion, so it is as
        // if all the fall until now were stopped at once. The arms turn by 0.005 rad in the rest of the step: 0.1 % in effect.
        double spin = Spin(100 * steps * Sandbox.Step);
        Assert.Equal(spin, -body.AngularVelocity, 0.002 * spin);
    }

    // ½ I (w₁² - w₀²) = m g Δh about the corner. With the contact arms of each step's start the gain was 1.4 % short.
    [Fact]
    public void TippingBody_AboutItsCorner_GainsTheEnergyOfItsFall()
    {
        PhysicsSimulator simulator = Sandbox.WithFloor(out Geom floor);
        Body body = OffCentre(simulator, floor, 24);
        Sandbox.Run(simulator, 75);
        (double angle0, double spin0) = (body.TotalRotation, body.AngularVelocity);
        Sandbox.Run(simulator, 45);
        (double angle1, double spin1) = (body.TotalRotation, body.AngularVelocity);
        double inertia = Inertia + (ArmX * ArmX) + (ArmY * ArmY);
        double gain = 0.5 * inertia * ((spin1 * spin1) - (spin0 * spin0));
        double fall = 100 * (Height(angle0) - Height(angle1));
        Assert.Equal(fall, gain, 0.004 * fall);
    }

    [Fact]
    public void BoxDroppedOnABox_StaysInTouch_FromTheImpactOn()
    {
        PhysicsSimulator simulator = Sandbox.WithFloor(out Geom floor);
        Geom lower = Sandbox.Box(simulator, new Vector2(0, -45), 40, 40);
        Geom upper = Sandbox.Box(simulator, new Vector2(2, -95), 40, 40);
        foreach (Geom geom in new[] { floor, lower, upper })
        {
            geom.FrictionCoefficient = 0.5f;
        }

        int touches = 0;
        int separations = 0;
        upper.OnCollision += (_, _, _) =>
        {
            touches++;
            return true;
        };
        upper.OnSeparation += (_, _) => separations++;
        Sandbox.Run(simulator, 150);
        Assert.True(touches > 60, "The box was to land.");
        Assert.Equal(0, separations);
    }

    // Until it has sunk to the depth of rest a box gave up all its load: nothing held against the torque of its friction, and it
    // tilted by a third of the depth (1e-3 rad here).
    [Fact]
    public void SlidingBox_SinkingToItsDepthOfRest_StaysLevel()
    {
        PhysicsSimulator simulator = Sandbox.WithFloor(out Geom floor);
        simulator.AllowedPenetration = 0.2f;
        Geom box = Sandbox.Box(simulator, new Vector2(-180, -20), 40, 40);
        box.FrictionCoefficient = 0.2f;
        floor.FrictionCoefficient = 0.2f;
        box.Body.LinearVelocity = new Vector2(100, 0);
        for (int i = 0; i < 200; i++)
        {
            Sandbox.Run(simulator, 1);
            Assert.InRange(box.Body.TotalRotation, -2e-4f, 2e-4f);
        }
    }

    // Two pieces land together. Friction answered each turn that one piece's normals made before the other's had undone it, and
    // what was left of the impact in the next step was not settled: it slid off with 0.1 and more.
    [Fact]
    public void ConcaveBody_LandingFlatOnTwoPieces_NeitherSlidesNorTurns()
    {
        PhysicsSimulator simulator = Sandbox.WithFloor(out Geom floor);
        Vertices outline = Sandbox.Outline(0, 0, 60, 0, 60, 20, 20, 20, 20, 60, 0, 60);
        Body body = BodyFactory.Instance.CreatePolygonBody(simulator, outline, 2);
        Geom geom = GeomFactory.Instance.CreatePolygonGeom(simulator, body, outline, 2);
        body.Rotation = MathF.PI;
        body.Position = new Vector2(0, -60);
        geom.FrictionCoefficient = 0.6f;
        floor.FrictionCoefficient = 0.5f;
        Sandbox.Run(simulator, 150);
        Assert.InRange(body.Position.X, -0.05f, 0.05f);
        for (int i = 0; i < 60; i++)
        {
            Sandbox.Run(simulator, 1);
            Assert.InRange(body.LinearVelocity.X, -1e-4f, 1e-4f);
            Assert.InRange(body.AngularVelocity, -1e-6f, 1e-6f);
        }
    }

    // Half a radian a step: where contacts turned the point of a wheel that touches, it sank by r (1 - cos 0.5), a tenth of r.
    [Fact]
    public void Wheel_TurningHalfARadianAStep_RollsAtOneHeight()
    {
        PhysicsSimulator simulator = Sandbox.WithFloor(out Geom floor);
        Geom wheel = Sandbox.Ball(simulator, new Vector2(-180, -20), 20);
        wheel.FrictionCoefficient = 1;
        floor.FrictionCoefficient = 1;
        wheel.Body.AngularVelocity = 50;
        wheel.Body.LinearVelocity = new Vector2(1000, 0);
        for (int i = 0; i < 35; i++)
        {
            Sandbox.Run(simulator, 1);

            // Between touch and the depth of rest of 0.05; the landing may be some hundredths deeper.
            Assert.InRange(wheel.Body.Position.Y, -20.02f, -19.9f);
        }
    }

    /// <summary>A box beside its body's centre: its lowest corner nearest the centre is (4, 16) from it.</summary>
    private static Body OffCentre(PhysicsSimulator simulator, Geom floor, float drop)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 40, 40, 1);
        Sandbox.WithoutDrag(body);
        body.Position = new Vector2(0, -ArmY - drop);
        Geom box = GeomFactory.Instance.CreateRectangleGeom(simulator, body, 40, 40, new Vector2(24, -4), 0);
        box.FrictionCoefficient = 1;
        floor.FrictionCoefficient = 1;
        return body;
    }

    /// <summary>
    /// Spin after the corner stops dead: with the arms (x, y) the impulse (F, N) solves
    /// (1 + y²/I) F = (x y/I) N and (1 + x²/I) N = v + (x y/I) F; then w = (x N - y F)/I.
    /// </summary>
    private static double Spin(double speed)
    {
        double normal = 1 + (ArmX * ArmX / Inertia);
        double tangent = 1 + (ArmY * ArmY / Inertia);
        double cross = ArmX * ArmY / Inertia;
        double push = speed * tangent / ((normal * tangent) - (cross * cross));
        double drag = cross * push / tangent;
        return ((ArmX * push) - (ArmY * drag)) / Inertia;
    }

    private static double Height(double angle) => (ArmY * Math.Cos(angle)) + (ArmX * Math.Sin(angle));
}
