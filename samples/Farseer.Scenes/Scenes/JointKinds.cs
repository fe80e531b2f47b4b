using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>One of every kind of joint, in three rows above a floor, each with what it has: limits, motor, spring.</summary>
public sealed class JointKinds : Scene
{
    private const float Apart = 4f;
    private const int InARow = 6;
    private readonly List<Joint> _exact = [];
    private readonly List<Joint> _all = [];
    private double _largestError;
    private double _fastest;
    private int _broken;

    public override string Name => "joint-kinds";

    public override string Title => "Every kind of joint";

    public override string Description =>
        "Eighteen pairs of boxes, each held by another kind of joint: those that hold exactly do, and nothing breaks.";

    public override SceneView View => new(new Vector2(-2f, -1f), new Vector2(24f, 15f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 60f, 11f);
        _exact.Clear();
        _all.Clear();
        _largestError = 0.0;
        _fastest = 0.0;
        _broken = 0;
        AddHinges(simulator);
        AddLengths(simulator);
        AddAngles(simulator);
        foreach (Joint joint in _all)
        {
            joint.Broke += (_, _) => _broken++;
            simulator.Add(joint);
        }
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        foreach (Joint joint in _exact)
        {
            _largestError = Math.Max(_largestError, Math.Abs((double)joint.JointError));
        }

        foreach (Body body in simulator.BodyList)
        {
            _fastest = Math.Max(_fastest, body.LinearVelocity.Length());
        }
    }

    public override IReadOnlyList<SceneOutcome> Check() =>
    [
        SceneOutcome.Exactly("joints that broke", _broken, 0),

        // Lengths in metres, angles in radians; boxes of half a metre.
        SceneOutcome.AtMost("largest error of the joints that hold exactly", _largestError, 2e-3),

        // From 13 m a body falls with 16 m/s; motors and springs add a little.
        SceneOutcome.AtMost("fastest body in the whole run (m/s)", _fastest, 20.0),
    ];

    private void AddHinges(PhysicsSimulator simulator)
    {
        (Body a, Body b) = Pair(simulator, 0);
        Exact(new RevoluteJoint(a, b, Between(a, b)) { AreLimitsEnabled = true, LowerLimit = -0.8f, UpperLimit = 0.8f });
        (a, b) = Pair(simulator, 1);
        Exact(new FixedRevoluteJoint(
            a, a.Position + new Vector2(0f, 0.5f)) { IsMotorEnabled = true, MotorSpeed = 2f, MaxMotorTorque = 0.5f });
        (a, b) = Pair(simulator, 2);
        Exact(new WeldJoint(a, b, Between(a, b)));
        (a, b) = Pair(simulator, 3);
        Loose(new WeldJoint(a, b, Between(a, b)) { Frequency = 3f });
        (a, b) = Pair(simulator, 4);
        Exact(new PrismaticJoint(a, b, b.Position, Vector2.UnitY) { AreLimitsEnabled = true, LowerLimit = -0.3f, UpperLimit = 0.3f });
        (a, b) = Pair(simulator, 5);
        Exact(new FixedPrismaticJoint(a, a.Position, Vector2.UnitX)
        {
            AreLimitsEnabled = true, LowerLimit = -1f, UpperLimit = 1f, IsMotorEnabled = true, MotorSpeed = 1f, MaxMotorForce = 3f,
        });
        Loose(new WheelJoint(a, b, b.Position, Vector2.UnitY) { IsMotorEnabled = true, MotorSpeed = 3f, MaxMotorTorque = 0.2f });
    }

    private void AddLengths(PhysicsSimulator simulator)
    {
        (Body a, Body b) = Pair(simulator, 6);
        Exact(new PinJoint(a, new Vector2(0f, 0.2f), b, Vector2.Zero));
        (a, b) = Pair(simulator, 7);
        Loose(new DistanceJoint(
            a, Vector2.Zero, b, Vector2.Zero) { Frequency = 2f, AreLimitsEnabled = true, LowerLimit = 0.7f, UpperLimit = 1.3f });
        (a, b) = Pair(simulator, 8);
        Loose(new RopeJoint(a, Vector2.Zero, b, Vector2.Zero, 1.2f));
        (a, b) = Pair(simulator, 9);
        Loose(new SliderJoint(a, Vector2.Zero, b, Vector2.Zero, 0.8f, 1.2f));
        (a, b) = Pair(simulator, 10);
        Loose(new PulleyJoint(a, a.Position + new Vector2(0f, 2f), Vector2.Zero, b, b.Position + new Vector2(0f, 2f), Vector2.Zero, 1.5f));
        (a, b) = Pair(simulator, 11);
        Loose(new TargetJoint(a, a.Position + new Vector2(0.2f, 0.1f)) { Frequency = 2f });
        Loose(new PinJoint(a, Vector2.Zero, b, Vector2.Zero) { Softness = 0.2f });
    }

    private void AddAngles(PhysicsSimulator simulator)
    {
        (Body a, Body b) = Pair(simulator, 12);
        Loose(new AngleJoint(a, b, 0.4f));
        (a, b) = Pair(simulator, 13);
        Loose(new FixedAngleJoint(a, 0.4f) { MaxImpulse = 0.01f });
        (a, b) = Pair(simulator, 14);
        Loose(new AngleLimitJoint(a, b, -0.2f, 0.2f));
        (a, b) = Pair(simulator, 15);
        Loose(new FixedAngleLimitJoint(a, -0.2f, 0.2f));
        (a, b) = Pair(simulator, 16);
        Exact(new GearJoint(a, b, 2f));
        a.AngularVelocity = 3f;
        (a, b) = Pair(simulator, 17);
        Loose(new MotorJoint(a, b) { Offset = new Vector2(1.2f, 0.2f), TargetAngle = 0.3f, MaxForce = 5f, MaxTorque = 1f });
    }

    /// <summary>Two boxes of half a metre side by side, the second with a spin, at a place in the rows.</summary>
    private static (Body A, Body B) Pair(PhysicsSimulator simulator, int place)
    {
        var corner = new Vector2(Apart * (place % InARow), 3f + (Apart * (place / InARow)));
        Body a = Make.Box(simulator, corner, 0.5f, 0.5f).Body;
        Body b = Make.Box(simulator, corner + new Vector2(1f, 0f), 0.5f, 0.5f).Body;
        b.AngularVelocity = 1f;
        return (a, b);
    }

    private static Vector2 Between(Body a, Body b) => (a.Position + b.Position) / 2f;

    private void Exact(Joint joint)
    {
        _exact.Add(joint);
        _all.Add(joint);
    }

    private void Loose(Joint joint) => _all.Add(joint);
}
