using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>
/// Springs inside joints: they stretch under a load by what Hooke says, whatever the step, and swing and fade as their constants say. With
/// the exact swing alone their length was off by the share ζωh.
/// </summary>
public class SoftJointTests
{
    private const float Gravity = 10;
    private const float Hertz = 4;

    /// <summary>g/ω², of a spring as stiff as the mass that it carries asks for.</summary>
    private const double Stretch = Gravity / (4 * Math.PI * Math.PI * Hertz * Hertz);

    /// <summary>A step in which all of the lengths of step that games use occur.</summary>
    private const float Changing = 0;

    [Theory]
    [InlineData(1 / 30f, 0.7f)]
    [InlineData(1 / 60f, 0.7f)]
    [InlineData(1 / 240f, 0.7f)]
    [InlineData(1 / 60f, 0.1f)]
    [InlineData(1 / 60f, 2f)]
    [InlineData(Changing, 0.7f)]
    public void Distance_WithAWeight_StretchesByHooke(float dt, float damping)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -Gravity));
        Body nail = Nail(simulator, new Vector2(0, 2));
        Body weight = Sandbox.Box(simulator, Vector2.Zero, 1, 1).Body;
        simulator.Add(new DistanceJoint(nail, nail.Position, weight, Vector2.Zero) { Frequency = Hertz, DampingRatio = damping });
        Run(simulator, dt, 10, null);

        // A ten-thousandth of the stretch, and a float's rounding at 2.
        Assert.Equal(-Stretch, weight.Position.Y, 3e-6);
        Assert.InRange(Run(simulator, dt, 2, weight), 0, 1e-3f);
    }

    /// <summary>
    /// A rod welded to a post by its end bends as much as its weight asks for: the load goes through the weld's own pivot.
    /// </summary>
    [Theory]
    [InlineData(1 / 30f)]
    [InlineData(1 / 60f)]
    [InlineData(1 / 240f)]
    [InlineData(Changing)]
    public void Weld_WithARod_BendsByHooke(float dt)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -Gravity));
        Body nail = Nail(simulator, Vector2.Zero);
        Body rod = Sandbox.Box(simulator, new Vector2(1, 0), 2, 0.01f).Body;
        simulator.Add(new WeldJoint(nail, rod, Vector2.Zero) { Frequency = Hertz, DampingRatio = 0.7f });
        Run(simulator, dt, 10, null);

        // ω²·I·θ = m·g·l·cos θ for a rod about its end, I = 4/3: θ = 7.5/631.65·cos θ.
        double bend = 0.75 * Stretch;
        bend *= Math.Cos(bend);
        Assert.Equal(-bend, Math.IEEERemainder(rod.Rotation, 2 * Math.PI), 1e-5);
        Assert.InRange(Run(simulator, dt, 2, rod), 0, 1e-3f);
    }

    /// <summary>A car on its wheels is no higher with a longer step, and does not tremble when steps change.</summary>
    [Theory]
    [InlineData(1 / 30f)]
    [InlineData(1 / 60f)]
    [InlineData(1 / 240f)]
    [InlineData(Changing)]
    public void Car_AtRest_StandsAtItsHeight(float dt)
    {
        float wanted = RestOf(1 / 960f, out _);
        float height = RestOf(dt, out float speed);

        // A two-hundredth of the 81 mm that its springs give way, for two springs on one body take each other for a load: it was 4 mm off
        // at 1/60 s and 8 at 1/30.
        Assert.Equal(wanted, height, 4e-4f);
        Assert.InRange(speed, 0, 1e-3f);
    }

    /// <summary>x(t + dt) = 2e⁻ᶻcos(w)·x(t) - e⁻²ᶻ·x(t - dt), z = ζω·dt and w = ω√(1-ζ²)·dt, is met by that swing alone.</summary>
    [Theory]
    [InlineData(1 / 30f, 0f)]
    [InlineData(1 / 30f, 0.3f)]
    [InlineData(1 / 60f, 0.3f)]
    [InlineData(1 / 60f, 0.9f)]
    [InlineData(1 / 240f, 0.3f)]
    public void Distance_WithoutALoad_SwingsAndFadesAsItsConstantsSay(float dt, float damping)
    {
        var simulator = new PhysicsSimulator(Vector2.Zero);
        Body nail = Nail(simulator, new Vector2(-4, 0));
        Body weight = Sandbox.Box(simulator, Vector2.Zero, 1, 1).Body;
        weight.LinearVelocity = new Vector2(10, 0);
        simulator.Add(new DistanceJoint(nail, nail.Position, weight, Vector2.Zero) { Frequency = Hertz, DampingRatio = damping });
        double omega = 2 * Math.PI * Hertz;
        double decay = Math.Exp(-damping * omega * dt);
        double turn = 2 * decay * Math.Cos(omega * Math.Sqrt(1 - (damping * damping)) * dt);
        simulator.Update(dt);
        double last = weight.Position.X;
        simulator.Update(dt);
        double now = weight.Position.X;
        for (int i = 0; i < 60; i++)
        {
            simulator.Update(dt);
            double wanted = (turn * now) - (decay * decay * last);
            last = now;
            now = weight.Position.X;

            // The rounding of a float step at a length of 4.
            Assert.Equal(wanted, now, 2e-6);
        }
    }

    /// <summary>
    /// A rod on a hinge with a mass at its end, held up by a spring somewhere along it: mass, place, frequency and damping at random. The
    /// frequency is that of the mass felt at the anchor, I/s², so that the torque τ turns it by τ/(I·ω²).
    /// </summary>
    [Fact]
    public void Distance_OnALeverWithAMass_SagsSwingsAndFadesAsItsConstantsSay()
    {
        for (int seed = 0; seed < 120; seed++)
        {
            var random = new Random(seed);
            float length = 1 + (float)random.NextDouble();
            float mass = (float)Math.Pow(10, (3 * random.NextDouble()) - 1);
            float place = length * (0.3f + (0.7f * (float)random.NextDouble()));
            float hertz = 8 + (21 * (float)random.NextDouble());
            float damping = seed % 10 == 0 ? 1 : (float)random.NextDouble();
            double omega = 2 * Math.PI * hertz;

            Body rod = Lever(Gravity, length, mass, place, hertz, damping, out Body ball, out PhysicsSimulator simulator);
            double inertia = ((length * length) + 0.0001) / 12 + (length * length / 4) + (mass * length * length) + ball.MomentOfInertia;
            double turn = Gravity * ((length / 2) + (mass * length)) / (inertia * omega * omega);
            Run(simulator, 1 / 60f, 8, null);

            // Undamped, it would swing about that place for ever. A ten-thousandth, the square of the turn, and the rounding of the angle.
            if (damping > 0.05f)
            {
                Assert.Equal(-turn, Math.IEEERemainder(rod.Rotation, 2 * Math.PI), (1e-4 * turn) + (turn * turn) + 1e-6);
            }

            rod = Lever(0, length, mass, place, hertz, damping, out ball, out simulator);
            rod.AngularVelocity = ball.AngularVelocity = (float)(0.005 * omega);
            rod.LinearVelocity = new Vector2(0, rod.AngularVelocity * length / 2);
            ball.LinearVelocity = new Vector2(0, rod.AngularVelocity * length);
            AssertSwings(simulator, () => rod.Rotation, omega, damping, 0.005, $"seed {seed}");
        }
    }

    /// <summary>Two free bodies on a spring beside their centres, and a car that is held with its wheel below.</summary>
    [Fact]
    public void SpringsBesideTheCentres_SwingAndFadeAsTheirConstantsSay()
    {
        for (int seed = 0; seed < 120; seed++)
        {
            var random = new Random(seed);
            float hertz = 5 + (24 * (float)random.NextDouble());
            float damping = (float)random.NextDouble();
            double omega = 2 * Math.PI * hertz;
            var simulator = new PhysicsSimulator(Vector2.Zero);
            float armA = (float)random.NextDouble() - 0.5f;
            float armB = (float)random.NextDouble() - 0.5f;
            Body a = Sandbox.Box(simulator, new Vector2(-armA, 1), 1, 1, 1 + (3 * (float)random.NextDouble())).Body;
            Body b = Sandbox.Box(simulator, new Vector2(-armB, -1), 1, 1, 1 + (3 * (float)random.NextDouble())).Body;
            var spring = new DistanceJoint(a, new Vector2(armA, 0), b, new Vector2(armB, 0)) { Frequency = hertz, DampingRatio = damping };
            simulator.Add(spring);

            // A push along the line at both anchors.
            float push = (float)(0.005 * omega);
            a.LinearVelocity = new Vector2(0, push / a.Mass);
            a.AngularVelocity = push * armA / a.MomentOfInertia;
            b.LinearVelocity = new Vector2(0, -push / b.Mass);
            b.AngularVelocity = -push * armB / b.MomentOfInertia;
            double Stretch() => (a.GetWorldPosition(new Vector2(armA, 0)) - b.GetWorldPosition(new Vector2(armB, 0))).Length() - 2;
            AssertSwings(simulator, Stretch, omega, damping, 0.01, $"seed {seed}");
        }
    }

    [Theory]
    [InlineData(5f)]
    [InlineData(15f)]
    [InlineData(25f)]
    [InlineData(29f)]
    public void Wheel_UnderACarThatIsHeld_SagsSwingsAndFadesAsItsConstantsSay(float hertz)
    {
        foreach (float damping in new[] { 0f, 0.1f, 0.5f, 0.9f, 1f })
        {
            double omega = 2 * Math.PI * hertz;
            Body wheel = HeldWheel(Gravity, hertz, damping, out PhysicsSimulator simulator);
            Run(simulator, 1 / 60f, 8, null);
            if (damping > 0)
            {
                double sag = Gravity / (omega * omega);
                Assert.Equal(-sag, wheel.Position.Y, (1e-4 * sag) + 1e-8);
            }

            wheel = HeldWheel(0, hertz, damping, out simulator);
            wheel.LinearVelocity = new Vector2(0, (float)(0.01 * omega));
            AssertSwings(simulator, () => wheel.Position.Y, omega, damping, 0.01, $"damping {damping}");
        }
    }

    private static Body HeldWheel(float gravity, float hertz, float damping, out PhysicsSimulator simulator)
    {
        simulator = new PhysicsSimulator(new Vector2(0, -gravity));
        Body car = Nail(simulator, new Vector2(0, 1));
        Body wheel = Sandbox.Ball(simulator, Vector2.Zero, 0.4f, 2).Body;
        simulator.Add(new WheelJoint(car, wheel, Vector2.Zero, Vector2.UnitY) { Frequency = hertz, DampingRatio = damping });
        return wheel;
    }

    private static Body Lever(
        float gravity, float length, float mass, float place, float hertz, float damping, out Body ball, out PhysicsSimulator simulator)
    {
        simulator = new PhysicsSimulator(new Vector2(0, -gravity));
        Body nail = Nail(simulator, new Vector2(place, 4));
        Body rod = BodyFactory.Instance.CreateRectangleBody(simulator, length, 0.01f, 1);
        rod.Position = new Vector2(length / 2, 0);
        ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.1f, mass);
        ball.Position = new Vector2(length, 0);
        Sandbox.WithoutDrag(rod);
        Sandbox.WithoutDrag(ball);
        simulator.Add(JointFactory.Instance.CreateFixedRevoluteJoint(rod, Vector2.Zero));
        simulator.Add(new WeldJoint(rod, ball, ball.Position));
        var anchor = new Vector2(place - (length / 2), 0);
        simulator.Add(new DistanceJoint(nail, Vector2.Zero, rod, anchor) { Frequency = hertz, DampingRatio = damping });
        return rod;
    }

    /// <summary>See <see cref="Distance_WithoutALoad_SwingsAndFadesAsItsConstantsSay"/>.</summary>
    private static void AssertSwings(PhysicsSimulator simulator, Func<double> read, double omega, double damping, double size, string what)
    {
        double dt = 1 / 60f;
        double decay = Math.Exp(-damping * omega * dt);
        double turn = 2 * decay * Math.Cos(omega * Math.Sqrt(Math.Max(0, 1 - (damping * damping))) * dt);
        simulator.Update(1 / 60f);
        double last = Wrapped(read());
        simulator.Update(1 / 60f);
        double now = Wrapped(read());
        for (int i = 0; i < 60; i++)
        {
            simulator.Update(1 / 60f);
            double wanted = (turn * now) - (decay * decay * last);
            last = now;
            now = Wrapped(read());

            // A thousandth of the swing: a frequency off by 1e-3 shows three times as much at 29 Hz, and a hundredth of the damping too.
            Assert.True(Math.Abs(now - wanted) <= 1e-3 * size, $"{what}, step {i}: {now} instead of {wanted}");
        }
    }

    private static double Wrapped(double value) => value > Math.PI ? value - (2 * Math.PI) : value;

    private static float RestOf(float dt, out float speed)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -Gravity)) { AllowedPenetration = 0 };
        Body ground = BodyFactory.Instance.CreateRectangleBody(simulator, 40, 2, 1);
        ground.Position = new Vector2(0, -1);
        ground.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, ground, 40, 2);
        Geom car = Sandbox.Box(simulator, new Vector2(0, 0.9f), 3, 0.5f, 4);
        car.CollisionGroup = 1;
        foreach (float x in new[] { -1f, 1f })
        {
            Geom wheel = Sandbox.Ball(simulator, new Vector2(x, 0.4f), 0.4f, 0.5f, 32);
            wheel.CollisionGroup = 1;
            simulator.Add(
                new WheelJoint(car.Body, wheel.Body, wheel.Body.Position, Vector2.UnitY) { Frequency = Hertz, DampingRatio = 0.7f });
        }

        Run(simulator, dt, 6, null);
        speed = Run(simulator, dt, 2, car.Body);
        return car.Body.Position.Y;
    }

    private static Body Nail(PhysicsSimulator simulator, Vector2 place)
    {
        Body nail = BodyFactory.Instance.CreateCircleBody(simulator, 0.1f, 1);
        nail.IsStatic = true;
        nail.Position = place;
        return nail;
    }

    /// <returns>The highest speed of a body meanwhile.</returns>
    private static float Run(PhysicsSimulator simulator, float dt, float seconds, Body? body)
    {
        var random = new Random(5);
        float fastest = 0;
        for (float time = 0; time < seconds;)
        {
            float step = dt == Changing ? 1 / (30f + (210f * (float)random.NextDouble())) : dt;
            simulator.Update(step);
            time += step;
            fastest = Math.Max(fastest, body is null ? 0 : body.LinearVelocity.Length());
        }

        return fastest;
    }
}
