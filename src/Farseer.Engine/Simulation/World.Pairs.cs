using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Proxies, the making of pairs, and the end of what was removed.</summary>
internal sealed partial class World
{
    /// <summary>New pairs from one that is made to that whose colliders and place in the map are asked for; to that whose pieces are, twice as many.</summary>
    private const int NewPairsAhead = 6;

    /// <summary>New pairs that are described before they are entered: all of a first step at once would take room that no later one needs.</summary>
    private const int PairsAtOnce = 4096;

    private readonly PairBuffer _pairs = new PairBuffer();
    private readonly PairWork _pairWork = new PairWork();
    private readonly PairMap _verdicts = new PairMap();
    private readonly Column<byte> _staleBodies = new Column<byte>();
    private readonly IndexList _movedProxies = new IndexList();
    private bool _anyStale;
    private bool _alwaysCollect;
    private bool _allFound;

    /// <summary>Gives a piece a new fat box and makes it look for pairs.</summary>
    internal void SetProxy(int piece, in Box fat, bool alive, bool isStatic)
    {
        ref ProxyInfo info = ref Proxies.Info[piece];
        if (!alive || (Shapes.Colliders[Shapes.Pieces[piece].Collider].Flags & ColliderFlags.Alive) == 0)
        {
            RemoveProxy(piece);
            return;
        }

        int group = Shapes.Colliders[Shapes.Pieces[piece].Collider].Group;
        if (group != info.Group)
        {
            RemoveProxy(piece);
            info.Group = group;
        }

        bool known = (info.Flags & ProxyFlags.Alive) != 0;
        Proxies.Fat[piece] = fat;
        Proxies.Sought[piece] = Box.Empty;
        _movedProxies.Add(piece);
        info.Body = Shapes.Pieces[piece].Body;
        info.Flags = ProxyFlags.Alive | ProxyFlags.Moved | (isStatic ? ProxyFlags.Static : ProxyFlags.None);
        if (!known)
        {
            BroadPhase.Added(Proxies, piece);
        }
    }

    /// <summary>Pieces with a new box, in no order: they look for pairs.</summary>
    internal IndexList MovedProxies => _movedProxies;

    /// <summary>A body was put elsewhere or its pieces were changed: what is known of the gaps around it does not hold.</summary>
    internal void NoteAltered(int body) => _contacts.Steps.Alter(body);

    /// <summary>After a change of a collider's filter: its pairs are judged anew in the next step.</summary>
    public void Refilter(Handle collider)
    {
        Require(collider, Shapes.ColliderIds, nameof(collider));
        int body = Shapes.Colliders[collider.Index].Body;
        MarkStale(body);
        Bodies.Flags[body] |= BodyFlags.Moved;
    }

    /// <summary>
    /// Ends the pair of two colliders of one piece each, as if their boxes had parted: if they still meet in the next step, that is a new
    /// pair. Not within a step.
    /// </summary>
    public void EndPair(Handle colliderA, Handle colliderB)
    {
        ulong key = PairBuffer.Pack(Collider(colliderA).FirstPiece, Collider(colliderB).FirstPiece);
        if (!_contacts.Map.TryGet(key, out int index))
        {
            return;
        }

        if (_contacts.Records[index].IsDormant)
        {
            WakeBodiesOf(_contacts.Records[index]);
        }

        ContactStage.Drop(_contacts, _graph, index);
    }

    private void RemoveProxy(int piece)
    {
        ref ProxyInfo info = ref Proxies.Info[piece];
        if ((info.Flags & ProxyFlags.Alive) != 0)
        {
            info.Flags = ProxyFlags.None;
            BroadPhase.Removed(Proxies, piece);
        }
    }

    private void MarkStale(int body)
    {
        Disturb(body);
        _staleBodies.EnsureCapacity(Bodies.Ids.End);
        _staleBodies[body] = 1;
        _anyStale = true;
    }

    // The marks of the last step have served its pairs and its contacts.
    private void ForgetMoves()
    {
        _pairWork.Forget(_runner, this);
        _movedProxies.Clear();
    }

    /// <summary>Forgets of some pieces that they had new boxes. Workers do.</summary>
    internal unsafe void ForgetMoves(int from, int to)
    {
        ProxyInfo* info = Proxies.Info.Pointer;
        Box* fat = Proxies.Fat.Pointer;
        Box* sought = Proxies.Sought.Pointer;
        for (int i = from; i < to; i++)
        {
            int piece = _movedProxies[i];
            info[piece].Flags &= ~ProxyFlags.Moved;
            if (!float.IsNaN(sought[piece].MinX))
            {
                // A listener that threw ended the search before its end.
                sought[piece] = _allFound ? fat[piece] : Box.Empty;
            }
        }
    }

    /// <summary>
    /// A pair was refused, which it may not be the next time: what filters, joints and listeners say changes without new boxes. It must be found again, and
    /// one of its pieces without a box of which pairs are known sees to that. Workers tell.
    /// </summary>
    internal void NoteRefused(ulong key)
    {
        Box unknown = Box.Empty;
        unknown.MinX = float.NaN;
        Proxies.Sought[PairBuffer.Lower(key)] = unknown;
    }

    private unsafe void FindPairs()
    {
        _pairs.Clear();
        _allFound = false;
        if (_contacts.KeepFriction(Settings.FreezePairFriction))
        {
            for (int i = 0; i < _contacts.End; i++)
            {
                if (_contacts.Records[i].PieceA >= 0)
                {
                    FreezeFriction(i);
                }
            }
        }

        if (_verdicts.Count > 0)
        {
            _verdicts.Clear();
        }

        // Without a new box there is no new pair; only the search of a user hears of every step.
        if (_movedProxies.Count == 0 && !_alwaysCollect)
        {
            _allFound = true;
            return;
        }

        (BroadPhase as LevelGrid)?.Share(_runner);
        BroadPhase.Collect(Proxies, _pairs);
        _pairWork.Run(_runner, this, _pairs, Scratch);
        RadixSort.Sort(Scratch, _pairs.Pointer, null, _pairs.Count);
        _contacts.Expect(_pairs.Count);
        if (Hooks != null && Hooks.JudgesPairs)
        {
            JudgePairs();
        }
        else
        {
            AddPairs();
        }

        _allFound = true;
    }

    /// <summary>Makes the pairs that listeners accept, who may do anything meanwhile.</summary>
    private void JudgePairs()
    {
        for (int i = 0; i < _pairs.Count; i++)
        {
            ulong ahead = _pairs[System.Math.Min(i + NewPairsAhead, _pairs.Count - 1)];
            _contacts.Map.AskForValue(ahead);
            AskForColliders(ahead);
            AskForPieces(_pairs[System.Math.Min(i + (2 * NewPairsAhead), _pairs.Count - 1)]);

            // A user's search may name a pair twice.
            if (i == 0 || _pairs[i] != _pairs[i - 1])
            {
                TryCreatePair(_pairs[i]);
            }
        }
    }

    /// <summary>Makes the pairs, which have all passed the filters: workers describe some thousand at a time, and one thread enters them.</summary>
    private unsafe void AddPairs()
    {
        int mark = Scratch.Mark;
        ContactRecord* records = Scratch.Take<ContactRecord>(System.Math.Min(_pairs.Count, PairsAtOnce));
        for (int first = 0; first < _pairs.Count; first += PairsAtOnce)
        {
            int end = System.Math.Min(first + PairsAtOnce, _pairs.Count);
            _pairWork.Describe(_runner, this, _pairs, first, end - first, records);
            for (int i = first; i < end; i++)
            {
                _contacts.Map.AskForValue(_pairs[System.Math.Min(i + NewPairsAhead, _pairs.Count - 1)]);
                if (i == 0 || _pairs[i] != _pairs[i - 1])
                {
                    AddPair(_pairs[i], records[i - first]);
                }
            }
        }

        Scratch.Release(mark);
    }

    /// <summary>All pairs.</summary>
    internal ContactStore Contacts => _contacts;

    internal PairMap KnownPairs => _contacts.Map;

    /// <summary>Nothing but a listener can refuse the pair. Workers ask.</summary>
    internal bool MayTouch(ulong key) => MayTouch(Shapes.Pieces[PairBuffer.Lower(key)], Shapes.Pieces[PairBuffer.Higher(key)]);

    internal unsafe void AskForPieces(ulong key)
    {
        Prefetch.Line(Shapes.Pieces.Pointer + PairBuffer.Lower(key));
        Prefetch.Line(Shapes.Pieces.Pointer + PairBuffer.Higher(key));
    }

    internal unsafe void AskForColliders(ulong key)
    {
        Prefetch.Line(Shapes.Colliders.Pointer + Shapes.Pieces[PairBuffer.Lower(key)].Collider);
        Prefetch.Line(Shapes.Colliders.Pointer + Shapes.Pieces[PairBuffer.Higher(key)].Collider);
    }

    private bool MayTouch(in Piece a, in Piece b) =>
        PassesFilter(Shapes.Colliders[a.Collider], Shapes.Colliders[b.Collider])
        && (Joints.Count == 0 || !Joints.KeepsApart(a.Body, b.Body));

    private void TryCreatePair(ulong key)
    {
        ContactRecord record = Describe(key);
        if (!MayTouch(Shapes.Pieces[record.PieceA], Shapes.Pieces[record.PieceB])
            || !Accept(Shapes.ColliderOf(record.PieceA), Shapes.ColliderOf(record.PieceB), record.OfSeveral))
        {
            NoteRefused(key);
            return;
        }

        AddPair(key, record);
    }

    /// <summary>The record of a pair, the earlier collider first. Workers ask.</summary>
    internal ContactRecord Describe(ulong key)
    {
        int a = PairBuffer.Lower(key);
        int b = PairBuffer.Higher(key);
        int colliderA = Shapes.Pieces[a].Collider;
        int colliderB = Shapes.Pieces[b].Collider;
        if (Shapes.Order[colliderA] > Shapes.Order[colliderB])
        {
            (a, b) = (b, a);
        }

        var record = new ContactRecord
        {
            PieceA = a,
            PieceB = b,
            BodyA = Shapes.Pieces[a].Body,
            BodyB = Shapes.Pieces[b].Body,
            OfSeveral = HasSeveralPieces(colliderA) || HasSeveralPieces(colliderB),
            Kind = KindOf(Shapes.Pieces[a].Kind, Shapes.Pieces[b].Kind),
        };
        record.SetMovers(IsMovable(record.BodyA), IsMovable(record.BodyB));
        return record;
    }

    private static PairKind KindOf(ShapeKind a, ShapeKind b)
    {
        if (a == ShapeKind.Circle || b == ShapeKind.Circle)
        {
            return a == b ? PairKind.Circles : PairKind.CircleAndHull;
        }

        return a == ShapeKind.Box && a == b ? PairKind.Boxes : PairKind.Hulls;
    }

    private void AddPair(ulong key, in ContactRecord record)
    {
        int index = _contacts.Create(key, record);
        if (Settings.FreezePairFriction)
        {
            FreezeFriction(index);
        }

        if (_contacts.Surfaces.IsOn)
        {
            BeginSurface(index);
        }
    }

    private void FreezeFriction(int index) =>
        _contacts.FirstFriction[index] = ContactUpdate.MixFriction(Shapes, Settings.FrictionMix, _contacts.Records[index]);

    private bool HasSeveralPieces(int collider) => Shapes.NextPiece[Shapes.Colliders[collider].FirstPiece] >= 0;

    /// <summary>
    /// Asks the listeners, once for a pair of colliders, however many of their pieces come near each other: while there are records
    /// of the pair it stands, and within a step the first answer holds.
    /// </summary>
    private bool Accept(int colliderA, int colliderB, bool ofSeveral)
    {
        if (Hooks == null || !Hooks.JudgesPairs)
        {
            return true;
        }

        ulong key = ContactStore.ColliderKey(colliderA, colliderB);
        if (!ofSeveral)
        {
            return Hooks.AcceptPair(colliderA, colliderB);
        }

        if (_contacts.Compounds.Contains(key))
        {
            return true;
        }

        if (!_verdicts.TryGet(key, out int verdict))
        {
            verdict = Hooks.AcceptPair(colliderA, colliderB) ? 1 : 0;
            _verdicts.Set(key, verdict);
        }

        return verdict != 0;
    }

    private bool PassesFilter(in ColliderInfo a, in ColliderInfo b)
    {
        if ((a.Flags & b.Flags & ColliderFlags.CollisionEnabled) == 0 || (a.Group != 0 && a.Group == b.Group))
        {
            return false;
        }

        bool aWants = (a.CollidesWith & b.Categories) != 0;
        bool bWants = (b.CollidesWith & a.Categories) != 0;
        return Settings.OneSidedFilter ? aWants || bWants : aWants && bWants;
    }

    /// <summary>Ends what was removed or changed since the last step: pairs first, then colliders, then bodies. Not within a step.</summary>
    private void Purge()
    {
        if (!IsStepping)
        {
            PurgeNow();
        }
    }

    private void PurgeNow()
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
                    WakeBodiesOf(record);
                }

                ContactStage.Drop(_contacts, _graph, i);
            }
        }

        for (int i = 0; i < _deadColliderCount; i++)
        {
            int collider = _deadColliders[i].Index;
            Unlink(collider);
            ForgetInQueries(collider);
            Shapes.DetachPieces(collider);
            Shapes.ColliderIds.Return(_deadColliders[i]);
        }

        for (int i = 0; i < _deadBodyCount; i++)
        {
            Bodies.Ids.Return(_deadBodies[i]);
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

        return (Shapes.ColliderAt(record.PieceA).Flags & Shapes.ColliderAt(record.PieceB).Flags & ColliderFlags.Alive) == 0;
    }

    private bool IsStale(int body) => body < _staleBodies.Capacity && _staleBodies[body] != 0;
}
