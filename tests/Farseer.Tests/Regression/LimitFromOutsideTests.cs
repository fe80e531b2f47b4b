using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Limits that something from outside overran: a body put beyond them, or they set anew. They went back by a fifth of the overrun a substep
/// as a speed, of which up to 144 a second was left wherever an anchor lies off its body's centre.
/// </summary>
public class LimitFromOutsideTests
{
    /// <summary>Nothing acts here. What a body has left is of the second order of its displacements.</summary>
    private const float Still = 0.05f;

    public enum Limit
    {
        Slider,
        Rope,
        Rails,
        AngleLimit,
    }

    [Theory]
    [InlineData(Limit.Slider, true)]
    [InlineData(Limit.Slider, false)]
    [InlineData(Limit.Rope, true)]
    [InlineData(Limit.Rope, false)]
    [InlineData(Limit.Rails, true)]
    [InlineData(Limit.Rails, false)]
    [InlineData(Limit.AngleLimit, false)]
    public void Body_PutBeyondALimit_ReturnsWithoutSpeed(Limit kind, bool still)
    {
        for (int seed = 0; seed < 30; seed++)
        {
            var random = new Random(seed);
            var simulator = new PhysicsSimulator(Vector2.Zero);
            Body held = Sandbox.Box(simulator, Vector2.Zero, 0.4f, 0.4f).Body;
            Body body = Sandbox.Box(simulator, 0.8f * Vector2.UnitX, 0.2f, 0.2f, 0.1f).Body;
            held.IsStatic = still;
            Joint joint = Join(kind, held, body, random);
            simulator.Add(joint);
            simulator.Update(1 / 60f);
            body.Position += Away(random, 3);
            body.Rotation += 2;
            for (int i = 0; i < 120; i++)
            {
                simulator.Update(1 / 60f);
                Assert.InRange(body.LinearVelocity.Length(), 0, Still);
                Assert.InRange(held.LinearVelocity.Length(), 0, Still);
            }

            // The slack of a slider and of an angle's range is 0.01.
            Assert.InRange(MathF.Abs(joint.JointError), 0, 0.011f);
        }
    }

    [Fact]
    public void Slider_SetShorter_DrawsItsBodiesTogetherWithoutSpeedAndKeepsTheirCentre()
    {
        var simulator = new PhysicsSimulator(Vector2.Zero);
        Body heavy = Sandbox.Box(simulator, Vector2.Zero, 0.4f, 0.4f).Body;
        Body light = Sandbox.Box(simulator, 3 * Vector2.UnitX, 0.2f, 0.2f, 0.1f).Body;
        var slider = new SliderJoint(heavy, new Vector2(0, 0.1f), light, new Vector2(0.05f, -0.05f), 0, 3.1f);
        simulator.Add(slider);
        Vector2 drift = new Vector2(0.5f, -0.25f);
        heavy.LinearVelocity = drift;
        light.LinearVelocity = drift;
        simulator.Update(1 / 60f);
        slider.Max = 1;
        for (int i = 1; i <= 120; i++)
        {
            Vector2 before = ((heavy.Mass * heavy.Position) + (light.Mass * light.Position)) / (heavy.Mass + light.Mass);
            simulator.Update(1 / 60f);
            Vector2 after = ((heavy.Mass * heavy.Position) + (light.Mass * light.Position)) / (heavy.Mass + light.Mass);

            // To floats.
            Assert.InRange((after - before - (drift / 60)).Length(), 0, 2e-6f);
            Assert.InRange((heavy.LinearVelocity - drift).Length(), 0, Still);
            Assert.InRange((light.LinearVelocity - drift).Length(), 0, Still);
        }

        Assert.InRange(
            (light.GetWorldPosition(new Vector2(0.05f, -0.05f)) - heavy.GetWorldPosition(new Vector2(0, 0.1f))).Length(), 0, 1.011f);
    }

    /// <summary>What lies in the way is pushed aside, and not shot off.</summary>
    [Fact]
    public void Body_PutBeyondItsSliderBehindAnother_ShootsNothingOff()
    {
        var simulator = new PhysicsSimulator(Vector2.Zero);
        Body still = Sandbox.Box(simulator, Vector2.Zero, 0.4f, 0.4f, 1000).Body;
        still.IsStatic = true;
        Body light = Sandbox.Box(simulator, Vector2.UnitX, 0.2f, 0.2f, 0.1f).Body;
        Geom inTheWay = Sandbox.Box(simulator, new Vector2(1.5f, 0.05f), 0.2f, 0.2f);
        simulator.Add(new SliderJoint(still, Vector2.Zero, light, new Vector2(0, 0.05f), 0, 1.1f));
        simulator.Update(1 / 60f);
        light.Position = new Vector2(3.4f, 0);
        for (int i = 0; i < 120; i++)
        {
            simulator.Update(1 / 60f);
            Assert.InRange(inTheWay.Body.LinearVelocity.Length(), 0, 1);
            Assert.InRange(light.LinearVelocity.Length(), 0, 1);
        }
    }

    private static Joint Join(Limit kind, Body held, Body body, Random random) => kind switch
    {
        Limit.Slider => new SliderJoint(held, Away(random, 0.4f), body, Away(random, 0.4f), 0, 2),
        Limit.Rope => new RopeJoint(held, Away(random, 0.4f), body, Away(random, 0.4f), 2),
        Limit.Rails => new PrismaticJoint(held, body, body.Position + Away(random, 0.4f), Vector2.Normalize(Away(random, 1)))
        {
            LowerLimit = -0.2f,
            UpperLimit = 0.3f,
            AreLimitsEnabled = true,
        },
        _ => new AngleLimitJoint(held, body, -0.2f, 0.3f),
    };

    private static Vector2 Away(Random random, float size) =>
        size * 2 * new Vector2(random.NextSingle() - 0.5f, random.NextSingle() - 0.5f);
}
