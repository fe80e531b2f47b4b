using System;
using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// Disables bodies that have been slow for a while, and enables them again when one comes near that is fast or that it may not disable, or
/// when anything is about to meet them. It disables only bodies whose <see cref="Body.IsAutoIdle"/> is true, and none that is static, and
/// leaves those alone that something near would wake, or that touch, or hang by a joint or spring at, one that stays enabled. Each
/// simulator has one,
/// <see cref="PhysicsSimulator.InactivityController"/>.
/// </summary>
/// <example>
/// <code>
/// simulator.InactivityController.Enabled = true;
/// body.IsAutoIdle = true;
/// </code>
/// </example>
public class InactivityController : Controller
{
    [NotState(Why.Elsewhere)]
    private readonly PhysicsSimulator _simulator;

    // Those that wake others, and those whose time is over, of one update.
    [NotState(Why.OfOneStep)]
    private readonly List<Body> _wakers = new List<Body>();
    [NotState(Why.OfOneStep)]
    private readonly List<Body> _idle = new List<Body>();
    private readonly IdleNeighbors _neighbors = new IdleNeighbors();
    private bool _anyDisabled;
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
    /// Distance of the positions, a length of the scene, within which bodies wake others: those that move, and those whose
    /// <see cref="Body.IsAutoIdle"/> is false; finite and at least 0. Default 100.
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

    /// <summary>How many bodies of the simulator were enabled when the controller last acted; static ones do not count.</summary>
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
        bool mayWake = false;
        BodiesEnabled = 0;
        BodyList bodies = _simulator.BodyList;
        for (int i = 0; i < bodies.Count; i++)
        {
            Body body = bodies[i];
            if (body.IsStatic || body.IsDisposed)
            {
                continue;
            }

            if (!body.Enabled)
            {
                mayWake |= body.IsAutoIdle;
                continue;
            }

            BodiesEnabled++;
            if (body.Moves || !body.IsAutoIdle)
            {
                body.IdleTime = 0;
                _wakers.Add(body);
                continue;
            }

            body.IdleTime += milliseconds;
            if (body.IdleTime >= _maxIdleTime)
            {
                _idle.Add(body);
            }
        }

        if (mayWake && _wakers.Count > 0)
        {
            Wake(bodies);
        }

        if (_idle.Count > 0)
        {
            DisableIdle(bodies, dt);
        }

        _wakers.Clear();
        _idle.Clear();
    }

    /// <summary>Before a step looks for contacts: enables what anything enabled is about to meet, touches or holds.</summary>
    internal void WakeAhead(float dt)
    {
        if (!_anyDisabled)
        {
            return;
        }

        _anyDisabled = false;
        BodyList bodies = _simulator.BodyList;
        for (int i = 0; i < bodies.Count; i++)
        {
            Body body = bodies[i];
            if (body.IsStatic || body.IsDisposed)
            {
                continue;
            }

            if (body.Enabled)
            {
                _neighbors.AddAwake(body, _simulator.Gravity, dt);
            }
            else if ((body.Idle & IdleState.Disabled) != 0)
            {
                _anyDisabled = true;
                _neighbors.AddResting(body);
            }
        }

        if (_anyDisabled)
        {
            _neighbors.Spread(_simulator.JointList, _simulator.SpringList);
            foreach (Body body in _neighbors.Reached)
            {
                Enable(body);
            }
        }

        _neighbors.Clear();
    }

    private static void Enable(Body body)
    {
        body.Enabled = true;
        body.IdleTime = 0;
    }

    /// <summary>Disables those whose time is over, but not what would be woken at once: contacts and joints would be lost.</summary>
    private void DisableIdle(BodyList bodies, float dt)
    {
        foreach (Body body in _idle)
        {
            if (IsNearAWaker(body))
            {
                body.IdleTime = 0;
            }
            else
            {
                _neighbors.AddResting(body);
            }
        }

        for (int i = 0; i < bodies.Count; i++)
        {
            Body body = bodies[i];
            if (body.Enabled && !body.IsStatic && !body.IsDisposed && (body.Idle & IdleState.Resting) == 0)
            {
                _neighbors.AddAwake(body, _simulator.Gravity, dt);
            }
        }

        _neighbors.Spread(_simulator.JointList, _simulator.SpringList);
        foreach (Body body in _idle)
        {
            if ((body.Idle & IdleState.Resting) != 0)
            {
                body.Enabled = false;
                body.Idle |= IdleState.Disabled;
                _anyDisabled = true;
            }
        }

        _neighbors.Clear();
    }

    private void Wake(BodyList bodies)
    {
        for (int i = 0; i < bodies.Count; i++)
        {
            Body body = bodies[i];
            if (!body.Enabled && body.IsAutoIdle && !body.IsDisposed && IsNearAWaker(body))
            {
                Enable(body);
            }
        }
    }

    private bool IsNearAWaker(Body body)
    {
        foreach (Body waker in _wakers)
        {
            if (IsInActivationDistance(waker, body))
            {
                return true;
            }
        }

        return false;
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _anyDisabled);
        s.Value(ref _activationDistance);
        s.Value(ref _maxIdleTime);
        BodiesEnabled = s.Value(BodiesEnabled);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("anyDisabled", ref _anyDisabled);
        int enabled = BodiesEnabled;
        fields.Value("bodiesEnabled", ref enabled);
        BodiesEnabled = enabled;
    }
}
