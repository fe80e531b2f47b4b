using System;
using System.Collections.Generic;
using System.Threading;
using Farseer.Engine.Queries;
using Farseer.Engine.Simulation;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Hands a <see cref="QueryLink"/> to each query. One thread gets the same one again and again; another one is made only when two ask at
/// once.
/// </summary>
internal sealed class QueryCrowd
{
    private readonly PhysicsSimulator _simulator;
    private readonly World _world;
    private readonly ObjectTable _table;
    private readonly List<QueryLink> _all = new List<QueryLink>();
    private volatile QueryLink? _recent;

    public QueryCrowd(PhysicsSimulator simulator, World world, ObjectTable table)
    {
        _simulator = simulator;
        _world = world;
        _table = table;
    }

    /// <summary>A link for the time until the turn is disposed.</summary>
    /// <exception cref="InvalidOperationException">The thread asks from the filter of another query.</exception>
    public QueryTurn Enter()
    {
        int thread = Environment.CurrentManagedThreadId;
        if (!_world.Queries.IsFresh)
        {
            Freshen();
        }

        QueryLink? link = _recent;
        return new QueryTurn(this, link?.TryUse(thread) == true ? link : Find(thread));
    }

    /// <summary>
    /// The first of several threads brings the boxes up to the poses, and the others wait: the engine knows no threads here.
    /// </summary>
    private void Freshen()
    {
        lock (_all)
        {
            if (!_world.Queries.IsFresh)
            {
                _world.Queries.Follow();

                // Who sees the mark sees the boxes; to take a link is a barrier on the other side.
                Interlocked.MemoryBarrier();
                _world.Queries.MarkFresh();
            }
        }
    }

    public void Leave(QueryLink link)
    {
        _recent = link;
        link.Leave();
    }

    /// <summary>One that nobody uses, taken.</summary>
    private QueryLink Find(int thread)
    {
        lock (_all)
        {
            foreach (QueryLink link in _all)
            {
                if (link.IsUsedBy(thread))
                {
                    throw new InvalidOperationException("A query must not be asked from within the filter of another.");
                }
            }

            foreach (QueryLink link in _all)
            {
                if (link.TryUse(thread))
                {
                    return link;
                }
            }

            // The first one asks as the world itself does.
            WorldQueries queries = _all.Count == 0 ? _world.Queries : new WorldQueries(_world.Queries);
            var made = new QueryLink(_simulator, _world, queries, _table);
            made.TryUse(thread);
            _all.Add(made);
            return made;
        }
    }
}

/// <summary>The time for which a query has a link.</summary>
internal readonly struct QueryTurn : IDisposable
{
    private readonly QueryCrowd _crowd;

    public QueryTurn(QueryCrowd crowd, QueryLink link)
    {
        _crowd = crowd;
        Link = link;
    }

    public QueryLink Link { get; }

    public void Dispose() => _crowd.Leave(Link);
}
