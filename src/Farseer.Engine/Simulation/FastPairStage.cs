using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Continuous;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Decides on the pairs that <see cref="FastPairs"/> deferred. What can be left to the sweep after the flight is left to it: a fast
/// body that nothing holds, against what cannot move. The others get a row made at the impact that the present velocities lead to;
/// limbs that pass something one made where they are.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class FastPairStage : IStageWork
{
    /// <summary>Pairs that are worth another worker's while, some 2 µs.</summary>
    private const int LeastPairs = 4;

    private ContactBundle* _bundle;
    private ScratchList<ulong> _keys;
    private ScratchList<int> _contacts;
    private Outlook* _found;
    private Kinds* _kinds;
    private ContactUpdateInput _input;
    private ConstraintGraph _graph = null!;
    private JointStore _joints = null!;
    private StruckPairs _struck = null!;
    private bool _allHeld;
    private bool _ofMovers;

    /// <summary>Rows given in this step.</summary>
    public int Given { get; private set; }

    /// <summary>One of them can bounce.</summary>
    public bool AnyBounce { get; private set; }

    public void Begin(Scratch scratch)
    {
        _keys = new ScratchList<ulong>(scratch);
        _contacts = new ScratchList<int>(scratch);
        _bundle = &scratch.Lasting<WorkerLanes>(1)->Fast;
        Given = 0;
        AnyBounce = false;
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget()
    {
        _input.Forget();
        _graph = null!;
        _joints = null!;
        _struck = null!;
    }

    public void Defer(ContactStore contacts, int contact)
    {
        _keys.Add(ContactStage.Shuffle(ContactStage.PairKey(contacts.Records[contact])));
        _contacts.Add(contact);
    }

    /// <summary>What a fast body comes near wakes: it would meet it as a wall.</summary>
    public void Wake(SleepStage sleep, ContactStore contacts)
    {
        for (int i = 0; i < _contacts.Count; i++)
        {
            sleep.WakeByContact(contacts.Records[_contacts[i]]);
        }
    }

    public void Decide(
        StageRunner runner,
        in ContactUpdateInput input,
        ConstraintGraph graph,
        JointStore joints,
        bool allHeld,
        StruckPairs struck,
        LonePairs lone)
    {
        if (_contacts.Count == 0)
        {
            return;
        }

        _struck = struck;
        RadixSort.Sort(input.Scratch, _keys.Pointer, _contacts.Pointer, _contacts.Count);
        _found = input.Scratch.Take<Outlook>(_contacts.Count);
        _kinds = input.Scratch.Take<Kinds>(_contacts.Count);
        _input = input;
        _graph = graph;
        _joints = joints;
        _allHeld = allHeld;
        _ofMovers = true;
        runner.Run(this, _contacts.Count, LeastPairs);
        for (int i = 0; i < _contacts.Count; i++)
        {
            if ((_kinds[i] & Kinds.Due) != 0)
            {
                Take(input, graph, i);
            }

            if ((_kinds[i] & Kinds.OfMovers) != 0 && input.Settings.Continuous)
            {
                lone.Offer(_contacts[i]);
            }
        }

        // Bodies that got rows above are held now.
        _ofMovers = false;
        runner.Run(this, _contacts.Count, LeastPairs);
        for (int i = 0; i < _contacts.Count; i++)
        {
            if ((_kinds[i] & Kinds.Due) != 0 && IsLeftToRows(input, graph, joints, input.Contacts.Records[_contacts[i]]))
            {
                Take(input, graph, i);
            }
        }
    }

    /// <summary>Looks ahead for a range of the pairs, as the graph is now: see <see cref="Take"/>.</summary>
    void IStageWork.Run(int worker, int from, int to)
    {
        for (int i = from; i < to; i++)
        {
            ref ContactRecord record = ref _input.Contacts.Records[_contacts[i]];
            bool movers = OfMovers(_input, record);
            ref Outlook found = ref _found[i];
            found.IsKnown = movers == _ofMovers && (movers || IsLeftToRows(_input, _graph, _joints, record));
            if (found.IsKnown)
            {
                Foresee(_input, _graph, _contacts[i], ref found);
            }

            // Bodies that are held stay so while rows are given: then a pair that meets nothing does not meet anything either. What rows
            // are not to see to now they may when another one holds its body.
            bool due = movers == _ofMovers && (!found.IsKnown || found.Meets || found.FreeA || found.FreeB || IsBeside(_input, record));
            _kinds[i] = (movers ? Kinds.OfMovers : Kinds.None) | (due ? Kinds.Due : Kinds.None);
        }
    }

    private static bool OfMovers(in ContactUpdateInput input, in ContactRecord record) =>
        input.Moves[record.BodyA] != 0 && input.Moves[record.BodyB] != 0;

    /// <summary>Of a pair of which one side cannot move: whether the sweep after the flight does not look after it.</summary>
    private bool IsLeftToRows(in ContactUpdateInput input, ConstraintGraph graph, JointStore joints, in ContactRecord record)
    {
        int mover = input.Moves[record.BodyA] != 0 ? record.BodyA : record.BodyB;
        bool held = _allHeld || graph.Degree(mover) > 0 || joints.Degree(mover) > 0;
        bool swept = (input.Bodies.Flags[mover] & (BodyFlags.Fast | BodyFlags.Discrete)) == BodyFlags.Fast;
        return held || !swept || !IsSolid(input, record);
    }

    private static bool IsSolid(in ContactUpdateInput input, in ContactRecord record) =>
        (input.Shapes.ColliderAt(record.PieceA).Flags & input.Shapes.ColliderAt(record.PieceB).Flags & ColliderFlags.ResponseEnabled) != 0
        && (input.Moves[record.BodyA] | input.Moves[record.BodyB]) != 0;

    /// <summary>
    /// Gives a pair its row if there is an impact ahead. What was found by looking ahead for all pairs at once stands unless a row that was
    /// given since then holds one of the bodies, which were free.
    /// </summary>
    private void Take(in ContactUpdateInput input, ConstraintGraph graph, int position)
    {
        int contact = _contacts[position];
        ref ContactRecord record = ref input.Contacts.Records[contact];
        ref Outlook found = ref _found[position];
        if (!found.IsKnown || found.FreeA != IsFree(input, graph, record.BodyA) || found.FreeB != IsFree(input, graph, record.BodyB))
        {
            Foresee(input, graph, contact, ref found);
        }

        if (!found.Meets)
        {
            if (IsBeside(input, record))
            {
                GiveBeside(input, graph, contact);
            }

            return;
        }

        bool heard = (record.Flags & ContactFlags.Heard) != 0;
        record.Flags |= ContactFlags.Touching | (heard ? ContactFlags.Due : ContactFlags.None);
        if (heard)
        {
            input.Contacts.Manifolds[contact] = found.Impact.Manifold;
        }

        if (IsSolid(input, record))
        {
            Give(input, graph, contact, found.Impact);
        }
    }

    /// <summary>A pair of a limb that gets a row though it does not meet.</summary>
    private static bool IsBeside(in ContactUpdateInput input, in ContactRecord record)
    {
        bool isRefused = (record.Flags & ContactFlags.Heard) != 0 && (record.Flags & ContactFlags.Vetoed) != 0;
        return (FastPairs.IsTied(input, record.BodyA) || FastPairs.IsTied(input, record.BodyB)) && !isRefused && IsSolid(input, record);
    }

    /// <summary>Looks along the ways of both for their impact.</summary>
    private static void Foresee(in ContactUpdateInput input, ConstraintGraph graph, int contact, ref Outlook found)
    {
        ref ContactRecord record = ref input.Contacts.Records[contact];
        found.FreeA = IsFree(input, graph, record.BodyA);
        found.FreeB = IsFree(input, graph, record.BodyB);
        found.Meets = false;
        found.Impact = default;
        BodyPath a = WaysAhead.Path(input, record.BodyA, found.FreeA);
        BodyPath b = WaysAhead.Path(input, record.BodyB, found.FreeB);
        ref Piece pieceA = ref input.Shapes.Pieces[record.PieceA];
        ref Piece pieceB = ref input.Shapes.Pieces[record.PieceB];
        float extent = FastPairs.Extent(pieceA, pieceB, input.Moves[record.BodyA] != 0, input.Moves[record.BodyB] != 0);

        // Most of what a body may meet along its way stays before one edge of it or of the other: half of the searches of a rotor in a
        // heap.
        double gap = PairStage.SkinShare * extent;
        if (ClearWay.HoldsForEither(input.Shapes, record, a, b, gap))
        {
            return;
        }

        ImpactQuery query;
        query.Tolerance = FastPairs.Tolerance(extent);
        query.Target = -FastPairs.Glance(pieceA, pieceB);
        query.From = 0;
        query.Until = 1;
        var search = new TimeOfImpact(input.Shapes, record.PieceA, a, record.PieceB, b);
        if (!search.Find(query, out double deep, out _))
        {
            return;
        }

        query.Target = 0;
        query.Until = Math.Min(1, deep + FastPairs.MomentShare);
        search.Find(query, out double time, out _);
        PairInput pair = ImpactPose.Pair(input.Shapes, record.PieceA, record.PieceB, a, b, time, (float)(4 * query.Tolerance));
        Collision.Collide(pair, out Manifold manifold);
        if (manifold.Count > 0 && record.Mover >= 0
            && WaysAhead.IsHidden(input, contact, manifold, record.Mover == record.PieceA ? a : b, time))
        {
            return;
        }

        found.Meets = manifold.Count > 0 && found.Impact.Set(manifold, a, b, time, pieceA.Radius, pieceB.Radius);
    }

    private void Give(in ContactUpdateInput input, ConstraintGraph graph, int contact, in ForeseenImpact impact)
    {
        ContactBundle* bundle = Clear(input, contact);
        ContactUpdate.FillImpact(input, bundle, impact);
        _struck.Note(input, input.Contacts.Records[contact], input.Pairs->Sinking[0]);
        Place(input, graph, contact);
        Given++;
    }

    /// <summary>
    /// Gives a row to a pair of a limb that passes something: its joints may stop it within the step and drive it in, where the sweep would
    /// hold it alone, away from its hinge (by 55 mm at a knee that came to its limit).
    /// </summary>
    private void GiveBeside(in ContactUpdateInput input, ConstraintGraph graph, int contact)
    {
        if (ContactUpdate.TryFillBeside(input, Clear(input, contact)))
        {
            Place(input, graph, contact);
        }
    }

    /// <summary>A bundle for the row of a pair, in its first lane; nothing is written yet but what it is called.</summary>
    private ContactBundle* Clear(in ContactUpdateInput input, int contact)
    {
        ContactBundle* bundle = _bundle;
        ContactLanes.ClearForWrite(bundle);
        ContactLanes.Name(bundle, 0, contact, input.Contacts.Records[contact]);
        return bundle;
    }

    /// <summary>Puts the row that was written in that bundle among those of the graph.</summary>
    private void Place(in ContactUpdateInput input, ConstraintGraph graph, int contact)
    {
        ref ContactRecord record = ref input.Contacts.Records[contact];
        ContactBundle* bundle = _bundle;
        input.Contacts.RemoveIdle(contact);
        graph.Add(contact, ref record, input.Moves[record.BodyA] != 0, input.Moves[record.BodyB] != 0);
        AnyBounce = AnyBounce || bundle->Restitution[0] > 0;
        ContactLanes.MoveLane(bundle, 0, graph.BundleOf(record.Row), RowArena.LaneOf(record.Row));
    }

    private static bool IsFree(in ContactUpdateInput input, ConstraintGraph graph, int body) =>
        input.Moves[body] != 0 && graph.Degree(body) == 0;

    /// <summary>What is to be done about a pair.</summary>
    [Flags]
    private enum Kinds : byte
    {
        None = 0,

        /// <summary>Both sides can move.</summary>
        OfMovers = 1,

        /// <summary>It may get a row.</summary>
        Due = 2,
    }

    /// <summary>What looking ahead told of a pair.</summary>
    private struct Outlook
    {
        public bool IsKnown;
        public bool Meets;

        /// <summary>Nothing held the bodies when it was looked for.</summary>
        public bool FreeA;
        public bool FreeB;
        public ForeseenImpact Impact;
    }
}
