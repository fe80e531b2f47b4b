using System;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Springs;

/// <summary>
/// Pulls and pushes a body towards a distance from a point of the world; see <see cref="LinearSpring"/>. With a rest length of 0 it
/// is what a mouse drags a body by.
/// </summary>
/// <example>
/// <code>
/// var grip = new FixedLinearSpring(body, Vector2.Zero, new Vector2(0, 2), springConstant: 100, dampingConstant: 5);
/// simulator.Add(grip);
/// grip.WorldAttachPoint = new Vector2(1, 2);
/// </code>
/// </example>
public class FixedLinearSpring : Spring
{
    private Body? _body;
    private Vector2 _bodyAttachPoint;
    private Vector2 _worldAttachPoint;
    private float _restLength;

    /// <summary>Makes a spring without a body; it does nothing until it has one.</summary>
    public FixedLinearSpring()
    {
    }

    /// <summary>Makes a spring whose rest length is the present distance of the attach points.</summary>
    /// <param name="body">The body.</param>
    /// <param name="bodyAttachPoint">Point of the body, in its coordinates; finite.</param>
    /// <param name="worldAttachPoint">Point of the world; finite.</param>
    /// <param name="springConstant">Force per length; finite and at least 0.</param>
    /// <param name="dampingConstant">Force per speed; finite and at least 0.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedLinearSpring(Body body, Vector2 bodyAttachPoint, Vector2 worldAttachPoint, float springConstant, float dampingConstant)
    {
        _body = Require.NotNull(body, nameof(body));
        _bodyAttachPoint = Require.Finite(bodyAttachPoint, nameof(bodyAttachPoint));
        _worldAttachPoint = Require.Finite(worldAttachPoint, nameof(worldAttachPoint));
        SpringConstant = Require.NotNegative(springConstant, nameof(springConstant));
        DampingConstant = Require.NotNegative(dampingConstant, nameof(dampingConstant));
        _restLength = SpringLink.Distance(body, bodyAttachPoint, null, worldAttachPoint);
    }

    /// <summary>The body.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    public Body? Body
    {
        get => _body;
        set => _body = Require.NotNull(value, nameof(Body));
    }

    internal override Body? SecondBody => Body;

    /// <summary>Attach point of <see cref="Body"/>, in its coordinates. Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 BodyAttachPoint
    {
        get => _bodyAttachPoint;
        set => _bodyAttachPoint = Require.Finite(value, nameof(BodyAttachPoint));
    }

    /// <summary>The point of the world at the other end. Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 WorldAttachPoint
    {
        get => _worldAttachPoint;
        set => _worldAttachPoint = Require.Finite(value, nameof(WorldAttachPoint));
    }

    /// <summary>The same as <see cref="WorldAttachPoint"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Position
    {
        get => WorldAttachPoint;
        set => _worldAttachPoint = Require.Finite(value, nameof(Position));
    }

    /// <summary>Length without force; finite and at least 0. Default: the distance when it was made, or 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float RestLength
    {
        get => _restLength;
        set => _restLength = Require.NotNegative(value, nameof(RestLength));
    }

    /// <inheritdoc />
    public override void Validate()
    {
        if (_body is { IsDisposed: true })
        {
            Dispose();
        }
    }

    /// <inheritdoc />
    public override void Update(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        if (_body is not null && Survives(SpringLink.Distance(_body, _bodyAttachPoint, null, _worldAttachPoint) - _restLength))
        {
            SpringLink.Linear(this, _body, _bodyAttachPoint, null, _worldAttachPoint, _restLength);
        }
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Reference(ref _body);
        s.Value(ref _bodyAttachPoint);
        s.Value(ref _worldAttachPoint);
        s.Value(ref _restLength);
    }
}
