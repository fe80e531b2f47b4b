using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>
/// A share of an error is at most all of it. Taken as it came, 3 sent a body to the other side of its target and twice as far in each
/// update, until it was no number any more.
/// </summary>
public class BiasFactorTests
{
    [Theory]
    [InlineData(3)]
    [InlineData(1e19f)]
    public void AboveOne_ActsAsOne(float factor)
    {
        Func<Body, Body, Joint>[] kinds =
        [
            (a, b) => new MotorJoint(a, b) { Offset = new Vector2(5, 1), TargetAngle = 1 },
            (a, b) => new AngleJoint(a, b, 1),
            (a, b) => new AngleLimitJoint(a, b, 1, 2),
            (_, b) => new FixedAngleJoint(b, 1),
            (_, b) => new FixedAngleLimitJoint(b, 1, 2),
            (_, b) => new FixedRevoluteJoint(b, b.Position),
            (a, b) => new PinJoint(a, Vector2.Zero, b, Vector2.Zero),
            (a, b) => new RevoluteJoint(a, b, new Vector2(1, 0)),
            (a, b) => new SliderJoint(a, Vector2.Zero, b, Vector2.Zero, 1, 2),
            (a, b) => new GearJoint(a, b, 2),
            (a, b) => new WeldJoint(a, b, new Vector2(1, 0)),
            (a, b) => new PrismaticJoint(a, b, Vector2.Zero, Vector2.UnitX),
        ];
        foreach (Func<Body, Body, Joint> make in kinds)
        {
            Assert.Equal(Way(make, 1), Way(make, factor));
        }
    }

    /// <summary>Where the bodies go when one is put elsewhere.</summary>
    private static string Way(Func<Body, Body, Joint> make, float factor)
    {
        using PhysicsSimulator simulator = new();
        var a = new Body();
        var b = new Body { Position = new Vector2(2, 0) };
        simulator.Add(a);
        simulator.Add(b);
        Joint joint = make(a, b);
        joint.BiasFactor = factor;
        simulator.Add(joint);
        simulator.Update(0.01f);
        b.Position = new Vector2(3, 1);
        b.Rotation = 0.5f;
        Sandbox.Run(simulator, 5);
        return string.Join(" ", simulator.BodyList.Select(x => x.Position + " " + x.TotalRotation + " " + x.LinearVelocity));
    }
}
