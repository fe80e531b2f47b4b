using System;
using System.Runtime.InteropServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <content>
/// Wheels: bodies that a hinge at their centre of mass leaves nothing but their spin. The inverse mass of such a tree is (0, 0, 1/I),
/// which a row on lanes can have as well: with no mass in it, only the inertia, a contact sees exactly what the tree would answer, and
/// the hinge need not be asked again. So drums and rotors, which meet hundreds, keep their contacts on the lanes; what the contacts
/// load the hinge with is added up for those who ask for its force.
/// </content>
internal sealed unsafe partial class TreeContacts
{
    /// <summary>A body that fewer touch stays with the doubles of the trees.</summary>
    private const int ManyContacts = 32;

    /// <summary>Distance of the hinge from the centre of mass in radii of gyration, squared, that is the rounding of the place.</summary>
    private const double OffCentre = 1e-10;

    /// <summary>Error of the hinge in radii of gyration, squared, up to which nobody put the body elsewhere.</summary>
    private const double Disturbing = 1e-4;

    [NotState(Why.OfOneStep)]
    private readonly Column<WheelContact> _wheelContacts = new Column<WheelContact>();

    /// <summary>Finds the wheels at the poses of the step's start.</summary>
    public void FindWheels()
    {
        _work.AnyWheels = false;
        _work.WheelContactCount = 0;
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            JointTree* tree = _forest.Trees + i;
            tree->Wheel = IsWheel(tree);
            _work.AnyWheels |= tree->Wheel;
        }
    }

    /// <summary>One body, whose only joint is a hinge at its centre with something that cannot move; a motor may drive it.</summary>
    private bool IsWheel(JointTree* tree)
    {
        if (tree->End != tree->First + 1 || tree->AnchorEnd != tree->AnchorFirst + 1 || tree->HasLimits || tree->Disturbed || tree->Pulled)
        {
            return false;
        }

        TreeNode* node = _forest.Nodes + tree->First;
        TreeAnchor* anchor = _forest.Anchors + tree->AnchorFirst;
        JointRows* rows = _rows.Pointer + anchor->Active;
        if (_work.Step.Touches[node->Body] < ManyContacts || !_forest.IsOnlyJoint(node->Body) || anchor->Rows != 2)
        {
            return false;
        }

        // Rows of a pivot: (±1, 0, r), (0, ±1, r').
        double* s = _active[anchor->Active].Ends.NodeA == anchor->Node ? rows->A : rows->B;
        bool pivot = s[0] * s[0] == 1 && s[1] == 0 && s[3] == 0 && s[4] * s[4] == 1;
        double arm = (s[2] * s[2]) + (s[5] * s[5]);
        double error = (rows->Error[0] * rows->Error[0]) + (rows->Error[1] * rows->Error[1]);
        return pivot
            && arm * node->InverseInertia <= OffCentre * node->InverseMass
            && error * node->InverseInertia <= Disturbing * node->InverseMass;
    }

    /// <summary>Leaves a contact with a wheel in its lane, if its other body is one of those that move and hang on no tree.</summary>
    private bool TakeWheel(ContactBundle* bundle, int lane)
    {
        bool isA = IsOfWheel(bundle->BodyA[lane]);
        int other = isA ? bundle->BodyB[lane] : bundle->BodyA[lane];
        if (!(isA || IsOfWheel(bundle->BodyB[lane])) || _work.Step.Moves[other] == 0 || IsInTree(other))
        {
            return false;
        }

        if (_work.WheelContactCount == _wheelContacts.Capacity)
        {
            // A drum that fills has one of its contacts for every eighth body or so.
            _wheelContacts.EnsureCapacity(Math.Max(_work.WheelContactCount + 1, _work.Step.Bodies.State.Capacity / 4));
        }

        ref WheelContact contact = ref _wheelContacts[_work.WheelContactCount++];
        contact.Bundle = bundle;
        contact.Lane = lane;
        contact.Node = _forest.NodeOf(isA ? bundle->BodyA[lane] : bundle->BodyB[lane]);
        contact.IsA = isA;
        if (isA)
        {
            bundle->MassA[lane] = 0;
        }
        else
        {
            bundle->MassB[lane] = 0;
        }

        return true;
    }

    private bool IsOfWheel(int body)
    {
        int node = _forest.NodeOf(body);
        return node >= 0 && _forest.Trees[_forest.Nodes[node].Tree].Wheel;
    }

    /// <summary>
    /// At the start of a substep: contacts on lanes cannot move a wheel's centre, so what the hinge takes out of its fall, it takes out
    /// before they look.
    /// </summary>
    public void HoldWheels()
    {
        for (int at = 0; _work.AnyWheels && at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (tree->Wheel)
            {
                _solver.Limits.SolveTree(tree, TargetKind.Biased);
            }
        }
    }

    /// <summary>The turn of a wheel in doubles follows what others have done to its float.</summary>
    public void TurnWheels()
    {
        for (int at = 0; _work.AnyWheels && at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            TreeNode* node = _forest.Nodes + tree->First;
            if (tree->Wheel && _work.Step.Bodies.Motion[node->Body].Turned != (float)node->Move[2])
            {
                _solver.Bodies.SetMove(node, node->Move[0], node->Move[1], TurnOf(node));
            }
        }
    }

    /// <summary>Where the store has turned a body from where its doubles are.</summary>
    public double TurnOf(TreeNode* node) => node->Move[2] + ((double)_work.Step.Bodies.Motion[node->Body].Turned - (float)node->Move[2]);

    /// <summary>After a substep, while all impulses still stand: what the contacts of wheels load the hinges with.</summary>
    public void NoteLoads()
    {
        for (int at = 0; _work.AnyWheels && at < _work.TreeCount; at++)
        {
            double* got = _forest.Nodes[_forest.Trees[_trees[at]].First].Got;
            got[0] = 0;
            got[1] = 0;
            got[2] = 0;
        }

        for (int i = 0; i < _work.WheelContactCount; i++)
        {
            ref WheelContact contact = ref _wheelContacts[i];
            ContactBundle* row = contact.Bundle;
            int lane = contact.Lane;
            double sign = contact.IsA ? -1 : 1;
            double normal = sign * ((double)row->Point0.Normal[lane] + row->Point1.Normal[lane]);
            double tangent = sign * ((double)row->Point0.Tangent[lane] + row->Point1.Tangent[lane]);
            double* got = _forest.Nodes[contact.Node].Got;
            got[0] += (row->NormalX[lane] * normal) + (row->NormalY[lane] * tangent);
            got[1] += (row->NormalY[lane] * normal) - (row->NormalX[lane] * tangent);
        }

        for (int at = 0; _work.AnyWheels && at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (tree->Wheel)
            {
                TreeReactions.OfLoads(_forest, tree);
                TreeReactions.Give(_forest, tree, _active.Pointer, _rows.Pointer);
            }
        }
    }

    /// <summary>A contact with a wheel, in its lane.</summary>
    [StructLayout(LayoutKind.Sequential)]
    private struct WheelContact
    {
        public ContactBundle* Bundle;
        public int Lane;
        public int Node;

        /// <summary>The wheel is body A.</summary>
        public bool IsA;
    }
}
