using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>Contacts with trees: taken out of their lanes for the step, solved in the order of the trees, and given back.</summary>
internal sealed unsafe partial class TreeContacts : JointPart
{
    /// <summary>Room from the first contact on: a few ragdolls that lie down one after the other need more ever later.</summary>
    private const int LeastContacts = 64;
    private readonly Column<ulong> _agendaKeys = new Column<ulong>();

    /// <summary>By the record of the contact.</summary>
    private readonly Column<HeldGap> _gaps = new Column<HeldGap>();

    public TreeContacts(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>Contacts are solved against trees.</summary>
    public bool AnyContacts => _work.ContactCount > 0;

    /// <summary>
    /// Takes the contacts with trees out of a colour's lanes, which are inert from then on. Both of a contact's bodies take part in
    /// the joints' passes: one that has no joints as a guest.
    /// </summary>
    /// <returns>True if the lanes have contacts left.</returns>
    public bool Take(ContactBundle* bundles, int count)
    {
        bool left = false;
        for (int i = 0; i < count; i++)
        {
            ContactBundle* bundle = ContactBundle.At(bundles, i);
            ContactBundle.AskAhead(bundle->BodyA);
            ContactBundle.AskAhead(bundle->Contact);
            ContactBundle.AskAhead(bundle->Point0.Base);
            bool wheels = false;
            for (int lane = 0; lane < ContactBundle.Lanes; lane++)
            {
                bool touches = IsInTree(bundle->BodyA[lane]) || IsInTree(bundle->BodyB[lane]);
                if (bundle->Contact[lane] < 0 || !Exists(&bundle->Point0, lane))
                {
                    continue;
                }

                if (!touches)
                {
                    left = true;
                }
                else if (_work.AnyWheels && TakeWheel(bundle, lane))
                {
                    wheels = true;
                }
                else
                {
                    _contacts.EnsureCapacity(Math.Max(_work.ContactCount + 1, LeastContacts));
                    Take(bundle, lane, _contacts.Pointer + _work.ContactCount++);
                }
            }

            if (wheels)
            {
                ContactRowWriter.WriteResponses(bundle);
                left = true;
            }
        }

        return left;
    }

    /// <summary>
    /// After <see cref="JointSolver.Start"/>: sweeps over rows of trees may follow each other without a look at anything else, as far as
    /// the joints are concerned. Nets and wheels have rows on lanes, and limits of trees are asked for after each sweep.
    /// </summary>
    public bool SweepsByItself()
    {
        bool alone = !_nets.Any && !_work.AnyWheels && _lanes.SoftRows.SweepsByItself();
        for (int at = 0; alone && at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            alone = !(tree->HasLimits && tree->HasRows);
        }

        return alone;
    }

    /// <summary>A contact that was left on lanes concerns a body of the trees.</summary>
    public bool SharesBodies(ContactBundle* bundles, int count)
    {
        for (int i = 0; i < count; i++)
        {
            ContactBundle* bundle = ContactBundle.At(bundles, i);
            for (int lane = 0; lane < ContactBundle.Lanes; lane++)
            {
                if (bundle->Contact[lane] >= 0 && Exists(&bundle->Point0, lane)
                    && (_forest.NodeOf(bundle->BodyA[lane]) >= 0 || _forest.NodeOf(bundle->BodyB[lane]) >= 0))
                {
                    return true;
                }
            }
        }

        return false;
    }

    public bool IsInTree(int body)
    {
        int node = _forest.NodeOf(body);
        return node >= 0 && _forest.Trees[_forest.Nodes[node].Tree].Eliminates;
    }

    public static bool Exists(ContactPointLanes* point, int lane) => point->Base[lane] < ContactBundle.NoPoint * 0.5f;

    private static void Take(ContactBundle* bundle, int lane, TreeContact* contact)
    {
        *contact = default;
        contact->Bundle = bundle;
        contact->Lane = lane;
        contact->Ends.BodyA = bundle->BodyA[lane];
        contact->Ends.BodyB = bundle->BodyB[lane];
        contact->Points = Exists(&bundle->Point1, lane) ? 2 : 1;
        contact->NormalX = bundle->NormalX[lane];
        contact->NormalY = bundle->NormalY[lane];
        contact->Friction = bundle->Friction[lane];
        contact->Restitution = bundle->Restitution[lane];
        contact->RadiusA = bundle->RadiusA[lane];
        contact->RadiusB = bundle->RadiusB[lane];
        contact->FeedRate = bundle->FeedRate[lane];
        contact->FeedShare = bundle->FeedShare[lane];
        contact->Deep = (bundle->Flags[lane] & ContactBundle.DeepMark) != 0;
        contact->Point0.Rest = ContactBundle.RestDepthOf(bundle, lane);
        contact->Point1.Rest = contact->Point0.Rest;
        Take(&bundle->Point0, lane, ref contact->Point0);
        if (contact->Points > 1)
        {
            Take(&bundle->Point1, lane, ref contact->Point1);
        }
    }

    private static void Take(ContactPointLanes* from, int lane, ref TreeContactPoint to)
    {
        to.NormalArmA = from->NormalArmA[lane];
        to.TangentArmA = from->TangentArmA[lane];
        to.NormalArmB = from->NormalArmB[lane];
        to.TangentArmB = from->TangentArmB[lane];
        to.Base = from->Base[lane];
        to.Normal = from->Normal[lane];
        to.Tangent = from->Tangent[lane];
        to.PreviousNormal = from->PreviousNormal[lane];
        to.PreviousTangent = from->PreviousTangent[lane];
        to.Feed = from->Feed[lane];

        // So far away that no pass ever gives it an impulse.
        from->Base[lane] = ContactBundle.NoPoint;
        from->Normal[lane] = 0;
        from->Tangent[lane] = 0;
        from->PreviousNormal[lane] = 0;
        from->PreviousTangent[lane] = 0;
        from->Feed[lane] = 0;
    }

    /// <summary>The contacts go on from the gaps of the last step.</summary>
    public void RecallGaps()
    {
        for (int i = 0; i < _work.ContactCount; i++)
        {
            TreeContact* contact = _contacts.Pointer + i;
            int index = contact->Bundle->Contact[contact->Lane];
            if (index < _gaps.Capacity)
            {
                _contactPass.Recall(contact, _gaps[index]);
            }
        }
    }

    public void NoteGaps()
    {
        for (int i = 0; i < _work.ContactCount; i++)
        {
            TreeContact* contact = _contacts.Pointer + i;
            int index = contact->Bundle->Contact[contact->Lane];
            _gaps.EnsureCapacity(Math.Max(index + 1, _work.Step.ContactRoom));
            TreeContactPass.Note(contact, ref _gaps[index]);
        }
    }

    public void GiveContactsBack()
    {
        for (int i = 0; i < _work.ContactCount; i++)
        {
            TreeContact* contact = _contacts.Pointer + i;
            if (contact->Struck > 0)
            {
                contact->Bundle->Struck[contact->Lane] = (float)contact->Struck;
            }

            GiveBack(contact->Point0, &contact->Bundle->Point0, contact->Lane);
            if (contact->Points > 1)
            {
                GiveBack(contact->Point1, &contact->Bundle->Point1, contact->Lane);
            }
        }
    }

    private static void GiveBack(in TreeContactPoint from, ContactPointLanes* to, int lane)
    {
        to->Base[lane] = (float)from.Base;
        to->Normal[lane] = (float)from.Normal;
        to->Tangent[lane] = (float)from.Tangent;
        to->PreviousNormal[lane] = (float)from.PreviousNormal;
        to->PreviousTangent[lane] = (float)from.PreviousTangent;
        to->Feed[lane] = (float)from.Feed;
    }

    /// <summary>
    /// Makes guests of bodies that touch trees, and puts all iterated rows in the order of the trees, then of the contacts.
    /// </summary>
    public void Collate()
    {
        _forest.ReserveGuests(_contacts.Capacity * 2, _work.Step.Bodies.Ids.End);
        _loose.ReserveBodies();

        // Quiet chains, which are in no list, may come back to them later in the step.
        _trees.EnsureCapacity(_forest.TreeRoom);
        _nodes.EnsureCapacity(_forest.NodeRoom);
        for (int i = 0; i < _work.ContactCount; i++)
        {
            ref RowEnds ends = ref _contacts[i].Ends;
            Invite(ends.BodyA);
            Invite(ends.BodyB);
            _forest.SetNodes(ref ends, _work.Step.Moves);
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            _forest.Trees[i].HasRows = false;
            _forest.Trees[i].Joined = false;
            _forest.Trees[i].Pressed = false;
            _forest.Trees[i].Group = i;
        }

        for (int at = 0; at < _work.NodeCount; at++)
        {
            _forest.Nodes[_nodes[at]].Bears = false;
        }

        _work.AgendaCount = 0;
        _agendaKeys.EnsureCapacity(_active.Capacity + _contacts.Capacity);
        _agenda.EnsureCapacity(_active.Capacity + _contacts.Capacity);
        bool anyLimited = false;
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            anyLimited |= _active[i].Limited;
            if (Iterates(_active.Pointer + i, _rows.Pointer + i))
            {
                Enlist(_active[i].Ends, i, (uint)i);
                _solver.Limits.Join(i);
            }
        }

        if (anyLimited)
        {
            _solver.Limits.ReserveKept();
        }

        for (int i = 0; i < _work.ContactCount; i++)
        {
            uint contact = (uint)_contacts[i].Bundle->Contact[_contacts[i].Lane];
            Enlist(_contacts[i].Ends, ~i, contact | 0x80000000u);
            Press(_contacts[i].Ends.NodeA);
            Press(_contacts[i].Ends.NodeB);
        }

        // By itself a tree meets its loops; what else pushes at it opens them.
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            if (_active[i].Role != JointRole.Loop || !_forest.Trees[_forest.TreeOf(_active[i].Ends)].HasRows)
            {
                continue;
            }

            Load(_active[i].Ends.NodeA);
            Load(_active[i].Ends.NodeB);
            if (_active[i].LeadsLoops && !Iterates(_active.Pointer + i, _rows.Pointer + i))
            {
                Enlist(_active[i].Ends, i, (uint)i);
            }
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            _forest.Trees[_trees[at]].Group = GroupOf(_trees[at]);
        }

        _sort.Sort(_agendaKeys.Pointer, _agenda.Pointer, _work.AgendaCount);
    }

    private void Press(int node)
    {
        if (node >= 0)
        {
            _forest.Trees[_forest.Nodes[node].Tree].Pressed = true;
        }
    }

    private void Invite(int body)
    {
        if (_work.Step.Moves[body] != 0 && _forest.NodeOf(body) < 0)
        {
            _forest.AddGuest(body);
            _solver.Collection.ChooseTree(_forest.TreeCount - 1);
            _solver.Bodies.LoadMass(_forest.Nodes + (_forest.Count - 1));
        }
    }

    private static bool Iterates(ActiveJoint* joint, JointRows* rows)
    {
        if (joint->Role == JointRole.Iterated)
        {
            return true;
        }

        for (int k = rows->Hard; k < rows->Count; k++)
        {
            if (!JointPass.IsInBlock(joint, rows, k))
            {
                return true;
            }
        }

        return false;
    }

    private void Enlist(in RowEnds ends, int item, uint key)
    {
        int first = int.MaxValue;
        if (ends.NodeA >= 0)
        {
            first = ends.NodeA;
            Load(ends.NodeA);
        }

        if (ends.NodeB >= 0)
        {
            first = ends.NodeB < first ? ends.NodeB : first;
            Load(ends.NodeB);
        }

        if (ends.NodeA >= 0 && ends.NodeB >= 0 && !ends.Coupled)
        {
            int a = GroupOf(_forest.Nodes[ends.NodeA].Tree);
            int b = GroupOf(_forest.Nodes[ends.NodeB].Tree);
            _forest.Trees[Math.Max(a, b)].Group = Math.Min(a, b);
        }

        _agendaKeys[_work.AgendaCount] = ((ulong)(uint)first << 32) | key;
        _agenda[_work.AgendaCount++] = item;
    }

    private void Load(int node)
    {
        _forest.Trees[_forest.Nodes[node].Tree].HasRows = true;
        for (int at = node; at >= 0 && !_forest.Nodes[at].Bears; at = _forest.Nodes[at].Parent)
        {
            _forest.Nodes[at].Bears = true;
        }
    }

    /// <summary>The first tree of a tree's group; ways to it become shorter, and lead to lower numbers only.</summary>
    private int GroupOf(int tree)
    {
        JointTree* trees = _forest.Trees;
        while (trees[tree].Group != tree)
        {
            trees[tree].Group = trees[trees[tree].Group].Group;
            tree = trees[tree].Group;
        }

        return tree;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_agendaKeys);
        s.Column(_gaps);
    }
}
