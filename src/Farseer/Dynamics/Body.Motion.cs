using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Bodies;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <content>How a body may move, what pulls it, whom it touches. (Additions to the original.)</content>
public partial class Body
{
    /// <summary>
    /// The ways in which the body cannot move, whatever pushes it. <see cref="MotionLocks.Rotation"/> acts at once and exactly, as an
    /// infinite moment of inertia. <see cref="MotionLocks.X"/> and <see cref="MotionLocks.Y"/> act from the next update on, as a rail
    /// through the position that the body then has, or is given later. Default <see cref="MotionLocks.None"/>.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value has a bit that is no member of the enum.</exception>
    /// <exception cref="ObjectDisposedException">The body is disposed.</exception>
    public MotionLocks MotionLocks
    {
        get => _extras is null ? MotionLocks.None : _extras.Locks;
        set
        {
            ThrowIfDisposed();
            if ((value & ~MotionLocks.All) != 0)
            {
                throw Require.Range(nameof(MotionLocks), value, "must be made of members of the enum MotionLocks");
            }

            MotionLocks changed = value ^ MotionLocks;
            if (changed == MotionLocks.None)
            {
                return;
            }

            float inertia = MomentOfInertia;
            Extras.Locks = value;
            if ((changed & MotionLocks.Rotation) != 0)
            {
                Extras.FixedInertia = 0;
                SetMass(Mass, inertia);
                AngularVelocity = FixedRotation ? 0 : AngularVelocity;
            }

            if ((changed & (MotionLocks.X | MotionLocks.Y)) != 0)
            {
                Link.WakeUp();
                Simulator?.NoteRails(this);
            }
        }
    }

    /// <summary>
    /// True keeps forces and contacts from turning the body, as for a character; if it turns it is stopped. The same as
    /// <see cref="MotionLocks.Rotation"/>. <see cref="MomentOfInertia"/> keeps its value, which counts again when this becomes false.
    /// Default false.
    /// </summary>
    /// <exception cref="ObjectDisposedException">The body is disposed.</exception>
    public bool FixedRotation
    {
        get => _extras is not null && (_extras.Locks & MotionLocks.Rotation) != 0;
        set => MotionLocks = value ? MotionLocks | MotionLocks.Rotation : MotionLocks & ~MotionLocks.Rotation;
    }

    /// <summary>
    /// Factor on <see cref="PhysicsSimulator.Gravity"/> for this body: 0 switches gravity off, 2 doubles it, -1 turns it round; finite.
    /// Values other than 1 act as a force in each update and are as exact in free flight. While <see cref="IgnoreGravity"/> is true there
    /// is no gravity at all. Default 1.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    /// <exception cref="ObjectDisposedException">The body is disposed.</exception>
    public float GravityScale
    {
        get => _extras is null ? 1 : _extras.GravityScale;
        set
        {
            ThrowIfDisposed();
            Require.Finite(value, nameof(GravityScale));
            if (value != GravityScale)
            {
                Extras.GravityScale = value;
                Link.WakeUp();
                Link.IsPulledApart = value != 1;
                Link.SetUserFlags(Link.UserFlags);
                Simulator?.NoteGravity(this);
            }
        }
    }

    /// <summary>Name, position, speed and state, for a debugger.</summary>
    /// <returns>A line of text.</returns>
    public override string ToString() => string.Format(
        System.Globalization.CultureInfo.InvariantCulture,
        "Body {0}at ({1:G5}, {2:G5}) turned {3:G4}, {4}, mass {5:G4}, velocity ({6:G4}, {7:G4}), spin {8:G4}{9}",
        (Name ?? Tag) is { } name ? name + " " : "",
        PositionX,
        PositionY,
        TotalRotation,
        IsStatic ? "static" : IsKinematic ? "kinematic" : Awake ? "dynamic" : "asleep",
        Mass,
        Link.StateRef.LinearVelocity.X,
        Link.StateRef.LinearVelocity.Y,
        Link.StateRef.AngularVelocity,
        IsDisposed ? ", disposed" : !Enabled ? ", disabled" : Simulator is null ? ", in no simulator" : "");

    /// <summary>A rail keeps its x or its y.</summary>
    internal bool IsRailed => (MotionLocks & (MotionLocks.X | MotionLocks.Y)) != 0;

    /// <summary>True while the body is in its simulator's list of those that gravity pulls otherwise.</summary>
    internal bool IsGravityNoted { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>True while the body is in its simulator's list of those whose rails are to be laid.</summary>
    internal bool IsRailNoted { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>
    /// Gives a kinematic body the velocities that bring it to a position by the end of the next update, to within rounding, 6·10⁻⁸ of the
    /// way. It carries along what it touches, which setting <see cref="Position"/> does not. The velocities stay until they are set again,
    /// so call it before each update.
    /// </summary>
    /// <param name="position">The position; finite.</param>
    /// <param name="totalRotation">The rotation there with whole turns, radians; finite.</param>
    /// <param name="dt">Length of the update, seconds; finite and above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
    /// <exception cref="InvalidOperationException">The body is not kinematic.</exception>
    /// <exception cref="ObjectDisposedException">The body is disposed.</exception>
    public void MoveTo(Vector2 position, double totalRotation, float dt)
    {
        ThrowIfDisposed();
        Require.Place(position, nameof(position));
        Require.Place(totalRotation, nameof(totalRotation));
        Require.Positive(dt, nameof(dt));
        if (!IsKinematic)
        {
            throw new InvalidOperationException("MoveTo moves kinematic bodies only: set IsKinematic first.");
        }

        Note(nameof(MoveTo));
        ref BodyPose pose = ref Link.PoseRef;
        LinearVelocity = new Vector2((float)((position.X - pose.X) / dt), (float)((position.Y - pose.Y) / dt));
        AngularVelocity = (float)((totalRotation - pose.Angle) / dt);
    }

    /// <summary>Moves a kinematic body as the overload with a rotation does, without turning it.</summary>
    /// <param name="position">The position; finite.</param>
    /// <param name="dt">Length of the update, seconds; finite and above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
    /// <exception cref="InvalidOperationException">The body is not kinematic.</exception>
    /// <exception cref="ObjectDisposedException">The body is disposed.</exception>
    public void MoveTo(Vector2 position, float dt) => MoveTo(position, Link.PoseRef.Angle, dt);

    /// <summary>
    /// Sets mass and moment of inertia from the geoms and a density: of each the area times the density, about <see cref="Position"/>,
    /// which stays. Sensors count, and lines have no area.
    /// </summary>
    /// <param name="density">Mass of an area of 1; finite and above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="density"/> is out of its range, or so are the mass or the moment of
    /// inertia that come of it.</exception>
    /// <exception cref="InvalidOperationException">No geom has an area.</exception>
    /// <exception cref="ObjectDisposedException">The body is disposed.</exception>
    public void SetDensity(float density)
    {
        ThrowIfDisposed();
        Require.Positive(density, nameof(density));
        double area = 0;
        double inertia = 0;
        foreach (Geom geom in Geoms)
        {
            GeomArea part = GeomArea.Of(geom);
            area += part.Area;
            inertia += part.Inertia;
        }

        if (!(area > 0))
        {
            throw new InvalidOperationException("No geom of the body has an area.");
        }

        SetMass(
            Require.Invertible((float)(area * density), nameof(density)), Require.Invertible((float)(inertia * density), nameof(density)));
    }

    /// <summary>
    /// Lists the pairs in contact that a geom of this body is part of, as of the last update, in the order of their geoms, with points,
    /// normals and impulses. They belong to <see cref="PhysicsSimulator.ArbiterList"/>, and the next update uses them again. Nothing is
    /// allocated once the list has its size.
    /// </summary>
    /// <param name="arbiters">The list to fill; it is emptied first.</param>
    /// <returns>Number of pairs; 0 for a body that is in no simulator.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="arbiters"/> is null.</exception>
    public int GetContacts(List<Arbiter> arbiters)
    {
        Require.NotNull(arbiters, nameof(arbiters)).Clear();
        if (Simulator is { } simulator)
        {
            List<Arbiter> all = simulator.ArbiterList;
            for (int i = 0; i < all.Count; i++)
            {
                if (ReferenceEquals(all[i].GeomA.Body, this) || ReferenceEquals(all[i].GeomB.Body, this))
                {
                    arbiters.Add(all[i]);
                }
            }
        }

        return arbiters.Count;
    }
}
