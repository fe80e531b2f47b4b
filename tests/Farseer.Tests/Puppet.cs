using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Tests;

/// <summary>A ragdoll of eleven bodies, 2 m high, whose hinges turn by 45 degrees either way; y up.</summary>
internal sealed class Puppet
{
    private readonly PhysicsSimulator _simulator;

    /// <param name="simulator">Where it is to be.</param>
    /// <param name="feet">Between its feet.</param>
    public Puppet(PhysicsSimulator simulator, Vector2 feet)
    {
        _simulator = simulator;
        Geom torso = Box(feet, 0, 1.35f, 0.4f, 0.6f);
        Geom pelvis = Box(feet, 0, 0.9f, 0.4f, 0.3f);
        Geom head = Sandbox.Ball(simulator, feet + new Vector2(0, 1.85f), 0.2f, 0.126f, 32);
        Add(head);
        Join(torso, pelvis, feet, 0, 1.05f);
        Join(torso, head, feet, 0, 1.65f);
        for (int side = -1; side <= 1; side += 2)
        {
            Geom upperArm = Box(feet, 0.28f * side, 1.4f, 0.12f, 0.4f);
            Geom lowerArm = Box(feet, 0.28f * side, 1, 0.12f, 0.4f);
            Geom upperLeg = Box(feet, 0.12f * side, 0.55f, 0.14f, 0.4f);
            Geom lowerLeg = Box(feet, 0.12f * side, 0.15f, 0.14f, 0.4f);
            Join(torso, upperArm, feet, 0.28f * side, 1.6f);
            Join(upperArm, lowerArm, feet, 0.28f * side, 1.2f);
            Join(pelvis, upperLeg, feet, 0.12f * side, 0.75f);
            Join(upperLeg, lowerLeg, feet, 0.12f * side, 0.35f);
        }
    }

    public List<Geom> Geoms { get; } = [];

    public List<RevoluteJoint> Hinges { get; } = [];

    private Geom Box(Vector2 feet, float x, float y, float width, float height) =>
        Add(Sandbox.Box(_simulator, feet + new Vector2(x, y), width, height, width * height));

    private Geom Add(Geom geom)
    {
        geom.FrictionCoefficient = 0.6f;
        geom.RestitutionCoefficient = 0;
        Geoms.Add(geom);
        return geom;
    }

    private void Join(Geom a, Geom b, Vector2 feet, float x, float y)
    {
        RevoluteJoint joint = JointFactory.Instance.CreateRevoluteJoint(_simulator, a.Body, b.Body, feet + new Vector2(x, y));
        joint.AreLimitsEnabled = true;
        joint.LowerLimit = -0.785398f;
        joint.UpperLimit = 0.785398f;
        Hinges.Add(joint);
    }
}
