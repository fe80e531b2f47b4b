using System;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Springs;

/// <summary>
/// Pulls and pushes two bodies towards a distance: a force of constant·(length − rest length) + damping·(speed of lengthening)
/// along the line between two attach points, which may lie outside the geoms. A spring alone between its bodies swings with exactly
/// the frequency and damping of the formula, at any step that samples the swing twice a period; stiffer ones stay bounded.
/// </summary>
/// <example>
/// <code>
/// var coil = new LinearSpring(body, Vector2.Zero, second, Vector2.Zero, springConstant: 100, dampingConstant: 5);
/// simulator.Add(coil);
/// </code>
/// </example>
public class LinearSpring : Spring
{
    private Body? _body1;
    private Body? _body2;
    private Vector2 _attachPoint1;
    private Vector2 _attachPoint2;
    private float _restLength;

    /// <summary>Makes a spring without bodies; it does nothing until it has both.</summary>
    public LinearSpring()
    {
    }

    /// <summary>Makes a spring whose rest length is the present distance of the attach points.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="attachPoint1">Point of <paramref name="body1"/>, in its coordinates; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="attachPoint2">Point of <paramref name="body2"/>, in its coordinates; finite.</param>
    /// <param name="springConstant">Force per length; finite and at least 0.</param>
    /// <param name="dampingConstant">Force per speed; finite and at least 0.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public LinearSpring(Body body1, Vector2 attachPoint1, Body body2, Vector2 attachPoint2, float springConstant, float dampingConstant)
    {
        _body1 = Require.NotNull(body1, nameof(body1));
        _body2 = Require.NotNull(body2, nameof(body2));
        SpringCheck.Distinct(body1, body2, nameof(body2));
        _attachPoint1 = Require.Finite(attachPoint1, nameof(attachPoint1));
        _attachPoint2 = Require.Finite(attachPoint2, nameof(attachPoint2));
        SpringConstant = Require.NotNegative(springConstant, nameof(springConstant));
        DampingConstant = Require.NotNegative(dampingConstant, nameof(dampingConstant));
        _restLength = SpringLink.Distance(body1, attachPoint1, body2, attachPoint2);
    }

    /// <summary>First body.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    /// <exception cref="ArgumentException">The value is the other body.</exception>
    public Body? Body1
    {
        get => _body1;
        set
        {
            SpringCheck.Distinct(Require.NotNull(value, nameof(Body1)), _body2, nameof(Body1));
            _body1 = value;
        }
    }

    /// <summary>Second body.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    /// <exception cref="ArgumentException">The value is the other body.</exception>
    public Body? Body2
    {
        get => _body2;
        set
        {
            SpringCheck.Distinct(Require.NotNull(value, nameof(Body2)), _body1, nameof(Body2));
            _body2 = value;
        }
    }

    /// <summary>Attach point of <see cref="Body1"/>, in its coordinates. Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 AttachPoint1
    {
        get => _attachPoint1;
        set => _attachPoint1 = Require.Finite(value, nameof(AttachPoint1));
    }

    /// <summary>Attach point of <see cref="Body2"/>, in its coordinates. Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 AttachPoint2
    {
        get => _attachPoint2;
        set => _attachPoint2 = Require.Finite(value, nameof(AttachPoint2));
    }

    /// <summary>The same as <see cref="AttachPoint1"/>, by the name of the manual.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Anchor1
    {
        get => AttachPoint1;
        set => _attachPoint1 = Require.Finite(value, nameof(Anchor1));
    }

    /// <summary>The same as <see cref="AttachPoint2"/>, by the name of the manual.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Anchor2
    {
        get => AttachPoint2;
        set => _attachPoint2 = Require.Finite(value, nameof(Anchor2));
    }

    /// <summary>
    /// Length without force; finite and at least 0. A larger value pushes the bodies apart, a smaller one pulls them together.
    /// Default: the distance when it was made, or 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float RestLength
    {
        get => _restLength;
        set => _restLength = Require.NotNegative(value, nameof(RestLength));
    }

    internal override Body? FirstBody => _body1;

    internal override Body? SecondBody => _body2;

    /// <inheritdoc />
    public override void Validate()
    {
        if (_body1 is { IsDisposed: true } || _body2 is { IsDisposed: true })
        {
            Dispose();
        }
    }

    /// <inheritdoc />
    public override void Update(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        if (_body1 is null || _body2 is null)
        {
            return;
        }

        if (Survives(SpringLink.Distance(_body1, _attachPoint1, _body2, _attachPoint2) - _restLength))
        {
            SpringLink.Linear(this, _body1, _attachPoint1, _body2, _attachPoint2, _restLength);
        }
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Reference(ref _body1);
        s.Reference(ref _body2);
        s.Value(ref _attachPoint1);
        s.Value(ref _attachPoint2);
        s.Value(ref _restLength);
    }
}
