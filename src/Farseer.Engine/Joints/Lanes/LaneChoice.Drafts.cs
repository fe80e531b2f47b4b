using System;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <content>Motors and springs at the joints of trees: which there are, and in which order.</content>
internal sealed unsafe partial class LaneChoice
{
    private const int MostSoft = 2;

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
            Draft(tree, _work.Forest.Nodes[i].RowJoint[0], i - tree->First);
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            Draft(tree, _work.Forest.Anchors[i].Active, ~(i - tree->AnchorFirst));
        }
    }

    private void Draft(JointTree* tree, int active, int joint)
    {
        JointRows* rows = _work.Rows + active;
        if (!HasSoft(active))
        {
            return;
        }

        LaneForm form = FormOf(active);
        ref RowEnds ends = ref _work.Active[active].Ends;
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
        JointRows* rows = _work.Rows + active;
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
        JointRows* rows = _work.Rows + active;
        int limits = 0;
        int softs = 0;
        for (int k = rows->Hard; k < rows->Count; k++)
        {
            limits += rows->Type[k] == (byte)RowType.Limit ? 1 : 0;
            softs += rows->Type[k] == (byte)RowType.Limit ? 0 : 1;
        }

        // Of a rope there is one.
        int ends = _work.Active[active].Kind == JointKind.Rope ? 1 : 2;
        return (limits == 0 || (limits == ends && _work.Active[active].BlockLimits)) && softs <= MostSoft
            && (rows->Count == rows->Hard || LaneForms.MayHaveMore(form));
    }

    /// <summary>The lower limit among the rows of a joint and the upper one behind it, -1: none. A rope has the upper one alone.</summary>
    private void FindLimits(int active, out int lower, out int upper)
    {
        JointRows* rows = _work.Rows + active;
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
            _walks.EnsureCapacity(_work.NodeCount);
        }
    }
}
