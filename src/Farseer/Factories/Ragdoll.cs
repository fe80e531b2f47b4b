using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Factories;

/// <summary>
/// A figure of eleven limbs, hinged where a human's are and with the limits of their joints. It is seen from the side, facing +x, and
/// stands in the direction of up. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// Ragdoll ragdoll = Ragdoll.Create(simulator, new Vector2(0, 3), height: 1.8f, mass: 70);
/// ragdoll.Chest.ApplyImpulse(new Vector2(150, 50));
/// </code>
/// </example>
public sealed class Ragdoll
{
    private readonly PhysicsSimulator _simulator;
    private readonly Vector2 _up;
    private readonly Vector2 _front;
    private readonly Vector2 _middle;
    private readonly float _height;
    private readonly float _mass;
    private readonly int _group;

    private Ragdoll(PhysicsSimulator simulator, Vector2 position, float height, float mass, Vector2 up)
    {
        _simulator = simulator;
        _middle = position;
        _height = height;
        _mass = mass;
        _up = up;
        _front = new Vector2(up.Y, -up.X);
        _group = -Geom.GetNextId();
    }

    /// <summary>All limbs, from the chest outwards.</summary>
    public IReadOnlyList<Body> Bodies => _bodies;

    /// <summary>
    /// All hinges. Their limits are on; set <see cref="RevoluteJoint.MaxMotorTorque"/> or springs of your own to make it stiff.
    /// </summary>
    public IReadOnlyList<RevoluteJoint> Joints => _joints;

    /// <summary>The chest, the heaviest limb.</summary>
    public Body Chest => _bodies[0];

    /// <summary>The head.</summary>
    public Body Head => _bodies[1];

    private readonly List<Body> _bodies = new List<Body>();
    private readonly List<RevoluteJoint> _joints = new List<RevoluteJoint>();

    /// <summary>Makes a figure and adds it to the simulator.</summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <param name="position">Its middle, halfway between feet and head, in world coordinates; finite.</param>
    /// <param name="height">From feet to head, a length of the scene; finite and above 0.</param>
    /// <param name="mass">Of all limbs together; finite and above 0.</param>
    /// <returns>The figure.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the range given above.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public static Ragdoll Create(PhysicsSimulator physicsSimulator, Vector2 position, float height, float mass) =>
        Create(physicsSimulator, position, height, mass, new Vector2(0, 1));

    /// <summary>Makes a figure that stands in a given direction and adds it to the simulator.</summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <param name="position">Its middle, halfway between feet and head, in world coordinates; finite.</param>
    /// <param name="height">From feet to head, a length of the scene; finite and above 0.</param>
    /// <param name="mass">Of all limbs together; finite and above 0.</param>
    /// <param name="up">The direction, of any length; finite and not (0, 0). (0, -1) where y points down.</param>
    /// <returns>The figure.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the range given above.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public static Ragdoll Create(PhysicsSimulator physicsSimulator, Vector2 position, float height, float mass, Vector2 up)
    {
        Require.NotNull(physicsSimulator, nameof(physicsSimulator)).ThrowIfDisposed();
        Require.Place(position, nameof(position));
        Require.Length(height, nameof(height));
        Require.Invertible(mass, nameof(mass));
        var ragdoll = new Ragdoll(physicsSimulator, position, height, mass, Require.Direction(up, nameof(up)));
        ragdoll.Build();
        return ragdoll;
    }

    // Shares of the height from the middle upwards and of the mass, after the tables of human figures.
    private void Build()
    {
        Body chest = Limb(0.04f, 0.28f, 0.075f, 0.35f);
        Body head = Limb(0.38f, 0.44f, 0.06f, 0.08f);
        Hinge(chest, head, 0.33f, -0.6f, 0.6f);
        Body pelvis = Limb(-0.03f, 0.01f, 0.07f, 0.13f);
        Hinge(chest, pelvis, 0.02f, -0.5f, 0.9f);
        for (int side = 0; side < 2; side++)
        {
            Body upper = Limb(0.14f, 0.28f, 0.028f, 0.03f);
            Hinge(chest, upper, 0.29f, -1f, 3f);
            Body lower = Limb(-0.02f, 0.1f, 0.023f, 0.025f);
            Hinge(upper, lower, 0.12f, 0, 2.4f);
        }

        for (int side = 0; side < 2; side++)
        {
            Body thigh = Limb(-0.24f, -0.05f, 0.042f, 0.1f);
            Hinge(pelvis, thigh, -0.02f, -0.4f, 2f);
            Body shin = Limb(-0.46f, -0.28f, 0.032f, 0.065f);
            Hinge(thigh, shin, -0.26f, -2.4f, 0);
        }
    }

    private Body Limb(float from, float to, float radius, float share)
    {
        float length = (to - from) * _height;
        Body body = BodyFactory.Instance.CreateCapsuleBody(_simulator, length, radius * _height, share * _mass);
        body.Position = At((from + to) / 2);
        Vector2 half = 0.5f * length * _up;
        Geom geom = GeomFactory.Instance.CreateCapsuleGeom(_simulator, body, -half, half, radius * _height);
        geom.CollisionGroup = _group;
        geom.FrictionCoefficient = 0.5f;
        _bodies.Add(body);
        return body;
    }

    /// <summary>Limits are turns of the second limb towards the front.</summary>
    private void Hinge(Body first, Body second, float place, float back, float front)
    {
        RevoluteJoint joint = JointFactory.Instance.CreateRevoluteJoint(_simulator, first, second, At(place));
        bool leftward = (_front.X * _up.Y) - (_front.Y * _up.X) > 0;
        joint.LowerLimit = leftward ? back : -front;
        joint.UpperLimit = leftward ? front : -back;
        joint.AreLimitsEnabled = true;
        joint.CollideConnected = false;
        _joints.Add(joint);
    }

    private Vector2 At(float share) => _middle + (share * _height * _up);
}
