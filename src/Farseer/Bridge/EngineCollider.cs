using System;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Interfaces;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>What the library's own colliders share: an algorithm of the engine, and the handlers that may refuse a pair.</summary>
internal sealed class EngineCollider
{
    [NotState(Why.Elsewhere)]
    private readonly PhysicsSimulator _owner;
    private BroadPhaseCollisionHandler? _handlers;
    private Delegate[] _each = Array.Empty<Delegate>();

    public EngineCollider(PhysicsSimulator physicsSimulator, IBroadPhase engine)
    {
        _owner = Require.NotNull(physicsSimulator, nameof(physicsSimulator));
        Engine = engine;
    }

    public IBroadPhase Engine { get; }

    public PhysicsSimulator Owner => _owner;

    public bool HasHandlers => _each.Length > 0;

    public void Add(BroadPhaseCollisionHandler? handler)
    {
        _handlers += handler;
        _each = _handlers?.GetInvocationList() ?? Array.Empty<Delegate>();
    }

    public void Remove(BroadPhaseCollisionHandler? handler)
    {
        _handlers -= handler;
        _each = _handlers?.GetInvocationList() ?? Array.Empty<Delegate>();
    }

    /// <summary>Asks every handler, so that all of them hear of the pair; one that says no is enough.</summary>
    public bool Accept(Geom a, Geom b)
    {
        bool accepted = true;
        Delegate[] each = _each;
        for (int i = 0; i < each.Length; i++)
        {
            accepted &= ((BroadPhaseCollisionHandler)each[i])(a, b);
        }

        return accepted;
    }

    /// <summary>
    /// If two geoms of overlapping boxes may become a pair: the rule of <see cref="Geom.CollidesWith"/> and its companions.
    /// </summary>
    public static bool MayCollide(Geom a, Geom b)
    {
        if (a.Body is not { } bodyA || b.Body is not { } bodyB)
        {
            return false;
        }

        if (!bodyA.Enabled || !bodyB.Enabled || ReferenceEquals(bodyA, bodyB) || (bodyA.IsStatic && bodyB.IsStatic))
        {
            return false;
        }

        if (!a.CollisionEnabled || !b.CollisionEnabled || (a.CollisionGroup == b.CollisionGroup && a.CollisionGroup != 0))
        {
            return false;
        }

        bool wantsB = (a.CollidesWith & b.CollisionCategories) != 0;
        bool wantsA = (b.CollidesWith & a.CollisionCategories) != 0;
        bool oneIsEnough = a.Simulator is not null && (a.Simulator.Quirks & Farseer201Quirks.OneSidedCategoryFilter) != 0;
        return oneIsEnough ? wantsA || wantsB : wantsA && wantsB;
    }

    /// <summary>Writes, or reads, who judges pairs.</summary>
    public void Visit(StateStream s)
    {
        s.Reference(ref _handlers);
        _each = s.Reference(_each)!;
    }
}
