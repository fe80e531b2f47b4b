using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Pairs beside a blow. A pair has a row if its bodies may meet within the step by the velocities of its start; but who is struck by a third
/// one in this step leaves with another velocity, and would fly into what lies beside it until the next step finds them overlapping: in
/// a heap of U-shapes by a sixth of their thickness, whatever the substeps. So bodies that will be struck are noted with the way by which
/// the blow may throw them off theirs, and their pairs without rows are looked at again as far as that.
/// </summary>
internal sealed unsafe class StruckPairs
{
    private readonly Column<float> _throws = new Column<float>();
    private readonly Column<ContactBundle> _bundle = new Column<ContactBundle>();
    private ScratchList<int> _struck;
    private ScratchList<int> _found;
    private JointStore _joints = null!;

    /// <summary>A body is struck.</summary>
    public bool Any => _struck.Count > 0;

    /// <summary>By how far each body may be thrown.</summary>
    public float* Throws => _throws.Pointer;

    /// <summary>Pairs that are to get rows.</summary>
    public ReadOnlySpan<int> Found => new ReadOnlySpan<int>(_found.Pointer, _found.Count);

    public void Begin(BodyStore bodies, JointStore joints, Scratch scratch)
    {
        _joints = joints;
        _struck = new ScratchList<int>(scratch);
        _found = new ScratchList<int>(scratch);
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
    public void Find(ContactUpdateInput input)
    {
        ContactStore contacts = input.Contacts;
        float* throws = Throws;
        input.Throws = throws;
        _bundle.EnsureCapacity(1);
        ContactRecord* records = contacts.Records.Pointer;
        BodyFlags* flags = input.Bodies.Flags.Pointer;
        int filled = 0;

        // In the order of memory, not of the idle list: what is found is put into an order of its own.
        for (int i = 0; i < contacts.End; i++)
        {
            ContactRecord* record = records + i;
            if (throws[record->BodyA] + throws[record->BodyB] > 0 && record->IsIdle
                && ((flags[record->BodyA] | flags[record->BodyB]) & BodyFlags.Asleep) == 0)
            {
                ContactRowWriter.Name(_bundle.Pointer, filled++, i, *record);
                if (filled == ContactBundle.Lanes)
                {
                    Look(input, filled);
                    filled = 0;
                }
            }
        }

        if (filled > 0)
        {
            Look(input, filled);
        }
    }

    /// <summary>Looks for the second points of rows of the bodies noted, which may be as far away as a blow turns them.</summary>
    public void Widen(ContactUpdateInput input, ConstraintGraph graph)
    {
        float* throws = Throws;
        input.Throws = throws;

        // The impulses of these rows are those of this step's substeps already.
        input.ImpulseScale = 1;
        int filled = 0;
        foreach (GraphColor color in graph.Used)
        {
            foreach (ContactBundle* bundle in color.Bundles)
            {
                ContactBundle.AskAhead(bundle->BodyA);
                ContactBundle.AskAhead(bundle->Single);
                int single = Singles(bundle);
                for (int lane = 0; single != 0; lane++, single >>= 1)
                {
                    if ((single & 1) == 0 || throws[bundle->BodyA[lane]] + throws[bundle->BodyB[lane]] == 0)
                    {
                        continue;
                    }

                    if (filled == 0)
                    {
                        ContactRowWriter.ClearForWrite(_bundle.Pointer);
                    }

                    ContactRowWriter.MoveLane(bundle, lane, _bundle.Pointer, filled++);
                    if (filled == ContactBundle.Lanes)
                    {
                        Rewrite(input, graph, filled);
                        filled = 0;
                    }
                }
            }
        }

        if (filled > 0)
        {
            Rewrite(input, graph, filled);
        }
    }

    /// <summary>The lanes of rows with one point, a bit each.</summary>
    private static int Singles(ContactBundle* bundle)
    {
        int bits = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            bits |= WideLanes.Bits(Wide.Load(bundle->Single + lane) > Wide.Zero) << lane;
        }

        return bits;
    }

    private void Rewrite(in ContactUpdateInput input, ConstraintGraph graph, int filled)
    {
        ContactBundle* bundle = _bundle.Pointer;
        ContactUpdate.FillRows(input, bundle);
        for (int lane = 0; lane < filled; lane++)
        {
            if (input.Pairs->Count[lane] > 1)
            {
                ref ContactRecord record = ref input.Contacts.Records[bundle->Contact[lane]];
                ContactRowWriter.MoveLane(bundle, lane, graph.BundleOf(record.Row), RowArena.LaneOf(record.Row));
            }
        }
    }

    private void Look(in ContactUpdateInput input, int filled)
    {
        ContactBundle* bundle = _bundle.Pointer;
        for (int lane = filled; lane < ContactBundle.Lanes; lane++)
        {
            ContactRowWriter.Unname(bundle, lane);
        }

        int found = ContactUpdate.FindStruck(input, bundle);
        for (int lane = 0; found != 0; lane++, found >>= 1)
        {
            if ((found & 1) != 0)
            {
                _found.Add(bundle->Contact[lane]);
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

        float a = Response(input, record.BodyA, record.PieceA);
        float b = Response(input, record.BodyB, record.PieceB);
        if (a > 0)
        {
            Note(record.BodyA, sinking * (a / (a + b)));
        }

        if (b > 0)
        {
            Note(record.BodyB, sinking * (b / (a + b)));
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

    /// <summary>What an impulse at the rim of a piece moves there; 0 for a body with joints, which hand the blow on to others.</summary>
    private float Response(in ContactUpdateInput input, int body, int piece)
    {
        if (input.Moves[body] == 0 || _joints.Degree(body) > 0)
        {
            return 0;
        }

        ref BodyMass mass = ref input.Bodies.Mass[body];
        float reach = input.Shapes.Pieces[piece].Reach;
        return mass.InverseMass + (mass.InverseInertia * reach * reach);
    }
}
