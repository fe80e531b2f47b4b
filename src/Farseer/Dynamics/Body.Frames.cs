using System;
using System.Numerics;
using Farseer.Engine.Bodies;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <content>Where the body is and what that means for points.</content>
public partial class Body
{
    private const double Turn = 2 * Math.PI;

    /// <summary>Position of the centre of mass. Default (0, 0). Kept in double precision inside; see <see cref="PositionX"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or beyond 9.2·10¹⁸.</exception>
    public Vector2 Position
    {
        get
        {
            ref BodyPose pose = ref Link.PoseRef;
            return new Vector2((float)pose.X, (float)pose.Y);
        }

        set
        {
            Require.Place(value, nameof(Position));
            SetPosition(value.X, value.Y);
        }
    }

    /// <summary>x of the position in full precision: 10⁷ lengths from the origin nothing is lost. (An addition to the original.)</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or beyond 9.2·10¹⁸.</exception>
    public double PositionX
    {
        get => Link.PoseRef.X;
        set => SetPosition(Require.Place(value, nameof(PositionX)), PositionY);
    }

    /// <summary>y of the position in full precision. (An addition to the original.)</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or beyond 9.2·10¹⁸.</exception>
    public double PositionY
    {
        get => Link.PoseRef.Y;
        set => SetPosition(PositionX, Require.Place(value, nameof(PositionY)));
    }

    /// <summary>
    /// Rotation in [0, 2π). Setting it sets <see cref="Revolutions"/> to the whole turns of the value (see
    /// <see cref="Farseer201Quirks.RotationSetAddsRevolutions"/>). Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or beyond 9.2·10¹⁸.</exception>
    public float Rotation
    {
        get
        {
            Wrap(Link.PoseRef.Angle, out float rotation);
            return rotation;
        }

        set
        {
            ThrowIfDisposed();
            double angle = Require.Place(value, nameof(Rotation));
            if (Simulator is not null && (Simulator.Quirks & Farseer201Quirks.RotationSetAddsRevolutions) != 0)
            {
                angle += Turn * Revolutions;
            }

            Note(nameof(Rotation));
            Link.SetAngle(angle);
            NotePut();
            RaiseUpdated();
        }
    }

    /// <summary>Whole turns made; backward turns are negative. Default 0.</summary>
    public int Revolutions => Wrap(Link.PoseRef.Angle, out _);

    /// <summary><see cref="Rotation"/> with the turns: 2π·<see cref="Revolutions"/> + <see cref="Rotation"/>.</summary>
    public float TotalRotation => (float)Link.PoseRef.Angle;

    /// <summary>The body's x axis in the world.</summary>
    public Vector2 XVectorInWorldCoordinates
    {
        get
        {
            ref BodyPose pose = ref Link.PoseRef;
            return new Vector2(pose.Cos, pose.Sin);
        }
    }

    /// <summary>The body's y axis in the world.</summary>
    public Vector2 YVectorInWorldCoordinates
    {
        get
        {
            ref BodyPose pose = ref Link.PoseRef;
            return new Vector2(-pose.Sin, pose.Cos);
        }
    }

    /// <summary>Sets the position in full precision. (An addition to the original.)</summary>
    /// <param name="x">x of the new position; finite.</param>
    /// <param name="y">y of the new position; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not finite or beyond 9.2·10¹⁸.</exception>
    public void SetPosition(double x, double y)
    {
        ThrowIfDisposed();
        Require.Place(x, nameof(x));
        Require.Place(y, nameof(y));
        Note(nameof(Position));
        Link.SetPosition(x, y);
        NotePut();
        RaiseUpdated();
    }

    /// <summary>The position in full precision. (An addition to the original.)</summary>
    /// <param name="x">x of the position.</param>
    /// <param name="y">y of the position.</param>
    public void GetPosition(out double x, out double y)
    {
        ref BodyPose pose = ref Link.PoseRef;
        x = pose.X;
        y = pose.Y;
    }

    /// <summary>The total rotation in full precision. (An addition to the original.)</summary>
    /// <param name="totalRotation">The rotation with whole turns, radians.</param>
    public void GetTotalRotation(out double totalRotation) => totalRotation = Link.PoseRef.Angle;

    /// <summary>Sets the total rotation in full precision. (An addition to the original.)</summary>
    /// <param name="totalRotation">The rotation with whole turns, radians; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or beyond 9.2·10¹⁸.</exception>
    public void SetTotalRotation(double totalRotation)
    {
        ThrowIfDisposed();
        Require.Place(totalRotation, nameof(totalRotation));
        Note(nameof(Rotation));
        Link.SetAngle(totalRotation);
        NotePut();
        RaiseUpdated();
    }

    /// <summary>Sets position and total rotation at once, in full precision. (An addition to the original.)</summary>
    /// <param name="pose">The new pose.</param>
    public void SetPose(Pose pose)
    {
        ThrowIfDisposed();
        Note(nameof(Position));
        Link.SetPosition(pose.X, pose.Y);
        Link.SetAngle(pose.TotalRotation);
        NotePut();
        RaiseUpdated();
    }

    /// <summary>The pose now, in full precision. (An addition to the original.)</summary>
    /// <returns>Place and total rotation.</returns>
    public Pose GetPose()
    {
        ref BodyPose pose = ref Link.PoseRef;
        return new Pose(pose.X, pose.Y, pose.Angle);
    }

    /// <summary>
    /// The pose between the last update and the one before, for drawing. A body whose position was set since is drawn there at once. While
    /// <see cref="PhysicsSimulator.KeepsPoses"/> is false it is the present pose. (An addition to the original.)
    /// </summary>
    /// <param name="alpha">0: as the last update found it; 1: as it is; between: in proportion. From 0 to 1: see
    /// <see cref="FixedStepDriver.Alpha"/>.</param>
    /// <returns>Place and total rotation.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="alpha"/> is not from 0 to 1.</exception>
    public Pose GetPose(float alpha)
    {
        if (!(alpha >= 0 && alpha <= 1))
        {
            throw Require.Range(nameof(alpha), alpha, "must be from 0 to 1");
        }

        BodyPose now = Link.PoseRef;
        BodyPose before = Simulator is { } simulator && Link.IsAttached ? simulator.Poses.Before(Link.Place, now) : now;
        double rest = 1.0 - alpha;
        return new Pose(
            now.X + ((before.X - now.X) * rest), now.Y + ((before.Y - now.Y) * rest), now.Angle + ((before.Angle - now.Angle) * rest));
    }

    /// <summary>Turns and moves a local point into the world.</summary>
    /// <param name="localPosition">Point in body coordinates.</param>
    /// <returns>The point in world coordinates.</returns>
    public Vector2 GetWorldPosition(Vector2 localPosition)
    {
        GetWorldPosition(ref localPosition, out Vector2 worldPosition);
        return worldPosition;
    }

    /// <summary>Turns and moves a local point into the world.</summary>
    /// <param name="localPosition">Point in body coordinates.</param>
    /// <param name="worldPosition">The point in world coordinates.</param>
    public void GetWorldPosition(ref Vector2 localPosition, out Vector2 worldPosition)
    {
        ref BodyPose pose = ref Link.PoseRef;
        Vector2 offset = Turned(in pose, localPosition);
        worldPosition = new Vector2((float)(pose.X + offset.X), (float)(pose.Y + offset.Y));
    }

    /// <summary>Moves and turns a world point into body coordinates.</summary>
    /// <param name="worldPosition">Point in world coordinates.</param>
    /// <returns>The point in body coordinates.</returns>
    public Vector2 GetLocalPosition(Vector2 worldPosition)
    {
        GetLocalPosition(ref worldPosition, out Vector2 localPosition);
        return localPosition;
    }

    /// <summary>Moves and turns a world point into body coordinates.</summary>
    /// <param name="worldPosition">Point in world coordinates.</param>
    /// <param name="localPosition">The point in body coordinates.</param>
    public void GetLocalPosition(ref Vector2 worldPosition, out Vector2 localPosition)
    {
        ref BodyPose pose = ref Link.PoseRef;
        float x = (float)(worldPosition.X - pose.X);
        float y = (float)(worldPosition.Y - pose.Y);
        localPosition = new Vector2((pose.Cos * x) + (pose.Sin * y), (pose.Cos * y) - (pose.Sin * x));
    }

    /// <summary>Velocity of the point of the body that is at a local point.</summary>
    /// <param name="localPoint">Point in body coordinates.</param>
    /// <returns>Velocity in world axes, length/s.</returns>
    public Vector2 GetVelocityAtLocalPoint(Vector2 localPoint)
    {
        GetVelocityAtLocalPoint(ref localPoint, out Vector2 velocity);
        return velocity;
    }

    /// <summary>Velocity of the point of the body that is at a local point.</summary>
    /// <param name="localPoint">Point in body coordinates.</param>
    /// <param name="velocity">Velocity in world axes, length/s.</param>
    public void GetVelocityAtLocalPoint(ref Vector2 localPoint, out Vector2 velocity)
    {
        Vector2 offset = Turned(in Link.PoseRef, localPoint);
        GetVelocityAtWorldOffset(ref offset, out velocity);
    }

    /// <summary>Velocity of the point of the body that is at a world point.</summary>
    /// <param name="worldPoint">Point in world coordinates.</param>
    /// <param name="velocity">Velocity, length/s.</param>
    public void GetVelocityAtWorldPoint(ref Vector2 worldPoint, out Vector2 velocity)
    {
        Vector2 offset = OffsetOf(worldPoint);
        GetVelocityAtWorldOffset(ref offset, out velocity);
    }

    /// <summary>Velocity of the point of the body that is at an offset from its position.</summary>
    /// <param name="offset">Offset from <see cref="Position"/>, in world axes.</param>
    /// <param name="velocity">Velocity, length/s.</param>
    public void GetVelocityAtWorldOffset(ref Vector2 offset, out Vector2 velocity)
    {
        ref BodyState state = ref Link.StateRef;
        velocity = state.LinearVelocity + (state.AngularVelocity * new Vector2(-offset.Y, offset.X));
    }

    /// <summary>
    /// The part of the velocity at an offset that only corrects penetration. It is always (0, 0): the solver pushes bodies apart
    /// within its substeps and keeps no separate velocity for it.
    /// </summary>
    /// <param name="offset">Offset from <see cref="Position"/>, in world axes.</param>
    /// <param name="velocityBias">(0, 0).</param>
    public void GetVelocityBiasAtWorldOffset(ref Vector2 offset, out Vector2 velocityBias) => velocityBias = Vector2.Zero;

    /// <summary>The matrix that takes body coordinates to world coordinates, for row vectors.</summary>
    /// <returns>Rotation about z, then translation.</returns>
    public Matrix4x4 GetBodyMatrix()
    {
        GetBodyMatrix(out Matrix4x4 bodyMatrix);
        return bodyMatrix;
    }

    /// <summary>The matrix that takes body coordinates to world coordinates, for row vectors.</summary>
    /// <param name="bodyMatrix">Rotation about z, then translation.</param>
    public void GetBodyMatrix(out Matrix4x4 bodyMatrix)
    {
        ref BodyPose pose = ref Link.PoseRef;
        bodyMatrix = RotationMatrix(pose.Cos, pose.Sin, (float)pose.X, (float)pose.Y);
    }

    /// <summary>The matrix that turns body axes to world axes, for row vectors.</summary>
    /// <returns>Rotation about z.</returns>
    public Matrix4x4 GetBodyRotationMatrix()
    {
        GetBodyRotationMatrix(out Matrix4x4 rotationMatrix);
        return rotationMatrix;
    }

    /// <summary>The matrix that turns body axes to world axes, for row vectors.</summary>
    /// <param name="rotationMatrix">Rotation about z.</param>
    public void GetBodyRotationMatrix(out Matrix4x4 rotationMatrix)
    {
        ref BodyPose pose = ref Link.PoseRef;
        rotationMatrix = RotationMatrix(pose.Cos, pose.Sin, 0, 0);
    }

    internal static Matrix4x4 RotationMatrix(float cos, float sin, float x, float y) =>
        new Matrix4x4(cos, sin, 0, 0, -sin, cos, 0, 0, 0, 0, 1, 0, x, y, 0, 1);

    private static Vector2 Turned(in BodyPose pose, Vector2 v) =>
        new Vector2((pose.Cos * v.X) - (pose.Sin * v.Y), (pose.Sin * v.X) + (pose.Cos * v.Y));

    /// <summary>Whole turns of an angle, and the rest in [0, 2π) as a float that is below the float 2π even after rounding.</summary>
    private static int Wrap(double angle, out float rotation)
    {
        double turns = Math.Floor(angle / Turn);
        rotation = (float)(angle - (turns * Turn));
        if (rotation >= (float)Turn)
        {
            rotation = 0;
            turns += 1;
        }
        else if (rotation < 0)
        {
            rotation = 0;
        }

        return turns > int.MaxValue ? int.MaxValue : turns < int.MinValue ? int.MinValue : (int)turns;
    }

    private void NotePut()
    {
        if (Simulator is { } simulator && Link.IsAttached)
        {
            simulator.Poses.Put(Link.Place, Link.PoseRef);
            if (IsRailed)
            {
                simulator.NoteRails(this);
            }
        }
    }

    private Vector2 OffsetOf(Vector2 worldPoint)
    {
        ref BodyPose pose = ref Link.PoseRef;
        return new Vector2((float)(worldPoint.X - pose.X), (float)(worldPoint.Y - pose.Y));
    }
}
