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
    /// Ways in which the body may not move: forces and contacts push it on along what is left. <see cref="MotionLocks.Rotation"/> acts at
    /// once and is exact: the body answers as if its moment of inertia were infinite. <see cref="MotionLocks.X"/> and
    /// <see cref="MotionLocks.Y"/> act from the next update on, as by a rail through the place where the body is then, or is put later.
    /// Default <see cref="MotionLocks.None"/>.
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
    /// True keeps the body from turning by forces and contacts, as for a character; it is stopped if it turns. The same as
    /// <see cref="MotionLocks.Rotation"/>.
    /// <see cref="MomentOfInertia"/> keeps its value and counts again later. Default false.
    /// </summary>
    /// <exception cref="ObjectDisposedException">The body is disposed.</exception>
    public bool FixedRotation
    {
        get => _extras is not null && (_extras.Locks & MotionLocks.Rotation) != 0;
        set => MotionLocks = value ? MotionLocks | MotionLocks.Rotation : MotionLocks & ~MotionLocks.Rotation;
    }

    /// <summary>
    /// How much of <see cref="PhysicsSimulator.Gravity"/> pulls at the body: 0 none, as <see cref="IgnoreGravity"/>, 2 twice of it, -1
    /// upwards; finite. A value other than 1 acts as a force of the body's weight in each update, which is as exact in flight. While
    /// <see cref="IgnoreGravity"/> is true none does. Default 1.
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

    /// <summary>Name, place, speed and state, for a debugger.</summary>
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
    internal bool IsGravityNoted { get; set; }

    /// <summary>True while the body is in its simulator's list of those whose rails are to be laid.</summary>
    internal bool IsRailNoted { get; set; }

    /// <summary>
    /// Gives a kinematic body the velocities with which it is at a place when the next update of a given length ends: to within their
    /// rounding, 6·10⁻⁸ of the way. What it touches is carried along, which it is not where <see cref="Position"/> is set. The velocities
    /// stay until they are set again: call it before each update.
    /// </summary>
    /// <param name="position">The place; finite.</param>
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

    /// <summary>As the overload with a rotation, without turning.</summary>
    /// <param name="position">The place; finite.</param>
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
    /// Lists the pairs in contact of which a geom is the body's, as of the last update, in the order of their geoms, with their points,
    /// normals and impulses. They are those of
    /// <see cref="PhysicsSimulator.ArbiterList"/>, which are used again by the next update. Nothing is allocated once the list has its
    /// size.
    /// </summary>
    /// <param name="arbiters">Is emptied and filled.</param>
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
