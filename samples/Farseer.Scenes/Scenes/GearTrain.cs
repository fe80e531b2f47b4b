using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>Three wheels on axles, coupled by gear joints instead of teeth: a torque on the small one turns them all.</summary>
public sealed class GearTrain : Scene
{
    private const float Torque = 4f;
    private static readonly float[] _radii = [1f, 2f, 1.5f];
    private readonly List<Body> _wheels = [];
    private readonly List<GearJoint> _gears = [];

    public override string Name => "gear-joint";

    public override string Title => "Gears by joints";

    public override string Description =>
        "A torque turns the first of three wheels; gear joints pass it on, and all turn as their radii say.";

    public override int Steps => 300;

    public override SceneView View => new(new Vector2(-2f, -3f), new Vector2(8f, 3f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        _wheels.Clear();
        _gears.Clear();
        float x = 0f;
        for (int i = 0; i < _radii.Length; i++)
        {
            x += i > 0 ? _radii[i - 1] + _radii[i] : 0f;
            Geom wheel = Make.Circle(simulator, new Vector2(x, 0f), _radii[i]);

            // The rims meet, and the joints do what teeth would: the wheels must not collide besides.
            wheel.CollisionGroup = 1;
            JointFactory.Instance.CreateFixedRevoluteJoint(simulator, wheel.Body, wheel.Body.Position);
            _wheels.Add(wheel.Body);
            if (i > 0)
            {
                // It keeps angle 2 + ratio · angle 1: the second wheel turns the other way by the ratio of the radii.
                _gears.Add(JointFactory.Instance.CreateGearJoint(simulator, _wheels[i - 1], wheel.Body, _radii[i - 1] / _radii[i]));
            }
        }
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt) => _wheels[0].ApplyTorque(Torque);

    public override IReadOnlyList<SceneOutcome> Check()
    {
        // All rims move by the same way, so wheel i counts with I (r0 / ri)² at the first axle.
        double inertia = 0.0;
        for (int i = 0; i < _wheels.Count; i++)
        {
            double ratio = (double)_radii[0] / _radii[i];
            inertia += _wheels[i].MomentOfInertia * ratio * ratio;
        }

        double time = Steps * (double)Dt;
        double due = 0.5 * Torque / inertia * time * time;
        double slip = 0.0;
        for (int i = 1; i < _wheels.Count; i++)
        {
            double sign = i % 2 == 0 ? 1.0 : -1.0;
            double ideal = sign * _wheels[0].TotalRotation * _radii[0] / _radii[i];
            slip = Math.Max(slip, Math.Abs(_wheels[i].TotalRotation - ideal));
        }

        return
        [
            // The closed form of a constant torque; the wheel turns by several radians in single-precision speeds.
            SceneOutcome.Error("turn of the first wheel (rad)", _wheels[0].TotalRotation, due, 1e-3 * due),
            SceneOutcome.AtMost("slip between the wheels (rad)", slip, 1e-4),
            SceneOutcome.AtMost("joint error (rad)", Math.Max(Math.Abs(_gears[0].JointError), Math.Abs(_gears[1].JointError)), 1e-4),
        ];
    }
}
