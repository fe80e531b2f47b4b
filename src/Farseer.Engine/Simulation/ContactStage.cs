using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Runs the narrow phase over all pairs and moves pairs in and out of the graph, in an order set by the state alone.</summary>
internal sealed unsafe class ContactStage
{
    private readonly Column<int> _lost = new Column<int>();
    private readonly Column<int> _dropped = new Column<int>();
    private readonly Column<ulong> _gainKeys = new Column<ulong>();
    private readonly Column<int> _gained = new Column<int>();
    private readonly RadixSort _sort = new RadixSort();

    /// <summary>A contact of the graph can bounce.</summary>
    public bool AnyBounce { get; private set; }

    /// <summary>At least half of the pairs that touch do so for the first time in this step.</summary>
    public bool ColdStart { get; private set; }

    /// <summary>A pair has a listener.</summary>
    public bool AnyHeard { get; private set; }

    public void Update(in ContactUpdateInput input, ConstraintGraph graph)
    {
        ContactStore contacts = input.Contacts;
        AnyBounce = false;
        AnyHeard = false;
        int lost = 0;
        int dropped = 0;
        int gained = 0;
        int touching = 0;
        int touchingNow = 0;
        _lost.EnsureCapacity(contacts.Records.Capacity);
        _dropped.EnsureCapacity(contacts.Records.Capacity);
        _gained.EnsureCapacity(contacts.Records.Capacity);
        _gainKeys.EnsureCapacity(contacts.Records.Capacity);
        for (int c = 0; c < ConstraintGraph.ColorCount; c++)
        {
            GraphColor color = graph[c];
            int rows = color.RowCount;
            for (int r = 0; r < rows; r++)
            {
                ContactBundle* bundle = color.BundleOf(r);
                int lane = color.LaneOf(r);
                int index = bundle->Contact[lane];
                ContactFlags before = contacts.Records[index].Flags;
                ContactFate fate = ContactUpdate.UpdateRow(input, bundle, lane);
                CountTouching(before, contacts.Records[index].Flags, ref touching, ref touchingNow);
                AnyBounce |= bundle->Restitution[lane] > 0;
                AnyHeard |= (contacts.Records[index].Flags & ContactFlags.Heard) != 0;
                if (fate == ContactFate.Lose)
                {
                    _lost[lost++] = index;
                }
                else if (fate == ContactFate.Drop)
                {
                    _dropped[dropped++] = index;
                }
            }
        }

        for (int i = 0; i < contacts.IdleCount; i++)
        {
            int index = contacts.Idle(i);
            ContactFlags before = contacts.Records[index].Flags;
            ContactFate fate = ContactUpdate.UpdateIdle(input, index);
            CountTouching(before, contacts.Records[index].Flags, ref touching, ref touchingNow);
            AnyHeard |= (contacts.Records[index].Flags & ContactFlags.Heard) != 0;
            if (fate == ContactFate.Gain)
            {
                ref ContactRecord record = ref contacts.Records[index];
                _gainKeys[gained] = Shuffle(PairKey(record));
                _gained[gained++] = index;
            }
            else if (fate == ContactFate.Drop)
            {
                _dropped[dropped++] = index;
            }
        }

        Take(contacts, graph, lost, dropped);
        Give(input, graph, gained);
        ColdStart = touchingNow > 0 && touchingNow * 2 >= touching;
    }

    /// <summary>Takes a pair out of the graph and forgets it.</summary>
    public static void Drop(ContactStore contacts, ConstraintGraph graph, int index)
    {
        ref ContactRecord record = ref contacts.Records[index];
        ulong key = PairKey(record);
        if (record.Color >= 0)
        {
            graph.Remove(ref record, contacts.Records);
            contacts.AddIdle(index);
        }

        contacts.Destroy(index, key);
    }

    private static void CountTouching(ContactFlags before, ContactFlags after, ref int touching, ref int touchingNow)
    {
        if ((after & ContactFlags.Touching) != 0)
        {
            touching++;
            touchingNow += (before & ContactFlags.Touching) == 0 ? 1 : 0;
        }
    }

    public static ulong PairKey(in ContactRecord record) => BroadPhase.PairBuffer.Pack(record.PieceA, record.PieceB);

    private void Take(ContactStore contacts, ConstraintGraph graph, int lost, int dropped)
    {
        for (int i = 0; i < lost; i++)
        {
            graph.Remove(ref contacts.Records[_lost[i]], contacts.Records);
            contacts.AddIdle(_lost[i]);
        }

        for (int i = 0; i < dropped; i++)
        {
            Drop(contacts, graph, _dropped[i]);
        }
    }

    /// <summary>
    /// New rows are coloured in a shuffled order: in creation order a stack gets all left supports in one colour and all right
    /// ones in another, and drifts sideways.
    /// </summary>
    private void Give(in ContactUpdateInput input, ConstraintGraph graph, int gained)
    {
        ContactStore contacts = input.Contacts;
        _sort.Sort(_gainKeys.Pointer, _gained.Pointer, gained);
        for (int i = 0; i < gained; i++)
        {
            int index = _gained[i];
            ref ContactRecord record = ref contacts.Records[index];
            contacts.RemoveIdle(index);
            graph.Add(index, ref record, input.Moves[record.BodyA] != 0, input.Moves[record.BodyB] != 0);
            GraphColor color = graph[record.Color];
            ContactBundle* bundle = color.BundleOf(record.Row);
            ContactUpdate.FillRow(input, index, bundle, color.LaneOf(record.Row));
            AnyBounce |= bundle->Restitution[color.LaneOf(record.Row)] > 0;
        }
    }

    // A fixed mixing of the bits (the finaliser of MurmurHash3); distinct keys stay distinct.
    private static ulong Shuffle(ulong key)
    {
        key ^= key >> 33;
        key *= 0xFF51AFD7ED558CCDUL;
        key ^= key >> 33;
        key *= 0xC4CEB9FE1A85EC53UL;
        key ^= key >> 33;
        return key;
    }
}
