using System;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// Pulls bodies towards a point with the acceleration strength / distance², as a planet does, or away from it if the strength is
/// negative. Bodies that ignore gravity ignore it. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new GravityController(center: Vector2.Zero, strength: 50, minRadius: 1) { MaxRadius = 20 });
/// </code>
/// </example>
public class GravityController : BodyController
{
    private Vector2 _center;
    private float _strength;
    private float _minRadius;
    private float _maxRadius = float.MaxValue;

    /// <summary>Makes a controller.</summary>
    /// <param name="center">The point, in the world; finite.</param>
    /// <param name="strength">Acceleration times distance², length³/s²; finite.</param>
    /// <param name="minRadius">Distance within which the acceleration no longer grows; finite and above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public GravityController(Vector2 center, float strength, float minRadius)
    {
        _center = Require.Finite(center, nameof(center));
        _strength = Require.Finite(strength, nameof(strength));
        _minRadius = Require.Positive(minRadius, nameof(minRadius));
    }

    /// <summary>The point that pulls, in the world; finite.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Center
    {
        get => _center;
        set => _center = Require.Finite(value, nameof(Center));
    }

    /// <summary>Acceleration times distance², length³/s²; finite.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float Strength
    {
        get => _strength;
        set => _strength = Require.Finite(value, nameof(Strength));
    }

    /// <summary>Distance within which the acceleration falls to 0 towards the centre, as inside a planet; finite and above 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or not above 0.</exception>
    public float MinRadius
    {
        get => _minRadius;
        set => _minRadius = Require.Positive(value, nameof(MinRadius));
    }

    /// <summary>Distance beyond which nothing is pulled; finite and at least 0. Default the largest float.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxRadius
    {
        get => _maxRadius;
        set => _maxRadius = Require.NotNegative(value, nameof(MaxRadius));
    }

    /// <inheritdoc />
    protected override void Act(Body body, float dt)
    {
        Require.NotNull(body, nameof(body));
        if (body.IgnoreGravity)
        {
            return;
        }

        // Where the body is in the middle of the step: found at its start, the pull would lag behind and feed every orbit.
        double ahead = dt / 2;
        double x = _center.X - body.PositionX - (ahead * body.LinearVelocity.X);
        double y = _center.Y - body.PositionY - (ahead * body.LinearVelocity.Y);
        double distance = Math.Sqrt((x * x) + (y * y));
        if (distance <= _maxRadius)
        {
            double reach = Math.Max(distance, _minRadius);
            double pull = body.Mass * (double)_strength / (reach * reach * reach);
            body.ApplyForce(new Vector2((float)(pull * x), (float)(pull * y)));
        }
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _center);
        s.Value(ref _strength);
        s.Value(ref _minRadius);
        s.Value(ref _maxRadius);
    }
}
