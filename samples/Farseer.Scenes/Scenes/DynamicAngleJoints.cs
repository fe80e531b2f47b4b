using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>A spider: hinges hold its legs, angle joints are its muscles, and their target angles change while it runs.</summary>
public sealed class DynamicAngleJoints : Scene
{
    private const float Trunk = 0.5f;
    private const float Length = 1.2f;
    private const float Width = 0.2f;
    private const float CrouchedHip = 0.5f;

    /// <summary>Updates between two kicks.</summary>
    private const int Beat = 30;
    private const int LastBeat = 480;
    private readonly List<RevoluteJoint> _hinges = [];
    private readonly List<AngleJoint> _knees = [];
    private readonly List<AngleJoint> _hips = [];
    private Body? _trunk;
    private double _loosest;
    private double _highest;

    public override string Name => "angle-joints";

    public override string Title => "Dynamic angle joints";

    public override string Description =>
        "A spider draws in its legs and stretches them again and again, so it jumps; then it stands with its legs at their angles.";

    public override SceneView View => new(new Vector2(-6f, -1f), new Vector2(6f, 5f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 40f, 0f, 0.9f);
        _hinges.Clear();
        _knees.Clear();
        _hips.Clear();
        _loosest = 0.0;
        _highest = 0.0;
        Geom trunk = Make.Circle(simulator, new Vector2(0f, 1.6f), Trunk);
        trunk.CollisionGroup = 1;
        _trunk = trunk.Body;
        AddLeg(simulator, 1f);
        AddLeg(simulator, -1f);
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        // A new target makes a muscle turn its bones, a share of the way (its BiasFactor) in each update.
        if (step % Beat == 0 && step <= LastBeat)
        {
            bool stretch = step / Beat % 2 == 1;
            for (int leg = 0; leg < _knees.Count; leg++)
            {
                SetLeg(leg, stretch ? -0.3f : CrouchedHip);
            }
        }

        foreach (RevoluteJoint hinge in _hinges)
        {
            _loosest = Math.Max(_loosest, hinge.JointError);
        }

        _highest = step < Beat ? 0.0 : Math.Max(_highest, _trunk!.PositionY);
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double angle = 0.0;
        foreach (AngleJoint muscle in _knees)
        {
            angle = Math.Max(angle, Math.Abs(muscle.JointError));
        }

        foreach (AngleJoint muscle in _hips)
        {
            angle = Math.Max(angle, Math.Abs(muscle.JointError));
        }

        return
        [
            // Two seconds after the last change of a target the legs are at their angles, and carry the spider's weight.
            SceneOutcome.AtMost("legs off their angles (rad)", angle, 0.01),

            // Hinges are solved exactly, also while the spider lands.
            SceneOutcome.AtMost("loosest hinge in the whole run (m)", _loosest, 0.001),

            // The legs stretch to 1.55 m; what is above that is a jump.
            SceneOutcome.AtLeast("highest place of the trunk (m)", _highest, 1.8),

            // It jumps evenly with both legs, and so stays upright near where it began.
            SceneOutcome.AtMost("way to the side (m)", Math.Abs(_trunk!.PositionX), 0.5),
            SceneOutcome.AtMost("speed at the end (m/s)", _trunk.LinearVelocity.Length(), 0.05),
        ];
    }

    /// <summary>A thigh that points up and outwards, a shin that points down: two hinges, and two joints for the angles.</summary>
    private void AddLeg(PhysicsSimulator simulator, float side)
    {
        Vector2 hip = new(side * Trunk, 1.6f);
        Body thigh = AddBone(simulator, hip, side * CrouchedHip, side, out Vector2 knee);
        Body shin = AddBone(simulator, knee, side * -0.5f * MathF.PI, side, out _);

        _hinges.Add(JointFactory.Instance.CreateRevoluteJoint(simulator, _trunk!, thigh, hip));
        _hinges.Add(JointFactory.Instance.CreateRevoluteJoint(simulator, thigh, shin, knee));

        AngleJoint hipMuscle = JointFactory.Instance.CreateAngleJoint(simulator, _trunk!, thigh);
        AngleJoint kneeMuscle = JointFactory.Instance.CreateAngleJoint(simulator, thigh, shin);
        _hips.Add(hipMuscle);
        _knees.Add(kneeMuscle);
        SetLeg(_hips.Count - 1, CrouchedHip);
    }

    /// <summary>A target is the angle of the second body less that of the first. The shin is to point straight down.</summary>
    private void SetLeg(int leg, float thigh)
    {
        float side = leg == 0 ? 1f : -1f;
        _hips[leg].TargetAngle = side * thigh;
        _knees[leg].TargetAngle = -side * ((0.5f * MathF.PI) + thigh);
    }

    private static Body AddBone(PhysicsSimulator simulator, Vector2 start, float angle, float side, out Vector2 end)
    {
        Vector2 way = Length * side * new Vector2(MathF.Cos(angle), MathF.Sin(angle));
        end = start + way;
        Geom bone = Make.Box(simulator, start + (0.5f * way), Length, Width, 0.9f);
        bone.Body.Rotation = angle;

        // Parts of the spider do not collide with each other.
        bone.CollisionGroup = 1;
        return bone.Body;
    }
}
