using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// A wind that carries bodies along: the force is coefficient · (wind − velocity of the body). Any coefficient is stable: a body
/// reaches the speed of the wind and never passes it. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// var gust = new WindController(velocity: new Vector2(12, 0), coefficient: 0.3f);
/// simulator.Add(gust);
/// </code>
/// </example>
public class WindController : BodyController
{
    private Vector2 _velocity;
    private float _coefficient;

    /// <summary>Makes a wind that blows everywhere.</summary>
    /// <param name="velocity">Velocity of the air, length/s; finite.</param>
    /// <param name="coefficient">Force per speed; finite and at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public WindController(Vector2 velocity, float coefficient)
    {
        _velocity = Require.Finite(velocity, nameof(velocity));
        _coefficient = Require.NotNegative(coefficient, nameof(coefficient));
    }

    /// <summary>Velocity of the air, length/s; finite.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Velocity
    {
        get => _velocity;
        set => _velocity = Require.Finite(value, nameof(Velocity));
    }

    /// <summary>Force per difference of speed; finite and at least 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Coefficient
    {
        get => _coefficient;
        set => _coefficient = Require.NotNegative(value, nameof(Coefficient));
    }

    /// <summary>Where the wind blows: bodies whose position is in the box feel it. Default null: everywhere.</summary>
    public AABB? Area { get; set; }

    /// <inheritdoc />
    protected override void Act(Body body, float dt)
    {
        Require.NotNull(body, nameof(body));
        if (Area is null || Area.Contains(body.Position))
        {
            // Steady over the step, a force of this share does what the decaying difference of speeds does.
            double share = new DragLaw((double)_coefficient * body.InverseMass * dt, 1).First;
            body.ApplyForce((float)(_coefficient * share) * (_velocity - body.LinearVelocity));
        }
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _velocity);
        s.Value(ref _coefficient);
        Area = s.Reference(Area);
        Area?.Visit(s);
    }
}
