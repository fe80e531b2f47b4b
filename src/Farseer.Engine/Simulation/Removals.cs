using Farseer.Engine.Contacts;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Ends what was removed or changed since the last step: pairs first, then colliders, then bodies.</summary>
internal sealed class Removals : WorldPhase
{
    private readonly SleepStage _sleep;
    private readonly Column<Handle> _deadBodies = new Column<Handle>();
    private readonly Column<Handle> _deadColliders = new Column<Handle>();
    private readonly Column<byte> _staleBodies = new Column<byte>();
    private int _deadBodyCount;
    private int _deadColliderCount;
    private bool _anyStale;

    public Removals(WorldStores stores, SleepStage sleep)
        : base(stores)
    {
        _sleep = sleep;
    }

    /// <summary>A body is removed.</summary>
    public void Add(Handle body)
    {
        _deadBodies.EnsureCapacity(_deadBodyCount + 1);
        _deadBodies[_deadBodyCount++] = body;
    }

    /// <summary>A collider is removed.</summary>
    public void AddCollider(Handle collider)
    {
        _deadColliders.EnsureCapacity(_deadColliderCount + 1);
        _deadColliders[_deadColliderCount++] = collider;
    }

    /// <summary>The pairs of a body are judged anew in the next step, as if their boxes had parted.</summary>
    public void MarkStale(int body)
    {
        _sleep.Disturb(body);
        _staleBodies.EnsureCapacity(_bodies.Ids.End);
        _staleBodies[body] = 1;
        _anyStale = true;
    }

    /// <summary>
    /// Ends what was removed or changed since the last step: pairs first, then colliders, then bodies. Not within a step.
    /// </summary>
    public void Purge()
    {
        if (!_stores.IsStepping)
        {
            PurgeNow();
        }
    }

    public void PurgeNow()
    {
        if (_deadColliderCount == 0 && _deadBodyCount == 0 && !_anyStale)
        {
            return;
        }

        for (int i = 0; i < _contacts.End; i++)
        {
            ref ContactRecord record = ref _contacts.Records[i];
            if (record.PieceA >= 0 && IsOver(record))
            {
                if (record.IsDormant)
                {
                    _sleep.WakeBodiesOf(record);
                }

                ContactStage.Drop(_contacts, _graph, i);
            }
        }

        for (int i = 0; i < _deadColliderCount; i++)
        {
            int collider = _deadColliders[i].Index;
            _colliders.Remove(_shapes.Colliders[collider].Body, collider);
            ForgetInQueries(collider);
            _shapes.DetachPieces(collider);
            _shapes.ColliderIds.Return(_deadColliders[i]);
        }

        for (int i = 0; i < _deadBodyCount; i++)
        {
            _bodies.Ids.Return(_deadBodies[i]);
        }

        for (int i = 0; _anyStale && i < _staleBodies.Capacity; i++)
        {
            _staleBodies[i] = 0;
        }

        _deadColliderCount = 0;
        _deadBodyCount = 0;
        _anyStale = false;
    }

    private bool IsOver(in ContactRecord record)
    {
        if (_anyStale && (IsStale(record.BodyA) || IsStale(record.BodyB)))
        {
            return true;
        }

        return (_shapes.ColliderAt(record.PieceA).Flags & _shapes.ColliderAt(record.PieceB).Flags & ColliderFlags.Alive) == 0;
    }

    private bool IsStale(int body) => body < _staleBodies.Capacity && _staleBodies[body] != 0;

    private void ForgetInQueries(int collider)
    {
        for (int piece = _shapes.Colliders[collider].FirstPiece; _queries.IsUsed && piece >= 0; piece = _shapes.NextPiece[piece])
        {
            _queries.Removed(piece);
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Of(nameof(Removals)).Value(ref _deadBodyCount);
        s.Value(ref _deadColliderCount);
        s.Column(_deadBodies, _deadBodyCount);
        s.Column(_deadColliders, _deadColliderCount);
        s.Column(_staleBodies);
        s.Value(ref _anyStale);
    }
}
