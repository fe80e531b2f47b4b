using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>Joints that hold one body to the world: at a point, at an angle, between two angles.</summary>
public sealed class FixedJoints : Scene
{
    private static readonly Vector2 _nail = new(-6f, 6f);
    private const float Arm = 3f;
    private Body? _pendulum;
    private Body? _upright;
    private Body? _flap;
    private FixedRevoluteJoint? _hinge;
    private double _startEnergy;
    private double _gained;
    private double _widest;

    public override string Name => "fixed-joints";

    public override string Title => "Fixed joints";

    public override string Description =>
        "A pendulum keeps its energy, a box lands off its middle and stays upright, a flap stops at its limits.";

    public override SceneView View => new(new Vector2(-10.5f, -1f), new Vector2(10.5f, 9.5f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 30f);
        _gained = 0.0;
        _widest = 0.0;

        // A point of a body is nailed to the world: released level, it swings.
        _pendulum = Make.Box(simulator, _nail + new Vector2(Arm, 0f), 1f, 0.5f).Body;
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, _pendulum, _nail);
        _startEnergy = Energy(_pendulum);

        // An angle is nailed to the world: the box moves freely, but it does not turn, although it lands on the edge of a block.
        Make.Wall(simulator, new Vector2(0.9f, 0.5f), 1f, 1f);
        _upright = Make.Box(simulator, new Vector2(0f, 4f), 1.5f, 1.5f).Body;
        JointFactory.Instance.CreateFixedAngleJoint(simulator, _upright);

        // A hinge and two limits: the flap falls until it has turned by 0.6, a ball falls on its lower end.
        _flap = Make.Box(simulator, new Vector2(6f, 4f), 4f, 0.3f).Body;
        _hinge = JointFactory.Instance.CreateFixedRevoluteJoint(simulator, _flap, new Vector2(4.2f, 4f));
        JointFactory.Instance.CreateFixedAngleLimitJoint(simulator, _flap, -0.6f, 0f);
        Geom ball = Make.Circle(simulator, new Vector2(6.5f, 7f), 0.4f);
        ball.RestitutionCoefficient = 0.3f;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        _gained = Math.Max(_gained, Math.Abs(Energy(_pendulum!) - _startEnergy));
        _widest = Math.Max(_widest, Math.Max(Measure.Angle(_flap!), -0.6 - Measure.Angle(_flap!)));
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double arm = Math.Abs((_pendulum!.Position - _nail).Length() - Arm);
        return
        [
            // Ten seconds without drag; the energy that swings to and fro is m g l = 15 J.
            SceneOutcome.AtMost("energy of the pendulum off (J)", _gained, 0.15),
            SceneOutcome.AtMost("length of the pendulum off (m)", arm, 1e-3),
            SceneOutcome.AtMost("tilt of the upright box (rad)", Math.Abs(Measure.Angle(_upright!)), 1e-3),
            SceneOutcome.Error("its height on the block (m)", _upright!.PositionY, 1.75, 2.0 * Make.Tolerance),

            // A limit lets an angle be past it by its Slop of 0.01 without turning it back.
            SceneOutcome.AtMost("flap past its limits in the whole run (rad)", _widest, 0.02),
            SceneOutcome.Error("angle of the flap at the end (rad)", Measure.Angle(_flap!), -0.6, 0.011),
            SceneOutcome.AtMost("hinge of the flap loose by (m)", _hinge!.JointError, 1e-3),
        ];
    }

    private static double Energy(Body body)
    {
        Vector2 v = body.LinearVelocity;
        double moving = 0.5 * body.Mass * (((double)v.X * v.X) + ((double)v.Y * v.Y));
        double turning = 0.5 * body.MomentOfInertia * body.AngularVelocity * body.AngularVelocity;
        return moving + turning + (body.Mass * Make.Gravity * body.PositionY);
    }
}
