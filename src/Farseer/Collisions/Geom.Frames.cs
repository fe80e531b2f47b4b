using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>Where the geom is. World vertices and box are worked out when asked for and kept until the body moves.</content>
public partial class Geom
{
    /// <summary>World position: the body's position plus the offset turned by the body's rotation.</summary>
    public Vector2 Position
    {
        get
        {
            GetPlacement(out double x, out double y, out _, out _);
            return new Vector2((float)x, (float)y);
        }
    }

    /// <summary>The body's total rotation plus the rotation offset, radians.</summary>
    public float Rotation => _body is null ? RotationOffset : (float)(_body.Link.PoseRef.Angle + RotationOffset);

    /// <summary>
    /// Takes geom coordinates to world coordinates, for row vectors. A matrix that is set holds for vertices, box and queries
    /// until the body next moves; collisions go by the body.
    /// </summary>
    /// <exception cref="System.ArgumentOutOfRangeException">An element is not finite.</exception>
    public Matrix4x4 Matrix
    {
        get
        {
            Frame frame = Follow();
            if (frame.Matrix is null)
            {
                GetPlacement(out double x, out double y, out float cos, out float sin);
                return Dynamics.Body.RotationMatrix(cos, sin, (float)x, (float)y);
            }

            return frame.Matrix.Value;
        }

        set
        {
            Require.Finite(value, nameof(Matrix));
            Frame frame = Follow();
            frame.Matrix = value;
            FillWorldVertices(frame);
        }
    }

    /// <summary>Takes world coordinates to geom coordinates, for row vectors.</summary>
    public Matrix4x4 MatrixInverse => Matrix4x4.Invert(Matrix, out Matrix4x4 inverse) ? inverse : Matrix4x4.Identity;

    /// <summary>
    /// <see cref="LocalVertices"/> at the geom's position in the world. The same list each time, brought up to date when the property
    /// is read.
    /// </summary>
    public Vertices WorldVertices => Follow().WorldVertices;

    /// <summary>The box around the geom in the world, brought up to date when the property is read.</summary>
    /// <exception cref="System.ArgumentNullException">The value is null.</exception>
    public AABB AABB
    {
        get
        {
            Frame frame = Follow();
            return frame.Box ??= new AABB();
        }

        set
        {
            Frame frame = Follow();
            frame.Box = Require.NotNull(value, nameof(AABB));
        }
    }

    /// <summary>The offset as the engine is to turn it by the body's rotation alone.</summary>
    internal Vector2 EffectiveOffset =>
        RotationOffset != 0 && (Quirks & Farseer201Quirks.OffsetTurnedByRotationOffset) != 0
            ? new Vector2((_offset!.Cos * Offset.X) - (_offset.Sin * Offset.Y), (_offset.Sin * Offset.X) + (_offset.Cos * Offset.Y))
            : Offset;

    /// <summary>Takes a point of the geom to the world.</summary>
    /// <param name="localPosition">Point in geom coordinates.</param>
    /// <returns>The point in world coordinates.</returns>
    public Vector2 GetWorldPosition(Vector2 localPosition)
    {
        Frame frame = Follow();
        if (frame.Matrix is not null)
        {
            return Vector2.Transform(localPosition, frame.Matrix.Value);
        }

        GetPlacement(out double x, out double y, out float cos, out float sin);
        return Place(localPosition, x, y, cos, sin);
    }

    /// <summary>Takes a world point to geom coordinates.</summary>
    /// <param name="worldVertex">Point in world coordinates.</param>
    /// <param name="localVertex">The point in geom coordinates.</param>
    public void TransformToLocalCoordinates(ref Vector2 worldVertex, out Vector2 localVertex)
    {
        Frame frame = Follow();
        if (frame.Matrix is not null)
        {
            localVertex = Vector2.Transform(worldVertex, MatrixInverse);
            return;
        }

        GetPlacement(out double x, out double y, out float cos, out float sin);
        float dx = (float)(worldVertex.X - x);
        float dy = (float)(worldVertex.Y - y);
        localVertex = new Vector2((cos * dx) + (sin * dy), (cos * dy) - (sin * dx));
    }

    /// <summary>Turns a direction of the geom to world axes.</summary>
    /// <param name="localNormal">Direction in geom axes.</param>
    /// <param name="worldNormal">The direction in world axes.</param>
    public void TransformNormalToWorld(ref Vector2 localNormal, out Vector2 worldNormal)
    {
        Frame frame = Follow();
        if (frame.Matrix is not null)
        {
            worldNormal = Vector2.TransformNormal(localNormal, frame.Matrix.Value);
            return;
        }

        GetPlacement(out _, out _, out float cos, out float sin);
        worldNormal = new Vector2((cos * localNormal.X) - (sin * localNormal.Y), (sin * localNormal.X) + (cos * localNormal.Y));
    }

    private static Vector2 Place(Vector2 local, double x, double y, float cos, float sin) => new Vector2(
        (float)(x + ((cos * local.X) - (sin * local.Y))),
        (float)(y + ((sin * local.X) + (cos * local.Y))));

    /// <summary>Its place in the world, and its turn.</summary>
    internal void GetPlacement(out double x, out double y, out float cos, out float sin)
    {
        float offsetCos = _offset is null ? 1 : _offset.Cos;
        float offsetSin = _offset is null ? 0 : _offset.Sin;
        if (_body is null)
        {
            x = Offset.X;
            y = Offset.Y;
            cos = offsetCos;
            sin = offsetSin;
            return;
        }

        ref BodyPose pose = ref _body.Link.PoseRef;
        Vector2 offset = EffectiveOffset;
        x = pose.X + ((pose.Cos * offset.X) - (pose.Sin * offset.Y));
        y = pose.Y + ((pose.Sin * offset.X) + (pose.Cos * offset.Y));
        cos = (pose.Cos * offsetCos) - (pose.Sin * offsetSin);
        sin = (pose.Sin * offsetCos) + (pose.Cos * offsetSin);
    }

    /// <summary>Brings the world vertices and the box up to date if the body has moved since they were worked out.</summary>
    private Frame Follow()
    {
        BodyPose pose = _body is null ? new BodyPose { Cos = 1 } : _body.Link.PoseRef;
        Frame frame = (_extras ??= new GeomExtras()).Frame ??= new Frame();
        BodyPose known = frame.Pose;
        bool same = pose.X == known.X && pose.Y == known.Y && pose.Angle == known.Angle && pose.Cos == known.Cos && pose.Sin == known.Sin;
        if (!same)
        {
            frame.Pose = pose;
            frame.Matrix = null;
            FillWorldVertices(frame);
        }

        return frame;
    }

    /// <summary>What was worked out holds no more.</summary>
    private void ForgetFrame(bool keepsForm = false)
    {
        _extras?.Outline = keepsForm ? _extras.Outline : null;
        _extras?.Frame?.Pose = default;
    }

    private void FillWorldVertices(Frame frame)
    {
        GetPlacement(out double x, out double y, out float cos, out float sin);
        frame.WorldVertices.Clear();
        foreach (Vector2 vertex in LocalVertices)
        {
            frame.WorldVertices.Add(frame.Matrix is null ? Place(vertex, x, y, cos, sin) : Vector2.Transform(vertex, frame.Matrix.Value));
        }

        frame.Box ??= new AABB();
        if (_form is null)
        {
            return;
        }

        Vector2 min = frame.WorldVertices[0];
        Vector2 max = min;
        for (int i = 1; i < frame.WorldVertices.Count; i++)
        {
            min = Vector2.Min(min, frame.WorldVertices[i]);
            max = Vector2.Max(max, frame.WorldVertices[i]);
        }

        if (_form.Kind == Bridge.FormKind.Circle && frame.Matrix is null)
        {
            var centre = new Vector2((float)x, (float)y);
            var radius = new Vector2(_form.Radius);
            min = Vector2.Min(min, centre - radius);
            max = Vector2.Max(max, centre + radius);
        }

        frame.Box.Set(min, max);
    }

    /// <summary>Where a geom sits that is not at its body's place.</summary>
    private sealed class GeomOffset
    {
        public readonly Vector2 Place;
        public readonly float Rotation;
        public readonly float Cos;
        public readonly float Sin;

        public GeomOffset(Vector2 place, float rotation)
        {
            Place = place;
            Rotation = rotation;
            Cos = (float)Math.Cos(rotation);
            Sin = (float)Math.Sin(rotation);
        }
    }

    /// <summary>What nearly no geom has; all of it is as much as the rest of one.</summary>
    private sealed class GeomExtras
    {
        public CollisionEventHandler? OnCollision;
        public SeparationEventHandler? OnSeparation;
        [NotState(Why.Users)]
        public object? Tag;
        [NotState(Why.Users)]
        public string? Name;
        public Grid? Grid;
        [NotState(Why.Derived)]
        public Frame? Frame;

        /// <summary>That of a rectangle, once somebody has asked for it: to look at a world changes nothing of its state.</summary>
        [NotState(Why.Derived)]
        public Vertices? Outline;
        public SurfaceMaterial Surface;
        public SurfaceMaterial?[]? Segments;
        public Vector2 OneWay;

        /// <summary>But for what is the user's own, or worked out, it is as if there were none.</summary>
        public bool IsUsual => OnCollision is null && OnSeparation is null && Grid is null && IsUsualButForUsers;

        /// <summary>The same but for handlers and what is made when it is asked for, which no other world gets.</summary>
        public bool IsUsualButForUsers => Segments is null && OneWay == Vector2.Zero && Surface.Equals(default(SurfaceMaterial));
    }

    /// <summary>The geom at its body's place.</summary>
    private sealed class Frame
    {
        public readonly Vertices WorldVertices = new Vertices();
        public AABB? Box;
        public Matrix4x4? Matrix;
        public BodyPose Pose;
    }
}
