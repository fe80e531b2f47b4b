using System;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <content>
/// The impulses that a substep starts from. Of a tree whose own surfaces touch each other a sweep takes back only a part of what was too
/// much, since these answer its turns with far more than its weight: a ragdoll whose limbs lay against each other at a blow was given speed
/// in substep after substep, half a metre of height in a step.
/// </content>
internal sealed unsafe partial class TreeContacts
{
    public void WarmStart(Column<int> trees, int treeCount, Column<int> agenda, int agendaCount)
    {
        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            tree->Tempers = false;
            tree->GroupTempers = false;
        }

        bool tempers = false;
        for (int i = 0; i < agendaCount; i++)
        {
            if (agenda[i] < 0)
            {
                TreeContact* contact = _contacts.Pointer + ~agenda[i];
                if (_solver.Sweeps.IsPulled(agenda[i]))
                {
                    TreeContactPass.Forget(contact);
                    continue;
                }

                _contactPass.Extrapolate(contact);
                tempers |= contact->Ends.Coupled && contact->Point0.Normal + contact->Point1.Normal > 0 && BeginTempering(contact);
            }
        }

        if (tempers)
        {
            Temper(trees, treeCount, agenda, agendaCount);
        }

        for (int i = 0; i < agendaCount; i++)
        {
            int item = agenda[i];
            if (item < 0)
            {
                _contactPass.Push(_contacts.Pointer + ~item);
            }
            else
            {
                _pass.WarmStart(_active.Pointer + item, _rows.Pointer + item);
            }
        }
    }

    public JointTree* GroupAt(int item) => _forest.Trees + _forest.Trees[_forest.TreeOf(_solver.Sweeps.EndsOf(item))].Group;

    /// <summary>Of their impulses trees with anchors or loops take a part that is not known before they are solved.</summary>
    private bool BeginTempering(TreeContact* contact)
    {
        JointTree* tree = TreeOf(contact);
        if (tree->AnchorFirst < tree->AnchorEnd || tree->LoopRows > 0 || tree->OnChain)
        {
            return false;
        }

        tree->Tempers = true;
        tree->Opposed = 0;
        tree->Answered = 0;
        _forest.Trees[tree->Group].GroupTempers = true;
        return true;
    }

    private JointTree* TreeOf(TreeContact* contact) => _forest.Trees + _forest.TreeOf(contact->Ends);

    /// <summary>Its impulses are those of a tree on itself that are tempered.</summary>
    private bool IsTempered(int item) => item < 0 && _contacts[~item].Ends.Coupled && TreeOf(_contacts.Pointer + ~item)->Tempers;

    /// <summary>
    /// Impulses λ of a tree on itself against the speeds v that all others leave answer Kλ and give the energy λ·v + λ·Kλ/2. Surfaces that
    /// do not bounce give none: where it would be more than none, they start from the share of them that takes the most. What trees give
    /// to each other is left as it is: tempered along with it, piles of chains never came to rest, since what one chain had too much took
    /// the support from under all of them.
    /// </summary>
    private void Temper(Column<int> trees, int treeCount, Column<int> agenda, int agendaCount)
    {
        for (int i = 0; i < agendaCount; i++)
        {
            if (IsTempered(agenda[i]))
            {
                TreeContact* contact = _contacts.Pointer + ~agenda[i];
                TreeOf(contact)->Opposed += _contactPass.Power(contact);
            }
        }

        CarryFromRest(trees, treeCount, agenda, agendaCount, false);
        CarryFromRest(trees, treeCount, agenda, agendaCount, true);
        for (int i = 0; i < agendaCount; i++)
        {
            if (IsTempered(agenda[i]))
            {
                TreeContact* contact = _contacts.Pointer + ~agenda[i];
                JointTree* tree = TreeOf(contact);
                if (tree->Opposed + (0.5 * tree->Answered) > 0)
                {
                    TreeContactPass.Scale(contact, Math.Max(0, -tree->Opposed) / tree->Answered);
                }
            }
        }
    }

    /// <summary>
    /// Finds what tempered impulses do against the speeds that they alone would make, or that all others alone would make.
    /// </summary>
    private void CarryFromRest(Column<int> trees, int treeCount, Column<int> agenda, int agendaCount, bool tempered)
    {
        JointForestView view = _forest.View;
        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            if (_forest.Trees[tree->Group].GroupTempers)
            {
                _solver.Limits.Save(tree);
                _solver.Positions.Clear(tree);
                TreeWalk.Begin(view, tree);
            }
        }

        for (int i = 0; i < agendaCount; i++)
        {
            if (agenda[i] < 0 && GroupAt(agenda[i])->GroupTempers && IsTempered(agenda[i]) == tempered)
            {
                _contactPass.Carry(_contacts.Pointer + ~agenda[i]);
            }
        }

        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            if (_forest.Trees[tree->Group].GroupTempers)
            {
                TreeWalk.End(view, tree);
            }
        }

        for (int i = 0; i < agendaCount; i++)
        {
            if (IsTempered(agenda[i]))
            {
                TreeContact* contact = _contacts.Pointer + ~agenda[i];
                double power = _contactPass.OwnPower(contact);
                TreeOf(contact)->Opposed += tempered ? 0 : power;
                TreeOf(contact)->Answered += tempered ? power : 0;
            }
        }

        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            if (_forest.Trees[tree->Group].GroupTempers)
            {
                _solver.Limits.Restore(tree);
            }
        }
    }
}
