using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Samples.Terminal;

/// <summary>Reaches into a scene: drags a body by a spring, and throws the one that is chosen.</summary>
internal sealed class Hand
{
    /// <summary>
    /// Four oscillations a second, radians a second: firm enough to follow the mouse, soft enough not to tear a pile apart.
    /// </summary>
    private const float Firmness = 25f;
    private const float DampingRatio = 0.7f;

    private readonly PhysicsSimulator _simulator;
    private readonly List<Geom> _found = [];
    private FixedLinearSpring? _spring;

    public Hand(PhysicsSimulator simulator) => _simulator = simulator;

    /// <summary>The body that was grabbed or chosen last.</summary>
    public Body? Chosen { get; private set; }

    /// <summary>Whether it has moved anything, so that the outcome of the scene is not its own any more.</summary>
    public bool HasTouched { get; private set; }

    /// <summary>Takes the body that is nearest to a point, if one is in reach.</summary>
    public void Grab(Vector2 point, float reach)
    {
        Release();
        _found.Clear();
        _simulator.QueryCircle(point, reach, _found);
        Body? nearest = null;
        foreach (Geom geom in _found)
        {
            if (IsLoose(geom.Body) && (nearest is null
                || Vector2.DistanceSquared(geom.Body.Position, point) < Vector2.DistanceSquared(nearest.Position, point)))
            {
                nearest = geom.Body;
            }
        }

        if (nearest is null)
        {
            return;
        }

        Chosen = nearest;
        HasTouched = true;
        float stiffness = nearest.Mass * Firmness * Firmness;
        float damping = 2f * DampingRatio * nearest.Mass * Firmness;
        _spring = SpringFactory.Instance.CreateFixedLinearSpring(
            _simulator, nearest, nearest.GetLocalPosition(point), point, stiffness, damping);
    }

    public void Lead(Vector2 point)
    {
        if (_spring is not null)
        {
            _spring.WorldAttachPoint = point;
        }
    }

    /// <summary>Lets go: the body flies on as it was led.</summary>
    public void Release()
    {
        _spring?.Dispose();
        _spring = null;
    }

    /// <summary>Chooses the next body that can move.</summary>
    public void ChooseNext()
    {
        int count = _simulator.BodyList.Count;
        int start = Chosen is null ? -1 : _simulator.BodyList.IndexOf(Chosen);
        for (int i = 1; i <= count; i++)
        {
            Body body = _simulator.BodyList[(start + i) % count];
            if (IsLoose(body))
            {
                Chosen = body;
                return;
            }
        }
    }

    /// <summary>Adds to the velocity of the chosen body.</summary>
    public void Throw(Vector2 velocity)
    {
        if (Chosen is not null && IsLoose(Chosen))
        {
            Chosen.LinearVelocity += velocity;
            HasTouched = true;
        }
    }

    private static bool IsLoose(Body body) => body.Enabled && !body.IsStatic && !body.IsKinematic && !body.IsDisposed;
}
