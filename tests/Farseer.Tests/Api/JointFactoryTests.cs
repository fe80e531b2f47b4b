using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>Every overload of the joint factory: with a simulator it adds, without it does not.</summary>
public class JointFactoryTests
{
    private readonly PhysicsSimulator _simulator = new PhysicsSimulator();
    private readonly Body _a = new Body();
    private readonly Body _b = new Body { Position = new Vector2(10, 0) };
    private readonly JointFactory _joints = JointFactory.Instance;

    [Fact]
    [ManualRow("F146")]
    [ManualRow("F147")]
    [ManualRow("F148")]
    public void Instance_IsOne_AndWhatItMakesCanBeSetFurther()
    {
        Assert.Same(JointFactory.Instance, _joints);
        AngleJoint joint = _joints.CreateAngleJoint(_a, _b);
        joint.TargetAngle = 1;
        joint.MaxImpulse = 5;
        Assert.Equal((1f, 5f), (joint.TargetAngle, joint.MaxImpulse));
    }

    [Fact]
    [ManualRow("F149")]
    [ManualRow("F151")]
    [ManualRow("F153")]
    [ManualRow("F155")]
    [ManualRow("F157")]
    [ManualRow("F159")]
    [ManualRow("F161")]
    [ManualRow("F163")]
    [ManualRow("F165")]
    [ManualRow("F167")]
    public void OverloadsWithASimulator_AddTheJoint()
    {
        Joint[] made =
        [
            _joints.CreateRevoluteJoint(_simulator, _a, _b, new Vector2(5, 0)),
            _joints.CreateFixedRevoluteJoint(_simulator, _a, new Vector2(1, 0)),
            _joints.CreatePinJoint(_simulator, _a, Vector2.Zero, _b, Vector2.Zero),
            _joints.CreateSliderJoint(_simulator, _a, Vector2.Zero, _b, Vector2.Zero, 1, 20),
            _joints.CreateAngleJoint(_simulator, _a, _b),
            _joints.CreateAngleJoint(_simulator, _a, _b, 0.5f, 0.3f),
            _joints.CreateFixedAngleJoint(_simulator, _a),
            _joints.CreateAngleLimitJoint(_simulator, _a, _b, -1, 1),
            _joints.CreateFixedAngleLimitJoint(_simulator, _a, -1, 1),
            _joints.CreateGearJoint(_simulator, _a, _b, 2),
        ];
        Assert.Empty(_simulator.JointList);
        _simulator.Update(0.01f);
        Assert.Equal(made, _simulator.JointList);
        Assert.Equal((0.5f, 0.3f), (made[5].Softness, made[5].BiasFactor));
    }

    [Fact]
    [ManualRow("F150")]
    [ManualRow("F152")]
    [ManualRow("F154")]
    [ManualRow("F156")]
    [ManualRow("F158")]
    [ManualRow("F160")]
    [ManualRow("F162")]
    [ManualRow("F164")]
    [ManualRow("F166")]
    public void OverloadsWithoutASimulator_OnlyMakeTheJoint()
    {
        RevoluteJoint revolute = _joints.CreateRevoluteJoint(_a, _b, new Vector2(5, 0));
        Assert.Equal((_a, _b, new Vector2(5, 0)), (revolute.Body1, revolute.Body2, revolute.Anchor));
        FixedRevoluteJoint nail = _joints.CreateFixedRevoluteJoint(_a, new Vector2(1, 0));
        Assert.Equal((_a, new Vector2(1, 0)), (nail.Body, nail.Anchor));
        PinJoint pin = _joints.CreatePinJoint(_a, Vector2.Zero, _b, new Vector2(2, 0));
        Assert.Equal((new Vector2(2, 0), 12f), (pin.Anchor2, pin.TargetDistance));
        SliderJoint slider = _joints.CreateSliderJoint(_a, Vector2.Zero, _b, Vector2.Zero, 1, 20);
        Assert.Equal((1f, 20f), (slider.Min, slider.Max));
        Assert.Equal(0, _joints.CreateAngleJoint(_a, _b).TargetAngle);
        AngleJoint soft = _joints.CreateAngleJoint(_a, _b, 0.5f, 0.3f);
        Assert.Equal((0.5f, 0.3f), (soft.Softness, soft.BiasFactor));
        Assert.Same(_a, _joints.CreateFixedAngleJoint(_a).Body);
        AngleLimitJoint limit = _joints.CreateAngleLimitJoint(_a, _b, -1, 2);
        Assert.Equal((-1f, 2f), (limit.LowerLimit, limit.UpperLimit));
        FixedAngleLimitJoint fixedLimit = _joints.CreateFixedAngleLimitJoint(_a, -1, 2);
        Assert.Equal((-1f, 2f), (fixedLimit.LowerLimit, fixedLimit.UpperLimit));
        _simulator.Update(0.01f);
        Assert.Empty(_simulator.JointList);
    }
}
