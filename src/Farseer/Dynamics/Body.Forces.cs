using System;
using System.Numerics;
using Farseer.Engine.Bodies;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <content>Velocities, forces, torques and impulses.</content>
public partial class Body
{
    /// <summary>
    /// Velocity of the centre of mass, length/s. It is a reference: <c>body.LinearVelocity.X = 5</c> and
    /// <c>body.LinearVelocity = v</c> both work. Use the reference at once; do not keep it over an update. Default (0, 0).
    /// </summary>
    public ref Vector2 LinearVelocity => ref Link.MotionRef.LinearVelocity;

    /// <summary>Angular velocity, rad/s. It is a reference, as <see cref="LinearVelocity"/>. Default 0.</summary>
    public ref float AngularVelocity => ref Link.MotionRef.AngularVelocity;

    /// <summary>Force gathered since the last update.</summary>
    public Vector2 Force => Link.ForceRef.Force;

    /// <summary>Torque gathered since the last update.</summary>
    public float Torque => Link.ForceRef.Torque;

    internal Vector2 Impulse { get; private set => Link.Mark.Set(ref field, value); }

    /// <summary>Stored angular impulse of impulses at points.</summary>
    internal float AngularImpulse { get; private set => Link.Mark.Set(ref field, value); }

    /// <summary>Sum of offset · force of the forces at local points: how their torque changes as the body turns.</summary>
    internal float Swing { get; private set => Link.Mark.Set(ref field, value); }

    /// <summary>Adds a force at the centre of mass; it acts during the next update and is then used up.</summary>
    /// <param name="amount">Force in world axes; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The force is not finite.</exception>
    public void ApplyForce(Vector2 amount) => ApplyForce(ref amount);

    /// <summary>Adds a force at the centre of mass; it acts during the next update and is then used up.</summary>
    /// <param name="amount">Force in world axes; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The force is not finite.</exception>
    public void ApplyForce(ref Vector2 amount)
    {
        ThrowIfDisposed();
        Require.Finite(amount, nameof(amount));
        Note(nameof(ApplyForce));
        WakeFor(amount);
        Link.ForceRef.Force += amount;
    }

    /// <summary>Adds a force that acts at a point of the body.</summary>
    /// <param name="amount">Force in world axes; finite.</param>
    /// <param name="point">Point in body coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not finite.</exception>
    public void ApplyForceAtLocalPoint(Vector2 amount, Vector2 point) => ApplyForceAtLocalPoint(ref amount, ref point);

    /// <summary>Adds a force that acts at a point of the body.</summary>
    /// <param name="amount">Force in world axes; finite.</param>
    /// <param name="point">Point in body coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not finite.</exception>
    public void ApplyForceAtLocalPoint(ref Vector2 amount, ref Vector2 point)
    {
        ThrowIfDisposed();
        Require.Finite(amount, nameof(amount));
        Require.Finite(point, nameof(point));
        Note(nameof(ApplyForceAtLocalPoint));
        WakeFor(amount);
        Vector2 offset = Turned(in Link.PoseRef, point);
        AddForceAt(amount, offset);
        Swing += Vector2.Dot(offset, amount);
        Simulator?.NotePending(this);
    }

    /// <summary>Adds a force that acts at a point of the world.</summary>
    /// <param name="amount">Force in world axes; finite.</param>
    /// <param name="point">Point in world coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not finite.</exception>
    public void ApplyForceAtWorldPoint(Vector2 amount, Vector2 point) => ApplyForceAtWorldPoint(ref amount, ref point);

    /// <summary>Adds a force that acts at a point of the world.</summary>
    /// <param name="amount">Force in world axes; finite.</param>
    /// <param name="point">Point in world coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not finite.</exception>
    public void ApplyForceAtWorldPoint(ref Vector2 amount, ref Vector2 point)
    {
        ThrowIfDisposed();
        Require.Finite(amount, nameof(amount));
        Require.Finite(point, nameof(point));
        Note(nameof(ApplyForceAtWorldPoint));
        WakeFor(amount);
        AddForceAt(amount, OffsetOf(point));
    }

    /// <summary>Drops the force gathered since the last update.</summary>
    public void ClearForce() => Link.ForceRef.Force = Vector2.Zero;

    /// <summary>Adds a torque; it acts during the next update and is then used up.</summary>
    /// <param name="torque">Torque, force times length; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The torque is not finite.</exception>
    public void ApplyTorque(float torque)
    {
        ThrowIfDisposed();
        Require.Finite(torque, nameof(torque));
        Note(nameof(ApplyTorque));
        WakeFor(new Vector2(torque, 0));
        Link.ForceRef.Torque += torque;
    }

    /// <summary>Drops the torque gathered since the last update.</summary>
    public void ClearTorque()
    {
        Link.ForceRef.Torque = 0;
        Swing = 0;
    }

    /// <summary>
    /// Stores an impulse at the centre of mass; at the next update it changes the velocity by amount / mass (see
    /// <see cref="Farseer201Quirks.ImpulseDividedByMassTwice"/>).
    /// </summary>
    /// <param name="amount">Impulse, mass times velocity; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The impulse is not finite.</exception>
    public void ApplyImpulse(Vector2 amount) => ApplyImpulse(ref amount);

    /// <summary>
    /// Stores an impulse at the centre of mass; at the next update it changes the velocity by amount / mass (see
    /// <see cref="Farseer201Quirks.ImpulseDividedByMassTwice"/>).
    /// </summary>
    /// <param name="amount">Impulse, mass times velocity; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The impulse is not finite.</exception>
    public void ApplyImpulse(ref Vector2 amount)
    {
        ThrowIfDisposed();
        Require.Finite(amount, nameof(amount));
        Note(nameof(ApplyImpulse));
        WakeFor(amount);
        Impulse += amount;
        Simulator?.NotePending(this);
    }

    /// <summary>
    /// Stores an impulse that acts at a point of the world; at the next update it changes the velocity by amount / mass (see
    /// <see cref="Farseer201Quirks.ImpulseDividedByMassTwice"/>) and the angular velocity by its moment about the body / moment of inertia.
    /// (An addition to the original.)
    /// </summary>
    /// <param name="amount">Impulse in world axes, mass times velocity; finite.</param>
    /// <param name="point">Point in world coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not finite.</exception>
    public void ApplyImpulseAtWorldPoint(Vector2 amount, Vector2 point)
    {
        Require.Finite(amount, nameof(amount));
        Require.Finite(point, nameof(point));
        ApplyImpulse(ref amount);
        AddMoment(amount, OffsetOf(point));
    }

    /// <summary>
    /// Stores an impulse that acts at a point of the body: see <see cref="ApplyImpulseAtWorldPoint"/>. (An addition to the original.)
    /// </summary>
    /// <param name="amount">Impulse in world axes, mass times velocity; finite.</param>
    /// <param name="point">Point in body coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not finite.</exception>
    public void ApplyImpulseAtLocalPoint(Vector2 amount, Vector2 point)
    {
        Require.Finite(amount, nameof(amount));
        Require.Finite(point, nameof(point));
        ApplyImpulse(ref amount);
        AddMoment(amount, Turned(in Link.PoseRef, point));
    }

    /// <summary>Drops the impulse stored since the last update, with its moment.</summary>
    public void ClearImpulse()
    {
        Impulse = Vector2.Zero;
        AngularImpulse = 0;
    }

    /// <summary>Changes the angular velocity at once by amount / moment of inertia.</summary>
    /// <param name="amount">Angular impulse; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The impulse is not finite.</exception>
    public void ApplyAngularImpulse(float amount) => ApplyAngularImpulse(ref amount);

    /// <summary>Changes the angular velocity at once by amount / moment of inertia.</summary>
    /// <param name="amount">Angular impulse; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The impulse is not finite.</exception>
    public void ApplyAngularImpulse(ref float amount)
    {
        ThrowIfDisposed();
        Require.Finite(amount, nameof(amount));
        Note(nameof(ApplyAngularImpulse));
        WakeFor(new Vector2(amount, 0));
        AngularVelocity += amount * InverseMomentOfInertia;
    }

    /// <summary>Stops the body: velocities, force, torque and stored impulse become zero.</summary>
    public void ResetDynamics()
    {
        LinearVelocity = Vector2.Zero;
        AngularVelocity = 0;
        Link.ForceRef = default;
        Swing = 0;
        ClearImpulse();
    }

    /// <summary>Forgets how the torque changes, for an update in which no force acts.</summary>
    internal void DropSwing() => Swing = 0;

    /// <summary>
    /// Turns the stored impulse into velocity, and the torque of the forces at local points into its mean over the update. A force F
    /// at a point r that turns by δ has the torque r×F − δ r·F to first order; with δ(t) = ωt + αt²/2 the mean over dt is
    /// r×F − r·F (ω dt/2 + α dt²/6). Taking the torque of the start for the whole update would leave an error of first order in dt.
    /// </summary>
    internal void UsePending(float dt, bool dividedTwice)
    {
        if (Swing != 0)
        {
            ref BodyForce gathered = ref Link.ForceRef;
            float acceleration = gathered.Torque * InverseMomentOfInertia;
            gathered.Torque -= Swing * dt * ((AngularVelocity / 2) + (acceleration * dt / 6));
            Swing = 0;
        }

        float inverseMass = InverseMass;
        LinearVelocity += Impulse * (dividedTwice ? inverseMass * inverseMass : inverseMass);
        AngularVelocity += AngularImpulse * InverseMomentOfInertia;
        ClearImpulse();
    }

    /// <summary>Turns the gathered force and torque into velocity.</summary>
    internal void UseForces(float dt)
    {
        ref BodyForce gathered = ref Link.ForceRef;
        if (Enabled && (gathered.Force != Vector2.Zero || gathered.Torque != 0))
        {
            LinearVelocity += dt * InverseMass * gathered.Force;
            AngularVelocity += dt * InverseMomentOfInertia * gathered.Torque;
            gathered = default;
        }
    }

    private void WakeFor(Vector2 amount)
    {
        if (amount != Vector2.Zero)
        {
            Link.WakeUp();
        }
    }

    private void AddMoment(Vector2 impulse, Vector2 offset) => AngularImpulse += (offset.X * impulse.Y) - (offset.Y * impulse.X);

    private void AddForceAt(Vector2 force, Vector2 offset)
    {
        ref BodyForce gathered = ref Link.ForceRef;
        gathered.Force += force;
        gathered.Torque += (offset.X * force.Y) - (offset.Y * force.X);
    }
}
