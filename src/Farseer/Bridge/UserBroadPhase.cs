using System.Collections.Generic;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Lets a user's own collider find the pairs: runs its <c>Update</c> and turns the arbiters that it added to the arbiter list
/// into pairs of the engine, which keeps a pair for as long as its boxes overlap.
/// </summary>
internal sealed class UserBroadPhase : IBroadPhase
{
    private readonly PhysicsSimulator _simulator;

    public UserBroadPhase(PhysicsSimulator simulator) => _simulator = simulator;

    public void Added(ProxyStore proxies, int proxy)
    {
    }

    public void Removed(ProxyStore proxies, int proxy)
    {
    }

    public void Collect(ProxyStore proxies, PairBuffer pairs)
    {
        List<Arbiter> arbiters = _simulator.RunUserBroadPhase();
        for (int i = 0; i < arbiters.Count; i++)
        {
            Arbiter arbiter = arbiters[i];
            if (!arbiter.IsOwned && arbiter.GeomA is not null && arbiter.GeomB is not null)
            {
                AddPieces(proxies, pairs, arbiter.GeomA, arbiter.GeomB);
            }
        }
    }

    private static bool MayPair(ProxyInfo a, ProxyInfo b) =>
        (a.Flags & b.Flags & ProxyFlags.Alive) != 0 && (a.Flags & b.Flags & ProxyFlags.Static) == 0
        && ((a.Flags | b.Flags) & ProxyFlags.Moved) != 0 && a.Body != b.Body;

    private static int FirstPiece(ShapeStore shapes, Geom geom) => shapes.Colliders[geom.Link.Handle.Index].FirstPiece;

    private void AddPieces(ProxyStore proxies, PairBuffer pairs, Geom a, Geom b)
    {
        if (!a.Link.IsAttached || !b.Link.IsAttached || a.Simulator != _simulator || b.Simulator != _simulator)
        {
            return;
        }

        ShapeStore shapes = _simulator.World.Shapes;
        for (int p = FirstPiece(shapes, a); p >= 0; p = shapes.NextPiece[p])
        {
            for (int q = FirstPiece(shapes, b); q >= 0; q = shapes.NextPiece[q])
            {
                if (MayPair(proxies.Info[p], proxies.Info[q]) && Box.Overlap(proxies.Fat[p], proxies.Fat[q]))
                {
                    pairs.Add(p, q);
                }
            }
        }
    }

    /// <summary>What the user's collider remembers it saves itself.</summary>
    public void Visit(StateStream s)
    {
    }
}
