using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// Disables bodies that have been slow for a while, and enables them again when a fast one comes near. It looks only at bodies
/// whose <see cref="Body.IsAutoIdle"/> is true. Each simulator has one, <see cref="PhysicsSimulator.InactivityController"/>.
/// </summary>
public class InactivityController : Controller
{
    private readonly PhysicsSimulator _simulator;
    private float _activationDistance = 100;
    private float _maxIdleTime = 1000;

    /// <summary>Makes a controller that is not enabled.</summary>
    /// <param name="physicsSimulator">The simulator whose bodies it looks after.</param>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    public InactivityController(PhysicsSimulator physicsSimulator)
    {
        _simulator = Require.NotNull(physicsSimulator, nameof(physicsSimulator));
        Enabled = false;
    }

    /// <summary>
    /// Distance of the positions, a length of the scene, within which a moving body wakes others; finite and at least 0. Default 100.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float ActivationDistance
    {
        get => _activationDistance;
        set => _activationDistance = Require.NotNegative(value, nameof(ActivationDistance));
    }

    /// <summary>Milliseconds for which a body may be slow before it is disabled; finite and at least 0. Default 1000.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxIdleTime
    {
        get => _maxIdleTime;
        set => _maxIdleTime = Require.NotNegative(value, nameof(MaxIdleTime));
    }

    /// <summary>How many bodies of the simulator were enabled when the controller last acted.</summary>
    public int BodiesEnabled { get; private set; }

    /// <summary>True if the positions of two bodies are no more than <see cref="ActivationDistance"/> apart.</summary>
    /// <param name="b1">One body.</param>
    /// <param name="b2">The other.</param>
    /// <returns>True if they are near each other.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    public bool IsInActivationDistance(Body b1, Body b2)
    {
        double x = Require.NotNull(b2, nameof(b2)).PositionX - Require.NotNull(b1, nameof(b1)).PositionX;
        double y = b2.PositionY - b1.PositionY;
        return (x * x) + (y * y) <= (double)_activationDistance * _activationDistance;
    }

    /// <inheritdoc />
    public override void Validate()
    {
    }

    /// <inheritdoc />
    public override void Update(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        float milliseconds = dt * 1000;
        BodiesEnabled = 0;
        BodyList bodies = _simulator.BodyList;
        for (int i = 0; i < bodies.Count; i++)
        {
            Body body = bodies[i];
            if (!body.Enabled || body.IsDisposed)
            {
                continue;
            }

            BodiesEnabled++;
            if (!body.IsAutoIdle)
            {
                continue;
            }

            if (body.Moves)
            {
                body.IdleTime = 0;
                WakeAround(body, bodies);
            }
            else
            {
                body.IdleTime += milliseconds;
                if (body.IdleTime >= _maxIdleTime)
                {
                    body.Enabled = false;
                }
            }
        }
    }

    private void WakeAround(Body mover, BodyList bodies)
    {
        for (int i = 0; i < bodies.Count; i++)
        {
            Body body = bodies[i];
            if (!body.Enabled && body.IsAutoIdle && !body.IsDisposed && IsInActivationDistance(mover, body))
            {
                body.Enabled = true;
                body.IdleTime = 0;
            }
        }
    }
}
