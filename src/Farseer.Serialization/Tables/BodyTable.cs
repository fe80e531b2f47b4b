using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Serialization.Tables;

/// <summary>The members of bodies.</summary>
internal static class BodyTable
{
    /// <summary>
    /// Set while the body is in no simulator. What locks it comes before its velocities, which it would change, and its sleep last.
    /// </summary>
    public static Table<Body> All { get; } = new Table<Body>()
        .Text("name", b => b.Name, (b, v) => b.Name = v)
        .Double("x", b => b.PositionX, (b, v) => b.PositionX = v)
        .Double("y", b => b.PositionY, (b, v) => b.PositionY = v)
        .Double("rotation", Angle, (b, v) => b.SetTotalRotation(v))
        .Number("mass", b => b.Mass, (b, v) => b.Mass = v)
        .Number("momentOfInertia", b => b.MomentOfInertia, (b, v) => b.MomentOfInertia = v)
        .Choice("motionLocks", b => b.MotionLocks, (b, v) => b.MotionLocks = v)
        .Number("gravityScale", b => b.GravityScale, (b, v) => b.GravityScale = v)
        .Flag("isStatic", b => b.IsStatic, (b, v) => b.IsStatic = v)
        .Flag("isKinematic", b => b.IsKinematic, (b, v) => b.IsKinematic = v)
        .Flag("isBullet", b => b.IsBullet, (b, v) => b.IsBullet = v)
        .Flag("isContinuousCollisionEnabled", b => b.IsContinuousCollisionEnabled, (b, v) => b.IsContinuousCollisionEnabled = v)
        .Whole("iterationFactor", b => b.IterationFactor, (b, v) => b.IterationFactor = v)
        .Flag("ignoreGravity", b => b.IgnoreGravity, (b, v) => b.IgnoreGravity = v)
        .Number("linearDragCoefficient", b => b.LinearDragCoefficient, (b, v) => b.LinearDragCoefficient = v)
        .Flag("isQuadraticDragEnabled", b => b.IsQuadraticDragEnabled, (b, v) => b.IsQuadraticDragEnabled = v)
        .Number("quadraticDragCoefficient", b => b.QuadraticDragCoefficient, (b, v) => b.QuadraticDragCoefficient = v)
        .Number("rotationalDragCoefficient", b => b.RotationalDragCoefficient, (b, v) => b.RotationalDragCoefficient = v)
        .Flag("enabled", b => b.Enabled, (b, v) => b.Enabled = v)
        .Flag("isAutoIdle", b => b.IsAutoIdle, (b, v) => b.IsAutoIdle = v)
        .Number("idleTime", b => b.IdleTime, (b, v) => b.IdleTime = v)
        .Number("minimumVelocity", b => b.MinimumVelocity, (b, v) => b.MinimumVelocity = v)
        .Vector("linearVelocity", Velocity, (b, v) => b.LinearVelocity = v)
        .Number("angularVelocity", Spin, (b, v) => b.AngularVelocity = v)
        .Flag("sleepingAllowed", b => b.SleepingAllowed, (b, v) => b.SleepingAllowed = v)
        .Flag("awake", b => b.Awake, (b, v) => b.Awake = v)
        .Without(nameof(Body.Position), "x and y in full precision")
        .Without(nameof(Body.PositionX), "x")
        .Without(nameof(Body.PositionY), "y")
        .Without(nameof(Body.FixedRotation), "a member of motionLocks")
        .Without(nameof(Body.Updated), "a handler");

    private static double Angle(Body body)
    {
        body.GetTotalRotation(out double angle);
        return angle;
    }

    // Not by the public property, which wakes the body. What only stands in the way keeps the velocity that it comes back with.
    private static Vector2 Velocity(Body body) =>
        body.Link.IsAttached && !body.Link.IsSimulated ? body.Link.State.LinearVelocity : body.Link.StateRef.LinearVelocity;

    private static float Spin(Body body) =>
        body.Link.IsAttached && !body.Link.IsSimulated ? body.Link.State.AngularVelocity : body.Link.StateRef.AngularVelocity;
}
