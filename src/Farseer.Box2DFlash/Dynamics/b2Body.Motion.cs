using System;
using System.Numerics;
using Box2D.Bridge;
using Box2D.Common.Math;

namespace Box2D.Dynamics;

/// <content>Velocities, forces and frames.</content>
public partial class b2Body
{
    /// <summary>Sets the velocity of the centre of mass.</summary>
    /// <param name="v">The velocity, m/s.</param>
    /// <exception cref="ArgumentException"><paramref name="v"/> is null or not finite.</exception>
    public void SetLinearVelocity(b2Vec2 v)
    {
        Require.Vector(v, nameof(v));
        Link.Velocity = Of(v);
        WakeBySetter();
    }

    /// <summary>The velocity of the centre of mass, m/s: the velocity itself, so that setting a component of it sets it.</summary>
    /// <returns>The velocity, which follows the body.</returns>
    public b2Vec2 GetLinearVelocity() => _velocity;

    /// <summary>Sets the angular velocity.</summary>
    /// <param name="omega">rad/s, within ±9.2·10¹⁸; counter-clockwise is positive.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="omega"/> is not finite or out of its range.</exception>
    public void SetAngularVelocity(float omega)
    {
        Require.Turn(omega, nameof(omega));
        Link.Spin = omega;
        WakeBySetter();
    }

    /// <summary>The angular velocity, rad/s.</summary>
    /// <returns>Positive counter-clockwise.</returns>
    public float GetAngularVelocity() => Link.Spin;

    /// <summary>The rate by which the velocity dies away, 1/s. (An addition to the original.)</summary>
    /// <returns>0 or more.</returns>
    public float GetLinearDamping() => Link.LinearDamping;

    /// <summary>Sets the rate by which the velocity dies away. (An addition to the original, whose field was written to.)</summary>
    /// <param name="damping">1/s; finite and 0 or more, usually 0 to 1.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="damping"/> is negative or not finite.</exception>
    public void SetLinearDamping(float damping) => Link.LinearDamping = Require.NotNegative(damping, nameof(damping));

    /// <summary>The rate by which the angular velocity dies away, 1/s. (An addition to the original.)</summary>
    /// <returns>0 or more.</returns>
    public float GetAngularDamping() => Link.AngularDamping;

    /// <summary>Sets the rate by which the angular velocity dies away. (An addition to the original, whose field was written to.)</summary>
    /// <param name="damping">1/s; finite and 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="damping"/> is negative or not finite.</exception>
    public void SetAngularDamping(float damping) => Link.AngularDamping = Require.NotNegative(damping, nameof(damping));

    /// <summary>Lets a force act in the next step. Off the centre of mass it turns the body too. It wakes the body.</summary>
    /// <param name="force">The force, newtons, in the world.</param>
    /// <param name="point">The point at which it acts, in the world.</param>
    /// <exception cref="ArgumentException">A vector is null or not finite.</exception>
    public void ApplyForce(b2Vec2 force, b2Vec2 point)
    {
        Require.Vector(force, nameof(force));
        Require.Vector(point, nameof(point));
        WakeUp();
        Link.Arm(point.x, point.y, out double rx, out double ry);
        Link.AddForce(force.x, force.y, (rx * force.y) - (ry * force.x));
    }

    /// <summary>Lets a torque act in the next step. It wakes the body.</summary>
    /// <param name="torque">N·m, finite; counter-clockwise is positive.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="torque"/> is not finite.</exception>
    public void ApplyTorque(float torque)
    {
        Require.Finite(torque, nameof(torque));
        WakeUp();
        Link.AddForce(0, 0, torque);
    }

    /// <summary>Changes the velocity at once, by a blow at a point. It wakes the body.</summary>
    /// <param name="impulse">The impulse, N·s, in the world.</param>
    /// <param name="point">The point at which it acts, in the world.</param>
    /// <exception cref="ArgumentException">A vector is null or not finite.</exception>
    public void ApplyImpulse(b2Vec2 impulse, b2Vec2 point)
    {
        Require.Vector(impulse, nameof(impulse));
        Require.Vector(point, nameof(point));
        WakeUp();
        Link.Arm(point.x, point.y, out double rx, out double ry);
        Link.AddImpulse(impulse.x, impulse.y, (rx * impulse.y) - (ry * impulse.x));
    }

    /// <summary>A point of the body in the world.</summary>
    /// <param name="localPoint">The point in the body.</param>
    /// <returns>A new vector.</returns>
    /// <exception cref="ArgumentException"><paramref name="localPoint"/> is null or not finite.</exception>
    public b2Vec2 GetWorldPoint(b2Vec2 localPoint)
    {
        Require.Vector(localPoint, nameof(localPoint));
        Link.ToWorld(localPoint.x, localPoint.y, out double x, out double y);
        return new b2Vec2((float)x, (float)y);
    }

    /// <summary>A direction of the body in the world.</summary>
    /// <param name="localVector">The direction in the body.</param>
    /// <returns>A new vector.</returns>
    /// <exception cref="ArgumentException"><paramref name="localVector"/> is null or not finite.</exception>
    public b2Vec2 GetWorldVector(b2Vec2 localVector)
    {
        Require.Vector(localVector, nameof(localVector));
        return b2Math.b2MulMV(_xf.R, localVector);
    }

    /// <summary>A point of the world in the body.</summary>
    /// <param name="worldPoint">The point in the world.</param>
    /// <returns>A new vector.</returns>
    /// <exception cref="ArgumentException"><paramref name="worldPoint"/> is null or not finite.</exception>
    public b2Vec2 GetLocalPoint(b2Vec2 worldPoint)
    {
        Require.Vector(worldPoint, nameof(worldPoint));
        Link.ToLocal(worldPoint.x, worldPoint.y, out double x, out double y);
        return new b2Vec2((float)x, (float)y);
    }

    /// <summary>A direction of the world in the body.</summary>
    /// <param name="worldVector">The direction in the world.</param>
    /// <returns>A new vector.</returns>
    /// <exception cref="ArgumentException"><paramref name="worldVector"/> is null or not finite.</exception>
    public b2Vec2 GetLocalVector(b2Vec2 worldVector)
    {
        Require.Vector(worldVector, nameof(worldVector));
        return b2Math.b2MulTMV(_xf.R, worldVector);
    }

    /// <summary>The velocity of the body at a point of the world.</summary>
    /// <param name="worldPoint">The point.</param>
    /// <returns>A new vector, m/s.</returns>
    /// <exception cref="ArgumentException"><paramref name="worldPoint"/> is null or not finite.</exception>
    public b2Vec2 GetLinearVelocityFromWorldPoint(b2Vec2 worldPoint)
    {
        Require.Vector(worldPoint, nameof(worldPoint));
        Link.Arm(worldPoint.x, worldPoint.y, out double rx, out double ry);
        return new b2Vec2((float)(Link.Velocity.X - (Link.Spin * ry)), (float)(Link.Velocity.Y + (Link.Spin * rx)));
    }

    /// <summary>The velocity of the body at a point of it; see <see cref="Box2DFlash202Quirks.LocalPointVelocity"/>.</summary>
    /// <param name="localPoint">The point, in the body.</param>
    /// <returns>A new vector, m/s.</returns>
    /// <exception cref="ArgumentException"><paramref name="localPoint"/> is null or not finite.</exception>
    public b2Vec2 GetLinearVelocityFromLocalPoint(b2Vec2 localPoint)
    {
        Require.Vector(localPoint, nameof(localPoint));
        Link.ToWorld(localPoint.x, localPoint.y, out double x, out double y);
        Link.Arm(x, y, out double rx, out double ry);
        Vector2 velocity = VelocityAtArm(rx, ry);
        return new b2Vec2(velocity.X, velocity.Y);
    }

    /// <summary>Whether the body is a bullet.</summary>
    /// <returns>The flag.</returns>
    public bool IsBullet() => Link.IsBullet;

    /// <summary>Makes the body a bullet: it does not pass through other moving bodies either. It costs time.</summary>
    /// <param name="flag">True for a bullet.</param>
    /// <exception cref="InvalidOperationException">The body is destroyed.</exception>
    public void SetBullet(bool flag)
    {
        CheckAlive();
        Link.IsBullet = flag;
    }

    /// <summary>As the original's contact points have it where the quirk is on, whose formula is that of the local point.</summary>
    internal Vector2 VelocityAtArm(double rx, double ry)
    {
        if ((World.Quirks & Box2DFlash202Quirks.LocalPointVelocity) != 0)
        {
            return new Vector2((float)(Link.Velocity.X + (Link.Spin * ry)), (float)(Link.Velocity.X - (Link.Spin * rx)));
        }

        return new Vector2((float)(Link.Velocity.X - (Link.Spin * ry)), (float)(Link.Velocity.Y + (Link.Spin * rx)));
    }

    internal void WakeBySetter()
    {
        if ((World.Quirks & Box2DFlash202Quirks.SettersWakeNobody) == 0)
        {
            WakeUp();
        }
    }
}
