using System;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>The pairs in contact as arbiters, made when asked for, so that nobody pays who does not ask.</summary>
internal sealed class ArbiterView : IContactVisitor
{
    /// <summary>Arbiters to begin with.</summary>
    private const int LeastSpares = 16;

    private readonly PhysicsSimulator _simulator;
    [NotState(Why.Elsewhere)]
    private readonly ObjectTable _table;
    [NotState(Why.Room)]
    private readonly Pool<Arbiter> _pool = new Pool<Arbiter>();

    public ArbiterView(PhysicsSimulator simulator, ObjectTable table)
    {
        _simulator = simulator;
        _table = table;
    }

    [NotState(Why.Derived)]
    public ArbiterList List { get; } = new ArbiterList { Capacity = LeastSpares };

    /// <summary>Set by each step; the list is filled anew when next asked for.</summary>
    public bool IsStale { get; set; }

    public ArbiterList Fresh(World world)
    {
        if (IsStale)
        {
            Clear();
            world.Reader.Visit(this);
            IsStale = false;
        }

        return List;
    }

    public void Clear()
    {
        for (int i = 0; i < List.Count; i++)
        {
            if (List[i].IsOwned)
            {
                Release(List[i]);
            }
        }

        List.Clear();
    }

    public void Visit(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points)
    {
        Geom? a = _table.Geom(colliderA);
        Geom? b = _table.Geom(colliderB);
        if (a is null || b is null || points.IsEmpty)
        {
            return;
        }

        if (_pool.Count == 0)
        {
            // As many again as there are: one by one, a pile that bounces would allocate whenever more pairs touch than ever before.
            for (int more = Math.Max(LeastSpares, List.Count); more > 0; more--)
            {
                _pool.Insert(new Arbiter());
            }
        }

        bool flip = a.Id > b.Id;
        Arbiter arbiter = _pool.Fetch();
        arbiter.IsOwned = true;
        arbiter.GeomA = flip ? b : a;
        arbiter.GeomB = flip ? a : b;
        int most = Math.Min(_simulator.MaxContactsToDetect, _simulator.MaxContactsToResolve);
        ContactCopy.Fill(arbiter.ContactList, points, arbiter.GeomA, arbiter.GeomB, flip, most);
        List.Add(arbiter);
    }

    private void Release(Arbiter arbiter)
    {
        arbiter.ContactList.Clear();
        arbiter.GeomA = null!;
        arbiter.GeomB = null!;
        _pool.Insert(arbiter);
    }
}
