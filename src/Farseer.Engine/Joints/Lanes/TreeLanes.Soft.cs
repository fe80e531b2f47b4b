using System;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <content>
/// Motors and springs at the joints of trees: which there are, in which order, and to the records of the joints and back.
/// </content>
internal sealed unsafe partial class TreeLanes
{
    private const int MostSoft = 2;

    private readonly Column<LaneSoft> _softs = new Column<LaneSoft>();
    private readonly Column<LaneSoftPlace> _softPlaces = new Column<LaneSoftPlace>();
    private readonly Column<LaneWalk> _walks = new Column<LaneWalk>();

    /// <summary>The rows of the tree that is looked at, in the order of their sweep.</summary>
    private readonly Column<LaneSoftPlace> _drafts = new Column<LaneSoftPlace>();
    private readonly Column<ulong> _draftKeys = new Column<ulong>();
    private int _draftCount;
    private int _softCount;

    /// <summary>What a tree's joints have to sweep over.</summary>
    private void Draft(JointTree* tree)
    {
        _draftCount = 0;
        int most = tree->End - tree->First + tree->AnchorEnd - tree->AnchorFirst;
        _drafts.EnsureCapacity(most);
        _draftKeys.EnsureCapacity(most);
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            Draft(tree, _forest.Nodes[i].RowJoint[0], i - tree->First);
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            Draft(tree, _forest.Anchors[i].Active, ~(i - tree->AnchorFirst));
        }
    }

    private void Draft(JointTree* tree, int active, int joint)
    {
        JointRows* rows = _rows + active;
        if (!HasSoft(active))
        {
            return;
        }

        LaneForm form = FormOf(active);
        ref RowEnds ends = ref _active[active].Ends;
        LaneSoftPlace place = default;
        place.Joint = joint;
        place.NodeA = ends.NodeA < 0 ? -1 : ends.NodeA - tree->First;
        place.NodeB = ends.NodeB < 0 ? -1 : ends.NodeB - tree->First;
        for (int k = rows->Hard; k < rows->Count; k++)
        {
            if (rows->Type[k] != (byte)RowType.Limit)
            {
                LaneSoftKind kind;
                kind.Index = k;
                kind.IsSpring = rows->Type[k] == (byte)RowType.Spring;
                kind.Along = form == LaneForm.Slide || (form == LaneForm.Track && kind.IsSpring);
                place.Kind1 = kind;
                place.Kind0 = place.Rows++ == 0 ? kind : place.Kind0;
            }
        }

        // In the order of the bodies, and then of the joints, as all rows are swept.
        int first = place.NodeA < 0 ? place.NodeB : place.NodeB < 0 ? place.NodeA : Math.Min(place.NodeA, place.NodeB);
        ulong key = ((ulong)(uint)first << 32) | (uint)active;
        int at = _draftCount++;
        for (; at > 0 && _draftKeys[at - 1] > key; at--)
        {
            _draftKeys[at] = _draftKeys[at - 1];
            _drafts[at] = _drafts[at - 1];
        }

        _draftKeys[at] = key;
        _drafts[at] = place;
    }

    private bool HasSoft(int active)
    {
        JointRows* rows = _rows + active;
        for (int k = rows->Hard; k < rows->Count; k++)
        {
            if (rows->Type[k] != (byte)RowType.Limit)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>All rows behind the hard ones are limits that the block takes when they hold, or one or two motors and springs.</summary>
    private bool HasKnownRows(int active, LaneForm form)
    {
        JointRows* rows = _rows + active;
        int limits = 0;
        int softs = 0;
        for (int k = rows->Hard; k < rows->Count; k++)
        {
            limits += rows->Type[k] == (byte)RowType.Limit ? 1 : 0;
            softs += rows->Type[k] == (byte)RowType.Limit ? 0 : 1;
        }

        // Of a rope there is one.
        int ends = _active[active].Kind == JointKind.Rope ? 1 : 2;
        return (limits == 0 || (limits == ends && _active[active].BlockLimits)) && softs <= MostSoft
            && (rows->Count == rows->Hard || LaneForms.MayHaveMore(form));
    }

    /// <summary>The lower limit among the rows of a joint and the upper one behind it, -1: none. A rope has the upper one alone.</summary>
    private void FindLimits(int active, out int lower, out int upper)
    {
        JointRows* rows = _rows + active;
        lower = -1;
        upper = -1;
        for (int k = rows->Hard; k < rows->Count; k++)
        {
            if (rows->Type[k] == (byte)RowType.Limit)
            {
                lower = upper;
                upper = k;
            }
        }
    }

    private bool HasLimits(int active)
    {
        FindLimits(active, out _, out int upper);
        return upper >= 0;
    }

    private bool IsDrafted(LaneTrees* bundle)
    {
        bool same = bundle->Softs == _draftCount;
        for (int i = 0; same && i < _draftCount; i++)
        {
            same = _softPlaces[bundle->SoftFirst + i].IsSame(_drafts[i]);
        }

        return same;
    }

    private void AddDrafts(LaneTrees* bundle)
    {
        bundle->SoftFirst = _softCount;
        bundle->Softs = _draftCount;
        _softCount += _draftCount;
        _softs.EnsureCapacity(_softCount);
        _softPlaces.EnsureCapacity(_softCount);
        for (int i = 0; i < _draftCount; i++)
        {
            _softPlaces[bundle->SoftFirst + i] = _drafts[i];
        }

        if (bundle->HasRows)
        {
            _walks.EnsureCapacity(_nodeCount);
        }
    }

    public override int GivenSoft(int tree, int index)
    {
        LaneTrees* trees = _bundles.Pointer + _givenFrom[tree];
        int lane = 0;
        while (lane < trees->Count - 1 && trees->Tree[lane] != _given[tree])
        {
            lane++;
        }

        return trees->SweepsSofts && index < trees->Softs ? ActiveOf(trees, _softPlaces.Pointer + trees->SoftFirst + index, lane) : -1;
    }

    private int ActiveOf(LaneTrees* trees, LaneSoftPlace* soft, int lane) => soft->Joint >= 0
        ? _places[trees->First + soft->Joint].Active[lane]
        : _anchorPlaces[trees->AnchorFirst + ~soft->Joint].Active[lane];

    private LaneWalks WalksOf(LaneTrees* trees, int lane)
    {
        LaneWalks walks = default;
        walks.Nodes = DoubleLanes.Shift(_nodes.Pointer + trees->First, lane);
        walks.Walks = DoubleLanes.Shift(_walks.Pointer + trees->First, lane);
        walks.Places = _places.Pointer + trees->First;
        walks.Anchors = DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst, lane);
        walks.AnchorPlaces = _anchorPlaces.Pointer + trees->AnchorFirst;
        walks.Count = trees->Nodes;
        walks.AnchorCount = trees->Anchors;
        return walks;
    }

    private LaneWalk* WalksOrNone(LaneTrees* trees) => trees->HasRows ? _walks.Pointer + trees->First : null;

    /// <summary>Sweeps may follow each other without a look at limits.</summary>
    public bool SweepsByItself()
    {
        bool alone = true;
        for (int b = 0; b < _count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            alone &= !(trees->HasLimits && trees->HasRows);
        }

        return alone;
    }

    private void ExchangeBends(LaneTrees* trees, int lane, bool load)
    {
        int from = lane < trees->Count ? lane : 0;
        for (int i = 1; i < trees->Nodes; i++)
        {
            LaneBends* bends = &DoubleLanes.Shift(_walks.Pointer + trees->First + i, lane)->Bends;
            ExchangeBends(bends, _active + _places[trees->First + i].Active[from], load);
        }

        for (int i = 0; i < trees->Anchors; i++)
        {
            LaneBends* bends = &DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane)->Bends;
            ExchangeBends(bends, _active + _anchorPlaces[trees->AnchorFirst + i].Active[from], load);
        }
    }

    private static void ExchangeBends(LaneBends* bends, ActiveJoint* joint, bool load)
    {
        for (int row = 0; row < TreeFactor.MostRows; row++)
        {
            if (load)
            {
                bends->Bend[row * Y] = joint->Bend[row];
                bends->Foreseen[row * Y] = joint->Foreseen[row];
            }
            else
            {
                joint->Bend[row] = bends->Bend[row * Y];
                joint->Foreseen[row] = bends->Foreseen[row * Y];
            }
        }
    }

    private void LoadSofts(LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes && trees->HasRows; lane++)
        {
            ExchangeBends(trees, lane, true);
        }

        for (int i = trees->SoftFirst; i < trees->SoftFirst + trees->Softs; i++)
        {
            for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
            {
                LaneSoft* soft = DoubleLanes.Shift(_softs.Pointer + i, lane);
                int active = ActiveOf(trees, _softPlaces.Pointer + i, lane < trees->Count ? lane : 0);
                soft->SpringMass[0] = _rows[active].SpringMass;
                soft->Hold[0] = JointPass.HoldOf(_forest.Trees, _forest.Nodes, _active + active);
                soft->Early[0] = JointPass.EarlyOf(_forest.Trees + trees->Tree[lane < trees->Count ? lane : 0]);
                LoadRow(&soft->Row0, _active + active, _rows + active, _softPlaces[i].Kind0.Index);
                LoadRow(&soft->Row1, _active + active, _rows + active, _softPlaces[i].Kind1.Index);
            }
        }
    }

    /// <summary>What a row of a joint starts a step with.</summary>
    public static void LoadRow(LaneSoftRow* row, ActiveJoint* joint, JointRows* rows, int k)
    {
        row->Lambda[0] = joint->Lambda[k];
        row->Speed[0] = rows->Speed[k];
        row->Low[0] = rows->Low[k];
        row->High[0] = rows->High[k];
        row->Share[0] = rows->Share[k];
        row->Stiffness[0] = rows->Stiffness[k];
        row->Damping[0] = rows->Damping[k];
        row->Ahead[0] = 0;
        row->Start[0] = 0;
    }

    /// <summary>
    /// See <see cref="JointPass.Foresee"/>. Of a tree with contacts the joints themselves are told: they are swept there.
    /// </summary>
    private void Foresee(LaneTrees* trees, int lane)
    {
        for (int i = trees->SoftFirst; i < trees->SoftFirst + trees->Softs; i++)
        {
            LaneSoft* soft = DoubleLanes.Shift(_softs.Pointer + i, lane);
            LaneSoftPlace* place = _softPlaces.Pointer + i;
            int active = ActiveOf(trees, place, lane);
            for (int k = 0; k < place->Rows; k++)
            {
                LaneSoftKind kind = k == 0 ? place->Kind0 : place->Kind1;
                LaneSoftRow* row = k == 0 ? &soft->Row0 : &soft->Row1;
                if (kind.IsSpring && trees->Touched)
                {
                    JointRows* rows = _rows + active;
                    double speed = StartSpeed(trees, lane, place->NodeA, _active[active].Ends.BodyA, rows->A + (kind.Index * 3), 1)
                        + StartSpeed(trees, lane, place->NodeB, _active[active].Ends.BodyB, rows->B + (kind.Index * 3), 1);
                    _active[active].SpringAhead[kind.Index] = _active[active].SpringLead[kind.Index] * speed;
                }
                else if (kind.IsSpring)
                {
                    double speed = StartSpeed(trees, lane, place->NodeA, _active[active].Ends.BodyA, row->A, Y)
                        + StartSpeed(trees, lane, place->NodeB, _active[active].Ends.BodyB, row->B, Y);
                    row->Ahead[0] = row->Lead[0] * speed;
                }
            }
        }
    }

    private double StartSpeed(LaneTrees* trees, int lane, int node, int body, double* j, int stride)
    {
        double* held = DoubleLanes.Shift(_nodes.Pointer + trees->First + Math.Max(0, node), lane)->Velocity;
        return HeldVelocity.StartSpeed(_step.Bodies, body, node >= 0, held, Y, j, stride);
    }

    /// <summary>The impulses of a tree's motors and springs to its joints.</summary>
    /// <param name="trees">The bundle.</param>
    /// <param name="lane">The tree.</param>
    /// <param name="before">Those from before the pass.</param>
    private void PutSoftsBack(LaneTrees* trees, int lane, bool before)
    {
        if (trees->HasRows)
        {
            ExchangeBends(trees, lane, false);
        }

        for (int i = trees->SoftFirst; i < trees->SoftFirst + trees->Softs; i++)
        {
            LaneSoft* soft = DoubleLanes.Shift(_softs.Pointer + i, lane);
            LaneSoftPlace* place = _softPlaces.Pointer + i;
            ActiveJoint* joint = _active + ActiveOf(trees, place, lane);
            if (trees->Touched)
            {
                joint->PlainLambda[place->Kind0.Index] = joint->Lambda[place->Kind0.Index];
                joint->PlainLambda[place->Kind1.Index] = joint->Lambda[place->Kind1.Index];
                continue;
            }

            PutRowBack(joint, place->Kind0.Index, &soft->Row0, before);
            if (place->Rows > 1)
            {
                PutRowBack(joint, place->Kind1.Index, &soft->Row1, before);
            }
        }
    }

    private static void PutRowBack(ActiveJoint* joint, int index, LaneSoftRow* row, bool before)
    {
        double lambda = before ? row->Before[0] : row->Lambda[0];
        joint->Lambda[index] = lambda;
        joint->PlainLambda[index] = lambda;
        joint->Start[index] = row->Start[0];
        joint->SpringAhead[index] = row->Ahead[0];
    }

    /// <summary>Notes what the joints have given before a pass: a tree that is given back starts the pass anew elsewhere.</summary>
    private void PutGivenAside(LaneTrees* trees)
    {
        for (int i = 1; i < trees->Nodes; i++)
        {
            LaneJoint* joint = &_nodes.Pointer[trees->First + i].Joint;
            Copy(joint->Given, joint->PlainGiven, 4);
        }

        for (int i = 0; i < trees->Anchors; i++)
        {
            LaneJoint* joint = &_anchors.Pointer[trees->AnchorFirst + i].Joint;
            Copy(joint->Given, joint->PlainGiven, 4);
        }

        for (int i = trees->SoftFirst; i < trees->SoftFirst + trees->Softs; i++)
        {
            LaneSoft* soft = _softs.Pointer + i;
            Copy(soft->Row0.Lambda, soft->Row0.Before, 1);
            Copy(soft->Row1.Lambda, soft->Row1.Before, 1);
        }
    }
}
