using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Pairs beside a blow. A pair has a row if its bodies may meet within the step by the velocities of its start; but who is struck by a
/// third one in this step leaves with another velocity, and would fly into what lies beside it until the next step finds them overlapping:
/// in a heap of U-shapes by a sixth of their thickness, whatever the substeps. So bodies that will be struck are noted with the way by
/// which the blow may throw them off theirs, and their pairs without rows are looked at again as far as that.
/// </summary>
/// <remarks>
/// Workers look at blocks of pairs and of bundles. A block packs what it looks at into bundles of its own, so that these do not follow from
/// who had which.
/// </remarks>
[NotState(Why.OfOneStep)]
internal sealed unsafe class StruckPairs : IStageWork
{
    /// <summary>Pairs of a block, of which most are passed over, and bundles of rows: some 2 µs each.</summary>
    private const int BlockPairs = 1024;
    private const int BlockBundles = 64;
    private const int BlockWords = BlockPairs / BitSet.WordBits;

    /// <summary>
    /// A limb whips on by more than the way that was taken from the struck one: twice, if that is stopped in the middle of its way.
    /// </summary>
    private const float Whip = 2;

    /// <summary>Bodies that a blow is handed on to by joints: three puppets. In a bridge or a net the nearest.</summary>
    private const int MostReached = 32;

    private readonly Column<float> _throws = new Column<float>();

    /// <summary>A bundle for each worker.</summary>
    private WorkerLanes* _lanes;
    private ColorRanges _ranges = null!;

    /// <summary>In scratch memory: pairs that are to get rows, a bit for each place of the idle list.</summary>
    private ulong* _marks;
    private ContactUpdateInput _input;
    private ConstraintGraph _graph = null!;
    private bool _widens;
    private ScratchList<int> _struck;
    private ScratchList<int> _found;
    private ScratchList<int> _reached;
    private JointStore _joints = null!;

    /// <summary>A body is struck.</summary>
    public bool Any => _struck.Count > 0;

    /// <summary>By how far each body may be thrown.</summary>
    public float* Throws => _throws.Pointer;

    /// <summary>Pairs that are to get rows.</summary>
    public ReadOnlySpan<int> Found => new ReadOnlySpan<int>(_found.Pointer, _found.Count);

    public void Begin(StageRunner runner, BodyStore bodies, JointStore joints, Scratch scratch)
    {
        _lanes = scratch.Lasting<WorkerLanes>(runner.Workers);
        _joints = joints;
        _struck = new ScratchList<int>(scratch);
        _found = new ScratchList<int>(scratch);
        _reached = new ScratchList<int>(scratch);
        _throws.EnsureCapacity(bodies.State.Capacity);
    }

    /// <summary>Forgets the blows of this step.</summary>
    public void End()
    {
        for (int i = 0; i < _struck.Count; i++)
        {
            _throws[_struck[i]] = 0;
        }

        _struck.SetCount(0);
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget()
    {
        _input.Forget();
        _ranges = null!;
        _graph = null!;
        _joints = null!;
    }

    /// <summary>Notes the blows of a bundle's pairs.</summary>
    public void Note(in ContactUpdateInput input, BundleOutcome* outcome, int* contacts)
    {
        for (int lane = 0, blows = outcome->Fates.Blows; blows != 0; lane++, blows >>= 1)
        {
            if ((blows & 1) != 0)
            {
                Note(input, input.Contacts.Records[contacts[lane]], outcome->Sinking[lane]);
            }
        }
    }

    /// <summary>Looks at the pairs without rows of the bodies noted.</summary>
    public void Find(StageRunner runner, in ContactUpdateInput input)
    {
        int blocks = (input.Contacts.IdleCount + BlockPairs - 1) / BlockPairs;
        int words = blocks * BlockWords;
        _marks = input.Scratch.Take<ulong>(words);
        _widens = false;
        Run(runner, input, blocks);
        for (int word = 0; word < words; word++)
        {
            for (ulong marks = _marks[word]; marks != 0; marks &= marks - 1)
            {
                _found.Add(input.Contacts.Idle((word * BitSet.WordBits) + BitSet.LowestBit(marks)));
            }
        }
    }

    /// <summary>Looks for the second points of rows of the bodies noted, which may be as far away as a blow turns them.</summary>
    public void Widen(StageRunner runner, ContactUpdateInput input, ConstraintGraph graph)
    {
        // The impulses of these rows are those of this step's substeps already.
        input.ImpulseScale = 1;
        _graph = graph;
        _ranges = graph.NumberBundles(parts: 1);
        _widens = true;
        Run(runner, input, (_ranges.Count + BlockBundles - 1) / BlockBundles);
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        ContactUpdateInput input = _input;
        input.Pairs = &(_lanes + worker)->Pairs;
        ContactBundle* bundle = &(_lanes + worker)->Struck;
        for (int block = from; block < to; block++)
        {
            if (_widens)
            {
                Widen(input, bundle, block * BlockBundles, Math.Min((block + 1) * BlockBundles, _ranges.Count));
            }
            else
            {
                Find(input, bundle, block * BlockPairs, Math.Min((block + 1) * BlockPairs, input.Contacts.IdleCount));
            }
        }
    }

    private void Run(StageRunner runner, in ContactUpdateInput input, int blocks)
    {
        _input = input;
        _input.Throws = Throws;
        runner.Run(this, blocks, 1);
    }

    private void Find(in ContactUpdateInput input, ContactBundle* bundle, int from, int to)
    {
        float* throws = Throws;
        ContactStore contacts = input.Contacts;
        BodyFlags* flags = input.Bodies.Flags.Pointer;
        int* places = stackalloc int[ContactBundle.Lanes];
        for (int word = 0; word < BlockWords; word++)
        {
            _marks[(from / BitSet.WordBits) + word] = 0;
        }

        int filled = 0;
        for (int first = from; first < to; first += ContactBundle.Lanes)
        {
            int* bodyA = contacts.IdleBodyA + first;
            int* bodyB = contacts.IdleBodyB + first;
            int exist = (1 << Math.Min(ContactBundle.Lanes, to - first)) - 1;
            for (int lane = 0, thrown = ThrownLanes(throws, bodyA, bodyB) & exist; thrown != 0; lane++, thrown >>= 1)
            {
                if ((thrown & 1) == 0 || ((flags[bodyA[lane]] | flags[bodyB[lane]]) & BodyFlags.Asleep) != 0)
                {
                    continue;
                }

                Prefetch.Line(contacts.Records.Pointer + contacts.Idle(first + lane));
                places[filled++] = first + lane;
                if (filled == ContactBundle.Lanes)
                {
                    Look(input, bundle, places, filled);
                    filled = 0;
                }
            }
        }

        if (filled > 0)
        {
            Look(input, bundle, places, filled);
        }
    }

    /// <summary>A bit for each of eight pairs of which one body may be thrown.</summary>
    private static int ThrownLanes(float* throws, int* bodyA, int* bodyB)
    {
        int thrown = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            Wide throwsOfBoth = WideTable.Read(throws, bodyA + lane) + WideTable.Read(throws, bodyB + lane);
            thrown |= WideLanes.Bits(throwsOfBoth > Wide.Zero) << lane;
        }

        return thrown;
    }

    private void Widen(in ContactUpdateInput input, ContactBundle* rewritten, int from, int to)
    {
        float* throws = Throws;
        int filled = 0;
        while (from < to)
        {
            foreach (ContactBundle* bundle in new BundleWalk(_ranges.From(from, to, out from)))
            {
                ContactBundle.AskAhead(bundle->BodyA);
                ContactBundle.AskAhead(bundle->Flags);

                int thrown = ThrownLanes(throws, bundle->BodyA, bundle->BodyB) & ContactBundle.LanesWith(bundle, ContactBundle.SingleMark);
                for (int lane = 0; thrown != 0; lane++, thrown >>= 1)
                {
                    if ((thrown & 1) == 0)
                    {
                        continue;
                    }

                    if (filled == 0)
                    {
                        ContactLanes.ClearForWrite(rewritten);
                    }

                    ContactLanes.MoveLane(bundle, lane, rewritten, filled++);
                    if (filled == ContactBundle.Lanes)
                    {
                        Rewrite(input, rewritten, filled);
                        filled = 0;
                    }
                }
            }
        }

        if (filled > 0)
        {
            Rewrite(input, rewritten, filled);
        }
    }

    private void Rewrite(in ContactUpdateInput input, ContactBundle* bundle, int filled)
    {
        ContactUpdate.FillRows(input, bundle, beside: false);
        for (int lane = 0; lane < filled; lane++)
        {
            if (input.Pairs->Count[lane] > 1)
            {
                ref ContactRecord record = ref input.Contacts.Records[bundle->Contact[lane]];
                ContactLanes.MoveLane(bundle, lane, _graph.BundleOf(record.Row), RowArena.LaneOf(record.Row));
            }
        }
    }

    private void Look(in ContactUpdateInput input, ContactBundle* bundle, int* places, int filled)
    {
        // Named together: their records lie anywhere, and are waited for at once.
        for (int lane = 0; lane < filled; lane++)
        {
            int contact = input.Contacts.Idle(places[lane]);
            ContactLanes.Name(bundle, lane, contact, input.Contacts.Records[contact]);
        }

        for (int lane = filled; lane < ContactBundle.Lanes; lane++)
        {
            ContactLanes.Unname(bundle, lane);
        }

        int found = ContactUpdate.FindStruck(input, bundle);
        for (int lane = 0; found != 0; lane++, found >>= 1)
        {
            if ((found & 1) != 0)
            {
                _marks[places[lane] / BitSet.WordBits] |= 1UL << (places[lane] % BitSet.WordBits);
            }
        }
    }

    /// <summary>Notes a blow.</summary>
    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="record">The pair.</param>
    /// <param name="sinking">How deep the pair would sink in within the step.</param>
    public void Note(in ContactUpdateInput input, in ContactRecord record, float sinking)
    {
        if (!(sinking > 0))
        {
            return;
        }

        Note(input, record.BodyA, record.PieceA, record.BodyB, sinking);
        Note(input, record.BodyB, record.PieceB, record.BodyA, sinking);
    }

    private void Note(in ContactUpdateInput input, int body, int piece, int other, float sinking)
    {
        if (input.Moves[body] == 0 || _joints.Degree(body) > 0)
        {
            HandOn(input, body, Whip * sinking);
        }
        else
        {
            Note(body, sinking * ShareOf(input, body, piece, other));
        }
    }

    /// <summary>Notes a struck body and those that joints tie to it, the nearest first; none if nothing that moves is tied to it.</summary>
    private void HandOn(in ContactUpdateInput input, int body, float way)
    {
        if (input.Moves[body] == 0)
        {
            return;
        }

        _reached.SetCount(0);
        Reach(input, body, way);
        for (int i = 0; i < _reached.Count && _reached.Count < MostReached; i++)
        {
            Reach(input, _reached[i], way);
        }

        if (_reached.Count > 0)
        {
            Note(body, way);
        }
    }

    /// <summary>Notes the neighbours of a body that no blow has reached yet, and lists them.</summary>
    private void Reach(in ContactUpdateInput input, int body, float way)
    {
        for (int entry = _joints.First(body); entry >= 0; entry = _joints.Next(entry))
        {
            int other = _joints.Other(entry);
            if (input.Moves[other] != 0 && _throws[other] < way && _joints.IsTie(entry >> 1))
            {
                Note(other, way);
                _reached.Add(other);
            }
        }
    }

    private void Note(int body, float way)
    {
        if (_throws[body] == 0)
        {
            _struck.Add(body);
        }

        _throws[body] = Math.Max(_throws[body], way);
    }

    /// <summary>
    /// The most by which a point of a piece is thrown off its way, by what the struck points would sink in. An impulse at the lever x·R
    /// that ends the approach of a body with the inverse mass m and inertia i on one of m' moves the rim, at the lever R, by (m +
    /// i·R²·x)/(m + i·R²·x² + m'), if that one is hit in its middle: at most by 1/(2x) at the root of i·R²·x² + 2·m·x = m + m'.
    /// </summary>
    private float ShareOf(in ContactUpdateInput input, int body, int piece, int other)
    {
        ref BodyMass mass = ref input.Bodies.Mass[body];
        float reach = input.Shapes.Pieces[piece].Reach;
        float turn = mass.InverseInertia * reach * reach;
        float both = mass.InverseMass + (input.Moves[other] != 0 && _joints.Degree(other) == 0 ? input.Bodies.Mass[other].InverseMass : 0);
        float lever = (both / (mass.InverseMass + (float)Math.Sqrt((mass.InverseMass * mass.InverseMass) + (turn * both))));
        return lever < 1 ? 0.5f / lever : (mass.InverseMass + turn) / (both + turn);
    }
}
