using System;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// Keeps bodies from becoming faster than a limit: what is above it when an update's forces act is cut off. (An addition to the
/// original; the library itself limits nothing.)
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new VelocityLimitController(maxLinearVelocity: 30, maxAngularVelocity: 10));
/// </code>
/// </example>
public class VelocityLimitController : BodyController
{
    private float _maxLinearVelocity;
    private float _maxAngularVelocity;

    /// <summary>Makes a controller.</summary>
    /// <param name="maxLinearVelocity">Largest speed, length/s; finite and at least 0; the largest float: no limit.</param>
    /// <param name="maxAngularVelocity">Largest angular speed, rad/s; finite and at least 0; the largest float: no limit.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is negative or not finite.</exception>
    public VelocityLimitController(float maxLinearVelocity, float maxAngularVelocity)
    {
        _maxLinearVelocity = Require.NotNegative(maxLinearVelocity, nameof(maxLinearVelocity));
        _maxAngularVelocity = Require.NotNegative(maxAngularVelocity, nameof(maxAngularVelocity));
    }

    /// <summary>Largest speed, length/s; finite and at least 0; the largest float: no limit.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxLinearVelocity
    {
        get => _maxLinearVelocity;
        set => _maxLinearVelocity = Require.NotNegative(value, nameof(MaxLinearVelocity));
    }

    /// <summary>Largest angular speed, rad/s; finite and at least 0; the largest float: no limit.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxAngularVelocity
    {
        get => _maxAngularVelocity;
        set => _maxAngularVelocity = Require.NotNegative(value, nameof(MaxAngularVelocity));
    }

    /// <inheritdoc />
    protected override void Act(Body body, float dt)
    {
        Require.NotNull(body, nameof(body));
        float speed = body.LinearVelocity.Length();
        if (speed > _maxLinearVelocity)
        {
            body.LinearVelocity *= _maxLinearVelocity / speed;
        }

        if (Math.Abs(body.AngularVelocity) > _maxAngularVelocity)
        {
            body.AngularVelocity = body.AngularVelocity > 0 ? _maxAngularVelocity : -_maxAngularVelocity;
        }
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _maxLinearVelocity);
        s.Value(ref _maxAngularVelocity);
    }
}
