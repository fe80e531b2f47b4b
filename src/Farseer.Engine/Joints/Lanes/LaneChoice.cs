using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>Which trees go side by side.</summary>
internal sealed unsafe partial class LaneChoice : LanePart
{
    /// <summary>Bundles with empty lanes that a tree is compared with.</summary>
    private const int OpenBundles = 16;

    private const ulong HashPrime = 1099511628211;

    /// <summary>Room in the hash for what a joint is, beside its place.</summary>
    private const int FormBits = 4096;

    public LaneChoice(LaneWork work)
        : base(work)
    {
    }

    /// <summary>Before the trees of a step are taken.</summary>
    /// <param name="forest">The trees.</param>
    /// <param name="active">The joints.</param>
    /// <param name="rows">Their rows.</param>
    /// <param name="step">What the joints see of the step.</param>
    public void Begin(JointForest forest, ActiveJoint* active, JointRows* rows, in JointStep step)
    {
        _work.Forest = forest;
        _work.Active = active;
        _work.Rows = rows;
        _work.Step = step;
        _work.Count = 0;
        _work.NodeCount = 0;
        _work.AnchorCount = 0;
        _softCount = 0;
        _work.HasMoved = false;
        _bundles.EnsureCapacity(forest.OwnTrees);
        _work.GivenTrees.EnsureCapacity(forest.OwnTrees);
        _work.GivenFrom.EnsureCapacity(forest.OwnTrees);
    }

    /// <summary>Makes room for all trees that could be taken, so that one that is let go of late in a run does not allocate.</summary>
    public void Reserve()
    {
        for (int i = 0; i < _work.Forest.TreeCount; i++)
        {
            Take(i);
        }

        _work.Count = 0;
        _walks.EnsureCapacity(_work.NodeCount);
    }

    /// <summary>Takes a tree if its kind can be solved here.</summary>
    /// <returns>True if it was taken.</returns>
    public bool Take(int index)
    {
        JointTree* tree = _work.Forest.Trees + index;
        if (!tree->Eliminates || tree->Tied || tree->Pulled || tree->Guest || tree->Wheel || !IsKnown(tree))
        {
            return false;
        }

        Draft(tree);
        if (_draftCount > 0 && _work.Step.Audited)
        {
            // Whoever asks for the work of motors asks the joints themselves.
            return false;
        }

        ulong shape = ShapeOf(tree);
        for (int b = _work.Count - 1; b >= 0 && b >= _work.Count - OpenBundles; b--)
        {
            LaneTrees* open = _bundles.Pointer + b;
            if (open->Shape == shape && open->Touched == tree->Touched && open->Count < Numerics.DoubleLanes.BundleLanes)
            {
                if (open->Count == 0)
                {
                    Open(open);
                    Draft(tree);
                }

                if (IsLike(open, tree))
                {
                    Enter(open, index);
                    return true;
                }
            }
        }

        LaneTrees* bundle = _bundles.Pointer + _work.Count++;
        *bundle = default;
        bundle->Shape = shape;
        bundle->Touched = tree->Touched;
        bundle->Tree[0] = index;
        return true;
    }

    /// <summary>
    /// Leaves those that found no partner: with three empty lanes a beam of welds took 1.3 times the time that it takes by itself, a crane
    /// with motors 1.25 times, and a comb of 32,000 hinges 1.5 times.
    /// </summary>
    public void LeaveSingles()
    {
        int kept = 0;
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* bundle = _bundles.Pointer + b;
            if (bundle->Count > 1)
            {
                _bundles[kept++] = *bundle;
            }
            else
            {
                _work.Forest.Trees[bundle->Tree[0]].OnLanes = false;
            }
        }

        _work.Count = kept;
    }

    /// <summary>Each edge and anchor is one joint of a form that is known here; an edge may have a second one.</summary>
    private bool IsKnown(JointTree* tree)
    {
        if (tree->LimitEdges)
        {
            return false;
        }

        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _work.Forest.Nodes + i;
            if (FormOf(node->RowJoint[0]) == LaneForm.None || (node->EdgeCount > 1 && !IsKnownPair(node)))
            {
                return false;
            }
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            if (FormOf(_work.Forest.Anchors[i].Active) == LaneForm.None)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>The second joint of an edge may be a servo, or a range where the first has no limits.</summary>
    private bool IsKnownPair(TreeNode* node)
    {
        int second = SecondOf(node);
        return node->EdgeCount == 2 && LaneForms.MayBeSecond(FormOf(second)) && !(HasLimits(node->RowJoint[0]) && HasLimits(second));
    }

    /// <summary>The joint of an edge beside the one that has its first row, -1: none.</summary>
    private int SecondOf(TreeNode* node)
    {
        int* joints = _work.Forest.EdgeJoints + node->EdgeFirst;
        return node->EdgeCount < 2 ? -1 : joints[0] == node->RowJoint[0] ? joints[1] : joints[0];
    }

    private LaneForm FormOf(int active)
    {
        LaneForm form = LaneForms.Of(_work.Active[active].Kind, _work.Rows[active]);
        return HasKnownRows(active, form) ? form : LaneForm.None;
    }

    private bool IsA(int active, int node) => _work.Active[active].Ends.NodeA == node;

    private ulong ShapeOf(JointTree* tree)
    {
        ulong hash = (ulong)(tree->End - tree->First);
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _work.Forest.Nodes + i;
            int second = SecondOf(node);
            uint bits = BitsOf(node->RowJoint[0], i) + (second < 0 ? 0 : BitsOf(second, i) << 6);
            hash = (hash * HashPrime) ^ ((ulong)((node->Parent - tree->First) * FormBits) + bits);
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = _work.Forest.Anchors + i;
            hash = (hash * HashPrime) ^ ((ulong)((anchor->Node - tree->First) * FormBits) + BitsOf(anchor->Active, anchor->Node));
        }

        return hash;
    }

    private uint BitsOf(int active, int node) => (IsA(active, node) ? 1u : 0) | (HasLimits(active) ? 2u : 0) | ((uint)FormOf(active) << 2);

    private bool IsLike(LanePlace* place, int parent, int active, int second, int node)
    {
        LanePlace other = default;
        SetPlace(&other, parent, active, second, node);
        return place->Parent == parent
            && place->IsA == other.IsA
            && place->Form == other.Form
            && place->Second == other.Second
            && place->SecondIsA == other.SecondIsA
            && place->LowerRow == other.LowerRow
            && place->UpperRow == other.UpperRow;
    }

    private bool IsLike(LaneTrees* bundle, JointTree* tree)
    {
        if (bundle->Nodes != tree->End - tree->First || bundle->Anchors != tree->AnchorEnd - tree->AnchorFirst || !IsDrafted(bundle))
        {
            return false;
        }

        for (int i = 1; i < bundle->Nodes; i++)
        {
            TreeNode* node = _work.Forest.Nodes + tree->First + i;
            LanePlace* place = _places.Pointer + bundle->First + i;
            if (!IsLike(place, node->Parent - tree->First, node->RowJoint[0], SecondOf(node), tree->First + i))
            {
                return false;
            }
        }

        for (int i = 0; i < bundle->Anchors; i++)
        {
            TreeAnchor* anchor = _work.Forest.Anchors + tree->AnchorFirst + i;
            LanePlace* place = _anchorPlaces.Pointer + bundle->AnchorFirst + i;
            if (!IsLike(place, anchor->Node - tree->First, anchor->Active, -1, anchor->Node))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Enters the first tree of a bundle, now that there is another one to compare with: most large trees have none.</summary>
    private void Open(LaneTrees* bundle)
    {
        int index = bundle->Tree[0];
        JointTree* tree = _work.Forest.Trees + index;
        Draft(tree);
        bundle->First = _work.NodeCount;
        bundle->Nodes = tree->End - tree->First;
        bundle->AnchorFirst = _work.AnchorCount;
        bundle->Anchors = tree->AnchorEnd - tree->AnchorFirst;
        bundle->HasLimits = tree->HasLimits;
        _work.NodeCount += bundle->Nodes;
        _work.AnchorCount += bundle->Anchors;
        _nodes.EnsureCapacity(_work.NodeCount);
        _places.EnsureCapacity(_work.NodeCount);
        _anchors.EnsureCapacity(_work.AnchorCount);
        _anchorPlaces.EnsureCapacity(_work.AnchorCount);
        AddDrafts(bundle);
        for (int i = 0; i < bundle->Nodes; i++)
        {
            TreeNode* node = _work.Forest.Nodes + tree->First + i;
            LanePlace* place = _places.Pointer + bundle->First + i;
            *place = default;
            place->Parent = -1;
            place->Anchored = node->Anchored;
            if (i > 0)
            {
                SetPlace(place, node->Parent - tree->First, node->RowJoint[0], SecondOf(node), tree->First + i);
            }
        }

        for (int i = 0; i < bundle->Anchors; i++)
        {
            TreeAnchor* anchor = _work.Forest.Anchors + tree->AnchorFirst + i;
            LanePlace* place = _anchorPlaces.Pointer + bundle->AnchorFirst + i;
            *place = default;
            SetPlace(place, anchor->Node - tree->First, anchor->Active, -1, anchor->Node);
        }

        Enter(bundle, index);
    }

    private void SetPlace(LanePlace* place, int parent, int active, int second, int node)
    {
        place->Parent = parent;
        place->IsA = IsA(active, node);
        place->Form = FormOf(active);
        place->Second = second < 0 ? LaneForm.None : FormOf(second);
        place->SecondIsA = second >= 0 && IsA(second, node);
        bool ofSecond = place->Second == LaneForm.Range;
        FindLimits(ofSecond ? second : active, out int lower, out int upper);
        place->LowerRow = (sbyte)lower;
        place->UpperRow = (sbyte)upper;
        place->HasLimits = upper >= 0;
        place->LimitTurns = ofSecond || LaneForms.BoundsTurn(place->Form);
        place->LimitIsA = ofSecond ? place->SecondIsA : place->IsA;
        place->HasMore = _work.Rows[active].Count > _work.Rows[active].Hard;

        // The first row behind the hard ones is along the line where any is: a spring, a lower limit or a motor that slides.
        place->LineRow = (sbyte)(place->HasMore ? _work.Rows[active].Hard : -1);
        place->Rows = (byte)LaneForms.RowsOf(place->Form);
        place->HardRows = (byte)(place->Rows + (place->Second == LaneForm.Servo ? 1 : 0));
        place->BlockRows = place->HardRows;
        place->Turning = (byte)LaneForms.TurningRowsOf(place->Form);
    }

    private void Enter(LaneTrees* bundle, int index)
    {
        JointTree* tree = _work.Forest.Trees + index;
        int lane = bundle->Count++;
        bundle->Tree[lane] = index;
        bundle->Live |= 1 << lane;
        for (int i = 0; i < bundle->Nodes; i++)
        {
            TreeNode* node = _work.Forest.Nodes + tree->First + i;
            _places[bundle->First + i].Body[lane] = node->Body;
            _places[bundle->First + i].Active[lane] = i == 0 ? -1 : node->RowJoint[0];
            _places[bundle->First + i].ActiveSecond[lane] = SecondOf(node);
        }

        for (int i = 0; i < bundle->Anchors; i++)
        {
            TreeAnchor* anchor = _work.Forest.Anchors + tree->AnchorFirst + i;
            ref RowEnds ends = ref _work.Active[anchor->Active].Ends;
            _anchorPlaces[bundle->AnchorFirst + i].Body[lane] = ends.NodeA == anchor->Node ? ends.BodyB : ends.BodyA;
            _anchorPlaces[bundle->AnchorFirst + i].Active[lane] = anchor->Active;
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_drafts);
        s.Column(_draftKeys);
        s.Value(ref _draftCount);
        s.Value(ref _softCount);
    }
}
