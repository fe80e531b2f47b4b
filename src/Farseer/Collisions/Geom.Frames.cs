using System.Numerics;
using Farseer.Engine.Bodies;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>Where the geom is. World vertices and box are worked out when asked for and kept until the body moves.</content>
public partial class Geom
{
    private readonly Vertices _worldVertices = new Vertices();
    private AABB? _aabb;
    private Matrix4x4? _matrix;
    private BodyPose _worldPose;

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
    public float Rotation => _body is null ? _rotationOffset : (float)(_body.Link.PoseRef.Angle + _rotationOffset);

    /// <summary>
    /// Takes geom coordinates to world coordinates, for row vectors. A matrix that is set holds for vertices, box and queries
    /// until the body next moves; collisions go by the body.
    /// </summary>
    /// <exception cref="System.ArgumentOutOfRangeException">An element is not finite.</exception>
    public Matrix4x4 Matrix
    {
        get
        {
            Follow();
            if (_matrix is null)
            {
                GetPlacement(out double x, out double y, out float cos, out float sin);
                return Dynamics.Body.RotationMatrix(cos, sin, (float)x, (float)y);
            }

            return _matrix.Value;
        }

        set
        {
            Require.Finite(value, nameof(Matrix));
            Follow();
            _matrix = value;
            FillWorldVertices();
        }
    }

    /// <summary>Takes world coordinates to geom coordinates, for row vectors.</summary>
    public Matrix4x4 MatrixInverse => Matrix4x4.Invert(Matrix, out Matrix4x4 inverse) ? inverse : Matrix4x4.Identity;

    /// <summary>
    /// <see cref="LocalVertices"/> at the geom's place in the world. The same list each time, brought up to date when the property
    /// is read.
    /// </summary>
    public Vertices WorldVertices
    {
        get
        {
            Follow();
            return _worldVertices;
        }
    }

    /// <summary>The box around the geom in the world, brought up to date when the property is read.</summary>
    /// <exception cref="System.ArgumentNullException">The value is null.</exception>
    public AABB AABB
    {
        get
        {
            Follow();
            return _aabb ??= new AABB();
        }

        set
        {
            Follow();
            _aabb = Require.NotNull(value, nameof(AABB));
        }
    }

    /// <summary>The offset as the engine is to turn it by the body's rotation alone.</summary>
    internal Vector2 EffectiveOffset =>
        _rotationOffset != 0 && (Quirks & Farseer201Quirks.OffsetTurnedByRotationOffset) != 0
            ? new Vector2((_offsetCos * _offset.X) - (_offsetSin * _offset.Y), (_offsetSin * _offset.X) + (_offsetCos * _offset.Y))
            : _offset;

    /// <summary>Takes a point of the geom to the world.</summary>
    /// <param name="localPosition">Point in geom coordinates.</param>
    /// <returns>The point in world coordinates.</returns>
    public Vector2 GetWorldPosition(Vector2 localPosition)
    {
        Follow();
        if (_matrix is not null)
        {
            return Vector2.Transform(localPosition, _matrix.Value);
        }

        GetPlacement(out double x, out double y, out float cos, out float sin);
        return Place(localPosition, x, y, cos, sin);
    }

    /// <summary>Takes a world point to geom coordinates.</summary>
    /// <param name="worldVertex">Point in world coordinates.</param>
    /// <param name="localVertex">The point in geom coordinates.</param>
    public void TransformToLocalCoordinates(ref Vector2 worldVertex, out Vector2 localVertex)
    {
        Follow();
        if (_matrix is not null)
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
        Follow();
        if (_matrix is not null)
        {
            worldNormal = Vector2.TransformNormal(localNormal, _matrix.Value);
            return;
        }

        GetPlacement(out _, out _, out float cos, out float sin);
        worldNormal = new Vector2((cos * localNormal.X) - (sin * localNormal.Y), (sin * localNormal.X) + (cos * localNormal.Y));
    }

    private static Vector2 Place(Vector2 local, double x, double y, float cos, float sin) => new Vector2(
        (float)(x + ((cos * local.X) - (sin * local.Y))),
        (float)(y + ((sin * local.X) + (cos * local.Y))));

    private void GetPlacement(out double x, out double y, out float cos, out float sin)
    {
        if (_body is null)
        {
            x = _offset.X;
            y = _offset.Y;
            cos = _offsetCos;
            sin = _offsetSin;
            return;
        }

        ref BodyPose pose = ref _body.Link.PoseRef;
        Vector2 offset = EffectiveOffset;
        x = pose.X + ((pose.Cos * offset.X) - (pose.Sin * offset.Y));
        y = pose.Y + ((pose.Sin * offset.X) + (pose.Cos * offset.Y));
        cos = (pose.Cos * _offsetCos) - (pose.Sin * _offsetSin);
        sin = (pose.Sin * _offsetCos) + (pose.Cos * _offsetSin);
    }

    /// <summary>Brings the world vertices and the box up to date if the body has moved since they were worked out.</summary>
    private void Follow()
    {
        BodyPose pose = _body is null ? new BodyPose { Cos = 1 } : _body.Link.PoseRef;
        bool same = pose.X == _worldPose.X && pose.Y == _worldPose.Y && pose.Angle == _worldPose.Angle
            && pose.Cos == _worldPose.Cos && pose.Sin == _worldPose.Sin;
        if (!same)
        {
            _worldPose = pose;
            _matrix = null;
            FillWorldVertices();
        }
    }

    private void FillWorldVertices()
    {
        GetPlacement(out double x, out double y, out float cos, out float sin);
        _worldVertices.Clear();
        for (int i = 0; i < _localVertices.Count; i++)
        {
            _worldVertices.Add(_matrix is null ? Place(_localVertices[i], x, y, cos, sin) : Vector2.Transform(_localVertices[i], _matrix.Value));
        }

        _aabb ??= new AABB();
        if (_form is null)
        {
            return;
        }

        Vector2 min = _worldVertices[0];
        Vector2 max = min;
        for (int i = 1; i < _worldVertices.Count; i++)
        {
            min = Vector2.Min(min, _worldVertices[i]);
            max = Vector2.Max(max, _worldVertices[i]);
        }

        if (_form.Kind == Bridge.FormKind.Circle && _matrix is null)
        {
            var centre = new Vector2((float)x, (float)y);
            var radius = new Vector2(_form.Radius);
            min = Vector2.Min(min, centre - radius);
            max = Vector2.Max(max, centre + radius);
        }

        _aabb.Set(min, max);
    }
}
