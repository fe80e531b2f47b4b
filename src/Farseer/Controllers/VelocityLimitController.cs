using System;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// Keeps bodies from becoming faster than a limit: what is above it when an update's forces act is cut off. (An addition to the
/// original; the library itself limits nothing.)
/// </summary>
public class VelocityLimitController : BodyController
{
    private float _maxLinearVelocity;
    private float _maxAngularVelocity;

    /// <summary>Makes a controller.</summary>
    /// <param name="maxLinearVelocity">Largest speed, length/s; at least 0, infinite: no limit.</param>
    /// <param name="maxAngularVelocity">Largest angular speed, rad/s; at least 0, infinite: no limit.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is negative or not a number.</exception>
    public VelocityLimitController(float maxLinearVelocity, float maxAngularVelocity)
    {
        _maxLinearVelocity = Require.NotBelow(maxLinearVelocity, 0, nameof(maxLinearVelocity));
        _maxAngularVelocity = Require.NotBelow(maxAngularVelocity, 0, nameof(maxAngularVelocity));
    }

    /// <summary>Largest speed, length/s; at least 0, infinite: no limit.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not a number.</exception>
    public float MaxLinearVelocity
    {
        get => _maxLinearVelocity;
        set => _maxLinearVelocity = Require.NotBelow(value, 0, nameof(MaxLinearVelocity));
    }

    /// <summary>Largest angular speed, rad/s; at least 0, infinite: no limit.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not a number.</exception>
    public float MaxAngularVelocity
    {
        get => _maxAngularVelocity;
        set => _maxAngularVelocity = Require.NotBelow(value, 0, nameof(MaxAngularVelocity));
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
}
