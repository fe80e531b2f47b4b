using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// Reacts to forces, torques and impulses. A body has no shape; attach one or more <see cref="Geom"/> objects to let it collide.
/// All members work before the body is added to a <see cref="PhysicsSimulator"/> and after it is removed. Units are the
/// scene's own; angles are radians, a positive one turns the x axis towards the y axis.
/// </summary>
/// <example>
/// <code>
/// Body box = BodyFactory.Instance.CreateRectangleBody(simulator, 2, 1, mass: 5);
/// box.Position = new Vector2(0, 3);
/// box.LinearDragCoefficient = 0;
/// box.ApplyImpulse(new Vector2(10, 0));
/// </code>
/// </example>
public partial class Body : IDisposable, IStatePart
{
    internal const float DefaultDrag = 0.001f;

    internal BodyLink Link = new BodyLink();

    /// <summary>The geom, or a list of several: nearly all bodies have one.</summary>
    private object? _geoms;

    /// <summary>Null until somebody wants one of them.</summary>
    private BodyExtras? _extras;

    /// <summary>Makes a body of mass 1 and moment of inertia 1 at the origin.</summary>
    public Body()
    {
        Link.Mass = new BodyMass { Mass = 1, Inertia = 1 };
        Link.Drag = new BodyDrag { Linear = DefaultDrag, Quadratic = DefaultDrag, Rotational = DefaultDrag };
        Link.UserFlags = BodyFlags.Enabled;
        Link.Pose.Cos = 1;
        Link.State.DeltaCos = 1;
    }

    /// <summary>
    /// Makes a body with the mass, the moment of inertia and the linear and rotational drag coefficients of another; nothing
    /// else is copied.
    /// </summary>
    /// <param name="body">The body to copy.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    public Body(Body body)
        : this()
    {
        Require.NotNull(body, nameof(body));
        Mass = body.Mass;
        MomentOfInertia = body.MomentOfInertia;
        LinearDragCoefficient = body.LinearDragCoefficient;
        RotationalDragCoefficient = body.RotationalDragCoefficient;
    }

    /// <summary>Handles a change of a body's position.</summary>
    /// <param name="position">The new position.</param>
    /// <param name="rotation">The new rotation, radians.</param>
    public delegate void UpdatedEventHandler(ref Vector2 position, ref float rotation);

    /// <summary>Raised when the body is disposed.</summary>
    public event EventHandler<EventArgs>? Disposed
    {
        add => Extras.Disposed += value;
        remove => Extras.Disposed -= value;
    }

    /// <summary>Called when the body has moved in an update, and when its position or rotation is set. Use with +=. Default null.</summary>
    public UpdatedEventHandler? Updated
    {
        get => _extras?.Updated;
        set
        {
            if (value is not null || _extras is not null)
            {
                Extras.Updated = value;
            }

            Simulator?.NoteListener(this);
        }
    }

    /// <summary>Anything that you want to keep with the body. Default null.</summary>
    public object? Tag
    {
        get => _extras?.Tag;
        set
        {
            if (value is not null || _extras is not null)
            {
                Extras.Tag = value;
            }
        }
    }

    /// <summary>
    /// A name of your own, which debuggers and reports show. Default null. (Of neighbouring versions of the original.)
    /// </summary>
    public string? Name
    {
        get => _extras?.Name;
        set
        {
            if (value is not null || _extras is not null)
            {
                Extras.Name = value;
            }
        }
    }

    /// <summary>True once <see cref="Dispose()"/> was called.</summary>
    public bool IsDisposed { get; private set => Link.Mark.Set(ref field, value); }

    /// <summary>Mass; finite and above 0. Default 1. A static body keeps its mass, but acts as if it were infinite.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or not above 0.</exception>
    public float Mass
    {
        get => Link.MassRef.Mass;
        set => SetMass(Require.Invertible(value, nameof(Mass)), MomentOfInertia);
    }

    /// <summary>Moment of inertia about the body's position, mass times length squared; finite and above 0. Default 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or not above 0.</exception>
    public float MomentOfInertia
    {
        get => _extras is { FixedInertia: > 0 } ? _extras.FixedInertia : Link.MassRef.Inertia;
        set => SetMass(Mass, Require.Invertible(value, nameof(MomentOfInertia)));
    }

    /// <summary>1 / <see cref="Mass"/>, or 0 for a static or kinematic body.</summary>
    public float InverseMass => HasInfiniteMass && !IsStaticBySensor ? 0 : 1 / Mass;

    /// <summary>1 / <see cref="MomentOfInertia"/>, or 0 for a static or kinematic body and one of <see cref="FixedRotation"/>.</summary>
    public float InverseMomentOfInertia => (HasInfiniteMass && !IsStaticBySensor) || FixedRotation ? 0 : 1 / MomentOfInertia;

    /// <summary>False takes the body and its geoms out of motion and collision until it is true again. Default true.</summary>
    public bool Enabled
    {
        get => (Link.UserFlags & BodyFlags.Enabled) != 0;
        set
        {
            SetFlag(BodyFlags.Enabled, value);
            IsQuarantined = false;
            Idle &= ~IdleState.Disabled;
        }
    }

    /// <summary>
    /// True once the simulator has disabled the body because its velocity or position was no longer a number; see
    /// <see cref="PhysicsSimulator.BodyQuarantined"/>. Setting <see cref="Enabled"/> makes it false. (An addition to the original.)
    /// </summary>
    public bool IsQuarantined { get; private set => Link.Mark.Set(ref field, value); }

    /// <summary>A static body never moves by itself and acts as infinitely heavy. Default false.</summary>
    public bool IsStatic
    {
        get => (Link.UserFlags & BodyFlags.Static) != 0;
        set
        {
            SetFlag(BodyFlags.Static, value);
            IsStaticBySensor = false;
        }
    }

    /// <summary>
    /// A kinematic body moves with the velocity that it is given and nothing slows or turns it: a lift, a door. Default false.
    /// (An addition to the original.)
    /// </summary>
    public bool IsKinematic
    {
        get => (Link.UserFlags & BodyFlags.Kinematic) != 0;
        set => SetFlag(BodyFlags.Kinematic, value);
    }

    /// <summary>
    /// True makes the body a bullet, which passes through nothing, however fast, not even through bodies that move. Other bodies never pass
    /// through static and kinematic ones; through one that moves they pass only if something deflects or speeds them up within the update
    /// in which they would meet it. Costs time only in updates in which the body moves by more than its own size. Default false. (An
    /// addition to the original.)
    /// </summary>
    public bool IsBullet
    {
        get => (Link.UserFlags & BodyFlags.Bullet) != 0;
        set => SetFlag(BodyFlags.Bullet, value);
    }

    /// <summary>
    /// False leaves the body out of continuous collision, as for debris that may get lost: in an update in which it moves by more than its
    /// own size it meets only what it touches when the update begins, and may pass through the rest. Default true. See
    /// <see cref="PhysicsSimulator.IsContinuousCollisionEnabled"/>. (An addition to the original.)
    /// </summary>
    public bool IsContinuousCollisionEnabled
    {
        get => (Link.UserFlags & BodyFlags.Discrete) == 0;
        set => SetFlag(BodyFlags.Discrete, !value);
    }

    /// <summary>
    /// Factor on <see cref="PhysicsSimulator.Iterations"/> for the body and all that is connected with it by contacts or joints: 1, 2, 4, 8
    /// or 16. Where several are set the largest counts; that of a kinematic body counts for all that touches it or hangs on it. 0 leaves
    /// the choice to the simulator: see <see cref="PhysicsSimulator.AdaptIterations"/>. It has no effect on bodies without contacts and
    /// joints, which are exact anyway, nor on springs and closed loops of joints, which keep to the simulator's iterations. Default 0. (An
    /// addition to the original.)
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not 0, 1, 2, 4, 8 or 16.</exception>
    public int IterationFactor
    {
        get => ChosenSubsteps.Read(Link.UserFlags);
        set
        {
            ThrowIfDisposed();
            if (!ChosenSubsteps.IsChoice(value))
            {
                throw Require.Range(nameof(IterationFactor), value, "must be 0, 1, 2, 4, 8 or 16");
            }

            Link.SetUserFlags(ChosenSubsteps.Write(Link.UserFlags, value));
        }
    }

    /// <summary>True switches gravity off for this body. Default false.</summary>
    public bool IgnoreGravity
    {
        get => (Link.UserFlags & BodyFlags.IgnoreGravity) != 0;
        set => SetFlag(BodyFlags.IgnoreGravity, value);
    }

    /// <summary>True adds quadratic drag to the linear one. Default false.</summary>
    public bool IsQuadraticDragEnabled
    {
        get => (Link.UserFlags & BodyFlags.QuadraticDrag) != 0;
        set => SetFlag(BodyFlags.QuadraticDrag, value);
    }

    /// <summary>c of the drag force −c·v; at least 0. Default 0.001.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float LinearDragCoefficient
    {
        get => Link.DragRef.Linear;
        set => Link.DragRef.Linear = Require.NotNegative(value, nameof(LinearDragCoefficient));
    }

    /// <summary>q of the drag force −q·|v|·v, used while <see cref="IsQuadraticDragEnabled"/>; at least 0. Default 0.001.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float QuadraticDragCoefficient
    {
        get => Link.DragRef.Quadratic;
        set => Link.DragRef.Quadratic = Require.NotNegative(value, nameof(QuadraticDragCoefficient));
    }

    /// <summary>r of the drag torque −r·ω·|ω|; at least 0. Default 0.001.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float RotationalDragCoefficient
    {
        get => Link.DragRef.Rotational;
        set => Link.DragRef.Rotational = Require.NotNegative(value, nameof(RotationalDragCoefficient));
    }

    /// <summary>
    /// False while the body sleeps: it rests, together with all that it is connected with, and costs nothing until something wakes it; see
    /// <see cref="PhysicsSimulator.AllowSleep"/>. Setting it to true wakes the body, or makes an awake one begin its rest anew. Setting it
    /// to false stops the body and puts it to sleep at once, or as soon as it is in a simulator; that has no effect where the body may not
    /// sleep, and does not last while something awake touches it. Default true. (An addition to the original.)
    /// </summary>
    /// <exception cref="ObjectDisposedException">The body is disposed.</exception>
    public bool Awake
    {
        get => Link.IsAwake;
        set
        {
            ThrowIfDisposed();
            if (value)
            {
                Link.WakeUp();
            }
            else
            {
                Link.PutToSleep();
            }
        }
    }

    /// <summary>
    /// False keeps the body, and all that it is in touch with, from falling asleep. It counts only while
    /// <see cref="PhysicsSimulator.AllowSleep"/> is true. Default true. (An addition to the original.)
    /// </summary>
    public bool SleepingAllowed
    {
        get => (Link.UserFlags & BodyFlags.NeverSleeps) == 0;
        set => SetFlag(BodyFlags.NeverSleeps, !value);
    }

    /// <summary>True lets an inactivity controller disable the body when it rests. Default false.</summary>
    public bool IsAutoIdle { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>
    /// Time for which the body has been slower than <see cref="MinimumVelocity"/>, milliseconds; kept by an inactivity controller. At least
    /// 0. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float IdleTime
    {
        get => _extras is null ? 0 : _extras.IdleTime;
        set
        {
            Require.NotNegative(value, nameof(IdleTime));
            if (value != IdleTime)
            {
                Extras.IdleTime = value;
            }
        }
    }

    /// <summary>Speed from which on the body counts as moving, length/s. Default 55.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MinimumVelocity
    {
        get => _extras is null ? BodyExtras.UsualMinimumVelocity : _extras.MinimumVelocity;
        set
        {
            Require.NotNegative(value, nameof(MinimumVelocity));
            if (value != MinimumVelocity)
            {
                Extras.MinimumVelocity = value;
            }
        }
    }

    /// <summary>True if the speed of the body is at least <see cref="MinimumVelocity"/>.</summary>
    public bool Moves => LinearVelocity.LengthSquared() >= MinimumVelocity * MinimumVelocity;

    /// <summary>
    /// The geoms that were made for the body, in the order of their creation, whether they are in a simulator or not. Disposed ones are
    /// left out. (An addition to the original.)
    /// </summary>
    public BodyGeoms Geoms => new BodyGeoms(this);

    /// <summary>What an inactivity controller knows of the body.</summary>
    internal IdleState Idle { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>Made static by a sensor quirk, which in the original left the inverse mass as it was.</summary>
    internal bool IsStaticBySensor { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>The last member called to change motion, place or mass.</summary>
    internal string? LastCall { get; private set; }

    /// <summary>The step after which <see cref="LastCall"/> came.</summary>
    internal long LastCallStep { get; private set; }

    internal PhysicsSimulator? Simulator { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>Joints of its simulator, or on their way there, that hold the body.</summary>
    internal int JointCount { get; set => Link.Mark.Set(ref field, value); }

    internal Membership Membership { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>True while the body is in its simulator's list of those with a stored impulse or a force at a local point.</summary>
    internal bool IsPendingNoted { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>True while the body is in its simulator's list of those that want to hear of their moves.</summary>
    internal bool IsListenerNoted { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>How many geoms were made for this body; they are in the order of their creation.</summary>
    internal int GeomCount => _geoms is List<Geom> several ? several.Count : _geoms is null ? 0 : 1;

    // Whoever asks for them sets one.
    private BodyExtras Extras => Link.Mark.Changed(_extras ??= new BodyExtras());

    private bool HasInfiniteMass => (Link.UserFlags & (BodyFlags.Static | BodyFlags.Kinematic)) != 0;

    /// <summary>
    /// Disposes the body and its geoms: they take no further part in collisions and are swept out of the simulator at its next
    /// update. Calling it again does nothing.
    /// </summary>
    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    /// <summary>Does the work of <see cref="Dispose()"/>.</summary>
    /// <param name="disposing">True when called by <see cref="Dispose()"/>.</param>
    protected virtual void Dispose(bool disposing)
    {
        if (IsDisposed)
        {
            return;
        }

        IsDisposed = true;
        if (!disposing)
        {
            return;
        }

        for (int i = GeomCount - 1; i >= 0; i--)
        {
            GeomAt(i).Dispose();
        }

        Simulator?.NoteDisposed(this);
        _extras?.Disposed?.Invoke(this, EventArgs.Empty);
    }

    internal Geom GeomAt(int index) => _geoms is List<Geom> several ? several[index] : (Geom)_geoms!;

    internal void AddGeom(Geom geom)
    {
        if (_geoms is List<Geom> several)
        {
            several.Add(Link.Mark.Changed(geom));
        }
        else
        {
            _geoms = Link.Mark.Changed<object>(_geoms is Geom first ? new List<Geom> { first, geom } : geom);
        }
    }

    internal void RemoveGeom(Geom geom)
    {
        if (_geoms is List<Geom> several)
        {
            several.Remove(Link.Mark.Changed(geom));
        }
        else if (ReferenceEquals(_geoms, geom))
        {
            _geoms = Link.Mark.Changed<object?>(null);
        }
    }

    internal void RaiseUpdated()
    {
        if (_extras?.Updated is { } updated)
        {
            Vector2 position = Position;
            float rotation = Rotation;
            _extras.ToldX = PositionX;
            _extras.ToldY = PositionY;
            _extras.ToldAngle = Link.PoseRef.Angle;
            updated(ref position, ref rotation);
        }
    }

    /// <summary>Calls the handlers if the place differs from what they heard last.</summary>
    internal void TellIfMoved()
    {
        if (_extras is { } told && (PositionX != told.ToldX || PositionY != told.ToldY || Link.PoseRef.Angle != told.ToldAngle))
        {
            RaiseUpdated();
        }
    }

    /// <summary>Takes over that the engine has disabled the body.</summary>
    internal void Quarantine()
    {
        Link.SetUserFlags(Link.UserFlags & ~BodyFlags.Enabled);
        IsQuarantined = true;
    }

    internal void ThrowIfDisposed()
    {
        if (IsDisposed)
        {
            throw new ObjectDisposedException(nameof(Body));
        }
    }

    private void Note(string call)
    {
        LastCall = Link.Mark.Changed(call);
        LastCallStep = Simulator is null ? 0 : Simulator.StepCount;
    }

    private void SetMass(float mass, float inertia)
    {
        ThrowIfDisposed();
        Note("Mass or MomentOfInertia");
        if (FixedRotation)
        {
            _extras!.FixedInertia = inertia;
            inertia = float.PositiveInfinity;
        }

        Link.SetMass(mass, inertia);
    }

    private void SetFlag(BodyFlags flag, bool on)
    {
        ThrowIfDisposed();
        Link.SetUserFlags(on ? Link.UserFlags | flag : Link.UserFlags & ~flag);
    }
}
