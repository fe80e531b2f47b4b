using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Numerics;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Proxies, and the making of pairs.</summary>
internal sealed class PairFinder : WorldPhase
{
    /// <summary>
    /// New pairs from one that is made to that whose colliders and place in the map are asked for; to that whose pieces are, twice as many.
    /// </summary>
    private const int NewPairsAhead = 6;

    /// <summary>
    /// New pairs that are described before they are entered: all of a first step at once would take room that no later one needs.
    /// </summary>
    private const int PairsAtOnce = 4096;
    private readonly SleepStage _sleep;
    private readonly Removals _removals;
    [NotState(Why.Elsewhere)]
    private readonly SurfaceStage _surfaces;
    private readonly PairMap _verdicts = new PairMap();
    private readonly IndexList _movedProxies = new IndexList();
    private bool _allFound;

    public PairFinder(WorldStores stores, SleepStage sleep, Removals removals, SurfaceStage surfaces)
        : base(stores)
    {
        _sleep = sleep;
        _removals = removals;
        _surfaces = surfaces;
    }

    /// <summary>The search is asked in every step, also if no box has changed.</summary>
    public bool AlwaysCollects { get; set; }

    /// <summary>Gives a piece a new fat box and makes it look for pairs.</summary>
    public void SetProxy(int piece, in Box fat, bool alive, bool isStatic)
    {
        ref ProxyInfo info = ref _proxies.Info[piece];
        if (!alive || (_shapes.Colliders[_shapes.Pieces[piece].Collider].Flags & ColliderFlags.Alive) == 0)
        {
            RemoveProxy(piece);
            return;
        }

        int group = _shapes.Colliders[_shapes.Pieces[piece].Collider].Group;
        if (group != info.Group)
        {
            RemoveProxy(piece);
            info.Group = group;
        }

        bool known = (info.Flags & ProxyFlags.Alive) != 0;
        _proxies.Fat[piece] = fat;
        _proxies.Sought[piece] = Box.Empty;
        _movedProxies.Add(piece);
        info.Body = _shapes.Pieces[piece].Body;
        info.Flags = ProxyFlags.Alive | ProxyFlags.Moved | (isStatic ? ProxyFlags.Static : ProxyFlags.None);
        if (!known)
        {
            _stores.BroadPhase.Added(_proxies, piece);
        }
    }

    /// <summary>Pieces with a new box, in no order: they look for pairs.</summary>
    public IndexList MovedProxies => _movedProxies;

    /// <summary>A body was put elsewhere or its pieces were changed: what is known of the gaps around it does not hold.</summary>
    public void NoteAltered(int body) => _contacts.Steps.Alter(body);

    public void RemoveProxy(int piece)
    {
        ref ProxyInfo info = ref _proxies.Info[piece];
        if ((info.Flags & ProxyFlags.Alive) != 0)
        {
            info.Flags = ProxyFlags.None;
            _stores.BroadPhase.Removed(_proxies, piece);
        }
    }

    // The marks of the last step have served its pairs and its contacts.
    public void ForgetMoves()
    {
        _stores.Tools.PairWork.Forget(_stores.Runner, this);
        _movedProxies.Clear();
    }

    /// <summary>Forgets of some pieces that they had new boxes. Workers do.</summary>
    public unsafe void ForgetMoves(int from, int to)
    {
        ProxyInfo* info = _proxies.Info.Pointer;
        Box* fat = _proxies.Fat.Pointer;
        Box* sought = _proxies.Sought.Pointer;
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
    /// A pair was refused, which it may not be the next time: what filters, joints and listeners say changes without new boxes. It must be
    /// found again, and one of its pieces without a box of which pairs are known sees to that. Workers tell.
    /// </summary>
    public void NoteRefused(ulong key)
    {
        Box unknown = Box.Empty;
        unknown.MinX = float.NaN;
        _proxies.Sought[PairBuffer.Lower(key)] = unknown;
    }

    public unsafe void Find()
    {
        PairBuffer pairs = _stores.Tools.Pairs;
        pairs.Clear();
        _allFound = false;
        if (_contacts.KeepFriction(_settings.FreezePairFriction))
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
        if (_movedProxies.Count == 0 && !AlwaysCollects)
        {
            _allFound = true;
            return;
        }

        (_stores.BroadPhase as LevelGrid)?.Share(_stores.Runner);
        _stores.BroadPhase.Collect(_proxies, pairs);
        _stores.Tools.PairWork.Run(_stores.Runner, this, pairs, _stores.Scratch);
        RadixSort.Sort(_stores.Scratch, pairs.Pointer, null, pairs.Count);
        _contacts.Expect(pairs.Count);
        if (_stores.Hooks != null && _stores.Hooks.JudgesPairs)
        {
            Judge(pairs);
        }
        else
        {
            AddAll(pairs);
        }

        _allFound = true;
    }

    /// <summary>Makes the pairs that listeners accept, who may do anything meanwhile.</summary>
    private void Judge(PairBuffer pairs)
    {
        for (int i = 0; i < pairs.Count; i++)
        {
            ulong ahead = pairs[System.Math.Min(i + NewPairsAhead, pairs.Count - 1)];
            _contacts.Map.AskForValue(ahead);
            AskForColliders(ahead);
            AskForPieces(pairs[System.Math.Min(i + (2 * NewPairsAhead), pairs.Count - 1)]);

            // A user's search may name a pair twice.
            if (i == 0 || pairs[i] != pairs[i - 1])
            {
                TryCreate(pairs[i]);
            }
        }
    }

    /// <summary>
    /// Makes the pairs, which have all passed the filters: workers describe some thousand at a time, and one thread enters them.
    /// </summary>
    private unsafe void AddAll(PairBuffer pairs)
    {
        int mark = _stores.Scratch.Mark;
        ContactRecord* records = _stores.Scratch.Take<ContactRecord>(System.Math.Min(pairs.Count, PairsAtOnce));
        for (int first = 0; first < pairs.Count; first += PairsAtOnce)
        {
            int end = System.Math.Min(first + PairsAtOnce, pairs.Count);
            _stores.Tools.PairWork.Describe(_stores.Runner, this, pairs, first, end - first, records);
            for (int i = first; i < end; i++)
            {
                _contacts.Map.AskForValue(pairs[System.Math.Min(i + NewPairsAhead, pairs.Count - 1)]);
                if (i == 0 || pairs[i] != pairs[i - 1])
                {
                    Add(pairs[i], records[i - first]);
                }
            }
        }

        _stores.Scratch.Release(mark);
    }

    public PairMap KnownPairs => _contacts.Map;

    /// <summary>Nothing but a listener can refuse the pair. Workers ask.</summary>
    public bool MayTouch(ulong key) => MayTouch(_shapes.Pieces[PairBuffer.Lower(key)], _shapes.Pieces[PairBuffer.Higher(key)]);

    public unsafe void AskForPieces(ulong key)
    {
        Prefetch.Line(_shapes.Pieces.Pointer + PairBuffer.Lower(key));
        Prefetch.Line(_shapes.Pieces.Pointer + PairBuffer.Higher(key));
    }

    public unsafe void AskForColliders(ulong key)
    {
        Prefetch.Line(_shapes.Colliders.Pointer + _shapes.Pieces[PairBuffer.Lower(key)].Collider);
        Prefetch.Line(_shapes.Colliders.Pointer + _shapes.Pieces[PairBuffer.Higher(key)].Collider);
    }

    private bool MayTouch(in Piece a, in Piece b) =>
        PassesFilter(_shapes.Colliders[a.Collider], _shapes.Colliders[b.Collider])
        && (_joints.Count == 0 || !_joints.KeepsApart(a.Body, b.Body));

    public void TryCreate(ulong key)
    {
        ContactRecord record = Describe(key);
        if (!MayTouch(_shapes.Pieces[record.PieceA], _shapes.Pieces[record.PieceB])
            || !Accept(_shapes.ColliderOf(record.PieceA), _shapes.ColliderOf(record.PieceB), record.OfSeveral))
        {
            NoteRefused(key);
            return;
        }

        Add(key, record);
    }

    /// <summary>The record of a pair, the earlier collider first. Workers ask.</summary>
    public ContactRecord Describe(ulong key)
    {
        int a = PairBuffer.Lower(key);
        int b = PairBuffer.Higher(key);
        int colliderA = _shapes.Pieces[a].Collider;
        int colliderB = _shapes.Pieces[b].Collider;
        if (_shapes.Order[colliderA] > _shapes.Order[colliderB])
        {
            (a, b) = (b, a);
        }

        var record = new ContactRecord
        {
            PieceA = a,
            PieceB = b,
            BodyA = _shapes.Pieces[a].Body,
            BodyB = _shapes.Pieces[b].Body,
            OfSeveral = HasSeveralPieces(colliderA) || HasSeveralPieces(colliderB),
            Kind = KindOf(_shapes.Pieces[a].Kind, _shapes.Pieces[b].Kind),
        };
        record.SetMovers(_bodies.IsMovable(record.BodyA), _bodies.IsMovable(record.BodyB));
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

    private void Add(ulong key, in ContactRecord record)
    {
        int index = _contacts.Create(key, record);
        if (_settings.FreezePairFriction)
        {
            FreezeFriction(index);
        }

        if (_contacts.Surfaces.IsOn)
        {
            _surfaces.Begin(index);
        }
    }

    private void FreezeFriction(int index) =>
        _contacts.FirstFriction[index] = ContactUpdate.MixFriction(_shapes, _settings.FrictionMix, _contacts.Records[index]);

    private bool HasSeveralPieces(int collider) => _shapes.NextPiece[_shapes.Colliders[collider].FirstPiece] >= 0;

    /// <summary>
    /// Asks the listeners, once for a pair of colliders, however many of their pieces come near each other: while there are records
    /// of the pair it stands, and within a step the first answer holds.
    /// </summary>
    private bool Accept(int colliderA, int colliderB, bool ofSeveral)
    {
        if (_stores.Hooks == null || !_stores.Hooks.JudgesPairs)
        {
            return true;
        }

        ulong key = ContactStore.ColliderKey(colliderA, colliderB);
        if (!ofSeveral)
        {
            return _stores.Hooks.AcceptPair(colliderA, colliderB);
        }

        if (_contacts.Compounds.Contains(key))
        {
            return true;
        }

        if (!_verdicts.TryGet(key, out int verdict))
        {
            verdict = _stores.Hooks.AcceptPair(colliderA, colliderB) ? 1 : 0;
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
        return _settings.OneSidedFilter ? aWants || bWants : aWants && bWants;
    }

    /// <summary>After a change of a collider's filter: its pairs are judged anew in the next step.</summary>
    public void Refilter(Handle collider)
    {
        _shapes.ColliderIds.Require(collider, nameof(collider));
        int body = _shapes.Colliders[collider.Index].Body;
        _removals.MarkStale(body);
        _bodies.Flags[body] |= BodyFlags.Moved;
    }

    /// <summary>
    /// Ends the pair of two colliders of one piece each, as if their boxes had parted: if they still meet in the next step, that is a new
    /// pair. Not within a step.
    /// </summary>
    public void EndPair(Handle colliderA, Handle colliderB)
    {
        ulong key = PairBuffer.Pack(
            _shapes.Require(colliderA, nameof(colliderA)).FirstPiece, _shapes.Require(colliderB, nameof(colliderB)).FirstPiece);
        if (!_contacts.Map.TryGet(key, out int index))
        {
            return;
        }

        if (_contacts.Records[index].IsDormant)
        {
            _sleep.WakeBodiesOf(_contacts.Records[index]);
        }

        ContactStage.Drop(_contacts, _graph, index);
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _verdicts.Visit(s.Of(nameof(_verdicts)));
        _movedProxies.VisitUnordered(s.Of(nameof(_movedProxies)));
        AlwaysCollects = s.Of(nameof(PairFinder)).Value(AlwaysCollects);
        s.Value(ref _allFound);
    }

    /// <summary>Makes room for pairs to come.</summary>
    public void Expect(int pairs) => _stores.Tools.Pairs.Expect(pairs);
}
