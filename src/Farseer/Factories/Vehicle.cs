using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Factories;

/// <summary>A car seen from the side: a chassis and two sprung wheels with motors. (An addition to the original.)</summary>
/// <example>
/// <code>
/// Vehicle car = Vehicle.Create(simulator, new Vector2(0, 1), length: 4, mass: 1000);
/// // In each step: 20 m/s forwards, with at most 900 N·m a wheel.
/// car.Drive(20, 900);
/// </code>
/// </example>
public sealed class Vehicle
{
    private readonly WheelJoint[] _axles;
    private readonly Body[] _wheels;
    private readonly float _radius;
    private readonly float _sense;

    private Vehicle(Body chassis, Body[] wheels, WheelJoint[] axles, float radius, float sense)
    {
        Chassis = chassis;
        _wheels = wheels;
        _axles = axles;
        _radius = radius;
        _sense = sense;
    }

    /// <summary>The chassis.</summary>
    public Body Chassis { get; }

    /// <summary>The wheels, the rear one first.</summary>
    public IReadOnlyList<Body> Wheels => _wheels;

    /// <summary>The suspension of each wheel: set frequency and damping there.</summary>
    public IReadOnlyList<WheelJoint> Axles => _axles;

    /// <summary>Makes a car that faces +x and stands on y and adds it to the simulator.</summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <param name="position">Middle of the chassis, in world coordinates; finite. The wheels reach 0.3 of the length below it.</param>
    /// <param name="length">Length of the chassis; finite and above 0.</param>
    /// <param name="mass">Of all together; finite and above 0. A tenth of it is in each wheel.</param>
    /// <returns>The car.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the range given above.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public static Vehicle Create(PhysicsSimulator physicsSimulator, Vector2 position, float length, float mass) =>
        Create(physicsSimulator, position, length, mass, new Vector2(0, 1));

    /// <summary>Makes a car that stands in a given direction and adds it to the simulator.</summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <param name="position">Middle of the chassis, in world coordinates; finite. The wheels reach 0.3 of the length below it.</param>
    /// <param name="length">Length of the chassis; finite and above 0.</param>
    /// <param name="mass">Of all together; finite and above 0. A tenth of it is in each wheel.</param>
    /// <param name="up">The direction, of any length; finite and not (0, 0). (0, -1) where y points down; the car faces (1, 0) in
    /// both.</param>
    /// <returns>The car.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the range given above.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public static Vehicle Create(PhysicsSimulator physicsSimulator, Vector2 position, float length, float mass, Vector2 up)
    {
        Require.NotNull(physicsSimulator, nameof(physicsSimulator)).ThrowIfDisposed();
        Require.Place(position, nameof(position));
        Require.Length(length, nameof(length));
        Require.Invertible(mass, nameof(mass));
        Vector2 above = Require.Direction(up, nameof(up));
        var front = new Vector2(above.Y, -above.X);
        front = front.X < 0 ? -front : front;
        float radius = 0.12f * length;
        int group = -Geom.GetNextId();
        Body chassis = BodyFactory.Instance.CreateRectangleBody(physicsSimulator, length, 0.25f * length, 0.8f * mass);
        chassis.Position = position;
        chassis.Rotation = (float)StableMath.Atan2(front.Y, (double)front.X);
        Geom hull = GeomFactory.Instance.CreateRectangleGeom(physicsSimulator, chassis, length, 0.25f * length);
        hull.CollisionGroup = group;
        hull.FrictionCoefficient = 0.3f;
        var wheels = new Body[2];
        var axles = new WheelJoint[2];
        for (int i = 0; i < 2; i++)
        {
            Vector2 hub = position + ((i == 0 ? -0.32f : 0.32f) * length * front) - (0.18f * length * above);
            wheels[i] = BodyFactory.Instance.CreateCircleBody(physicsSimulator, radius, 0.1f * mass);
            wheels[i].Position = hub;
            Geom tyre = GeomFactory.Instance.CreateCircleGeom(physicsSimulator, wheels[i], radius, 24);
            tyre.FrictionCoefficient = 1.5f;
            tyre.CollisionGroup = group;
            axles[i] = JointFactory.Instance.CreateWheelJoint(physicsSimulator, chassis, wheels[i], hub, above);
            axles[i].Frequency = 4;
            axles[i].IsMotorEnabled = true;
        }

        float sense = (above.X * front.Y) - (above.Y * front.X) < 0 ? -1 : 1;
        return new Vehicle(chassis, wheels, axles, radius, sense);
    }

    /// <summary>Drives or brakes: the motors turn the wheels towards a speed.</summary>
    /// <param name="speed">Speed over ground, length/s; finite. Forwards if positive, backwards if negative; 0 brakes.</param>
    /// <param name="torque">Largest torque of each wheel, force times length; finite and at least 0. 0 lets them roll.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the range given above.</exception>
    public void Drive(float speed, float torque)
    {
        Require.Finite(speed, nameof(speed));
        Require.NotNegative(torque, nameof(torque));
        foreach (WheelJoint axle in _axles)
        {
            axle.MotorSpeed = _sense * speed / _radius;
            axle.MaxMotorTorque = torque;
        }
    }
}
