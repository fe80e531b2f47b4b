using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>Eleven bodies and ten hinges with limits: a puppet falls down a flight of stairs.</summary>
public sealed class Ragdoll : Scene
{
    private const int Stairs = 6;
    private const float Friction = 0.02f;
    private static readonly Vector2 _origin = new(0.4f, 5.2f);
    private readonly List<Geom> _parts = [];
    private readonly List<RevoluteJoint> _hinges = [];
    private double _loosest;
    private double _bent;
    private double _startEnergy;
    private PhysicsSimulator? _simulator;

    public override string Name => "ragdoll";

    public override string Title => "Ragdoll";

    public override string Description =>
        "A puppet of eleven bodies tumbles down stairs: its joints hold, bend no farther than they may, and it comes to rest.";

    public override int Steps => 1200;

    public override SceneView View => new(new Vector2(-2f, -0.5f), new Vector2(10f, 7f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 40f);
        for (int i = 0; i < Stairs; i++)
        {
            float height = 0.6f * (Stairs - i);
            Make.Wall(simulator, new Vector2(0.9f * i, 0.5f * height), 0.9f, height);
        }

        Make.Wall(simulator, new Vector2(-1f, 3f), 1f, 6f);
        _simulator = simulator;
        _parts.Clear();
        _hinges.Clear();
        _loosest = 0.0;
        _bent = 0.0;

        // Places are metres from the hip; a standing person of 1.8 m.
        Body pelvis = Part(simulator, 0f, 0.05f, 0.3f, 0.2f);
        Body chest = Part(simulator, 0f, 0.42f, 0.34f, 0.5f);
        Body head = Head(simulator, 0f, 0.83f);
        Hinge(simulator, pelvis, chest, 0f, 0.16f, -0.6f, 0.6f);
        Hinge(simulator, chest, head, 0f, 0.69f, -0.7f, 0.7f);
        for (int side = -1; side <= 1; side += 2)
        {
            Body upperArm = Part(simulator, side * 0.35f, 0.6f, 0.34f, 0.11f);
            Body foreArm = Part(simulator, side * 0.67f, 0.6f, 0.34f, 0.09f);
            Hinge(simulator, chest, upperArm, side * 0.19f, 0.6f, -1.5f, 1.5f);

            // An elbow bends one way only: up, from the arm held out sideways.
            Hinge(simulator, upperArm, foreArm, side * 0.51f, 0.6f, side > 0 ? 0f : -2.4f, side > 0 ? 2.4f : 0f);
            Body thigh = Part(simulator, side * 0.09f, -0.27f, 0.14f, 0.46f);
            Body shin = Part(simulator, side * 0.09f, -0.7f, 0.11f, 0.44f);
            Hinge(simulator, pelvis, thigh, side * 0.09f, -0.05f, -0.9f, 0.9f);
            Hinge(simulator, thigh, shin, side * 0.09f, -0.49f, side > 0 ? -2.2f : 0f, side > 0 ? 0f : 2.2f);
        }

        // A push to the stairs' side, so that it does not just sit down.
        foreach (Geom part in _parts)
        {
            part.Body.LinearVelocity = new Vector2(2.5f, 0f);
        }

        _startEnergy = 0.0;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        // The bodies are in the simulator from its first update on.
        _startEnergy = step == 1 ? Measure.Energy(simulator) : _startEnergy;
        foreach (RevoluteJoint hinge in _hinges)
        {
            _loosest = Math.Max(_loosest, hinge.JointError);
            _bent = Math.Max(_bent, Math.Max(hinge.LowerLimit - hinge.JointAngle, hinge.JointAngle - hinge.UpperLimit));
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double loosest = 0.0;
        foreach (RevoluteJoint hinge in _hinges)
        {
            loosest = Math.Max(loosest, hinge.JointError);
        }

        double lowest = double.MaxValue;
        foreach (Geom part in _parts)
        {
            lowest = Math.Min(lowest, part.AABB.Min.Y);
        }

        return
        [
            SceneOutcome.Exactly("bodies", _parts.Count, 11),

            // A limb that is stopped on its way opens its hinge for an update; at rest hinges are exact.
            SceneOutcome.AtMost("loosest hinge in the whole run (m)", _loosest, 0.02),
            SceneOutcome.AtMost("loosest hinge at the end (m)", loosest, 1e-5),

            // Half a degree, for one update, at a hard landing.
            SceneOutcome.AtMost("farthest past a limit in the whole run (rad)", _bent, 0.01),
            SceneOutcome.AtLeast("lowest point of a part (m)", lowest, -2.0 * Make.Tolerance),
            SceneOutcome.AtMost("energy gained (J)", Measure.Energy(_simulator!) - _startEnergy, 0.0),

            // The friction of its joints brings it to rest, and nothing trembles.
            SceneOutcome.AtMost("fastest point at the end (m/s)", Measure.FastestSpeed(_parts), 1e-3),
        ];
    }

    private Body Part(PhysicsSimulator simulator, float x, float y, float width, float height) =>
        Add(Make.Box(simulator, _origin + new Vector2(x, y), width, height));

    private Body Head(PhysicsSimulator simulator, float x, float y) => Add(Make.Circle(simulator, _origin + new Vector2(x, y), 0.13f));

    private Body Add(Geom part)
    {
        // Parts of one puppet do not collide: the limits keep them apart.
        part.CollisionGroup = 1;
        _parts.Add(part);
        return part.Body;
    }

    /// <summary>Limits are angles of the second body to the first, counted from how they are now.</summary>
    private void Hinge(PhysicsSimulator simulator, Body first, Body second, float x, float y, float lower, float upper)
    {
        RevoluteJoint hinge = JointFactory.Instance.CreateRevoluteJoint(simulator, first, second, _origin + new Vector2(x, y));
        hinge.LowerLimit = lower;
        hinge.UpperLimit = upper;
        hinge.AreLimitsEnabled = true;

        // Friction: a motor that wants to stand still and is too weak for more than that.
        hinge.IsMotorEnabled = true;
        hinge.MaxMotorTorque = Friction;
        _hinges.Add(hinge);
    }
}
