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
            _forest.Trees[trees[at]].Tempers = false;
        }

        bool tempers = false;
        for (int i = 0; i < agendaCount; i++)
        {
            if (agenda[i] < 0)
            {
                TreeContact* contact = _contacts.Pointer + ~agenda[i];
                if (_solver.Positions.IsDisplaced(contact->Ends))
                {
                    TreeContactPass.Forget(contact);
                    continue;
                }

                _contactPass.Extrapolate(contact);
                if (contact->Ends.Coupled && contact->Point0.Normal + contact->Point1.Normal > 0)
                {
                    GroupAt(agenda[i])->Tempers = true;
                    tempers = true;
                }
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

    /// <summary>
    /// Impulses λ against speeds v answer Kλ and give the energy λ·v + λ·Kλ/2. Surfaces that do not bounce give none: where it would be
    /// more than none, impulses start from the share of them that takes the most. Trees with anchors are left as they are: of their weight
    /// these take a part that is not known before they are solved.
    /// </summary>
    private void Temper(Column<int> trees, int treeCount, Column<int> agenda, int agendaCount)
    {
        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            JointTree* group = _forest.Trees + tree->Group;
            group->Tempers &= tree->AnchorFirst == tree->AnchorEnd && !tree->OnChain;
            group->Opposed = 0;
            group->Answered = 0;
        }

        for (int i = 0; i < agendaCount; i++)
        {
            if (agenda[i] < 0 && GroupAt(agenda[i])->Tempers)
            {
                GroupAt(agenda[i])->Opposed += _contactPass.Power(_contacts.Pointer + ~agenda[i]);
            }
        }

        CarryFromRest(trees, treeCount, agenda, agendaCount);
        for (int i = 0; i < agendaCount; i++)
        {
            JointTree* group = GroupAt(agenda[i]);
            if (agenda[i] < 0 && group->Tempers && group->Opposed + (0.5 * group->Answered) > 0)
            {
                TreeContactPass.Scale(_contacts.Pointer + ~agenda[i], Math.Max(0, -group->Opposed) / group->Answered);
            }
        }
    }

    /// <summary>Finds what the impulses of contacts do against the speeds that they alone would make.</summary>
    private void CarryFromRest(Column<int> trees, int treeCount, Column<int> agenda, int agendaCount)
    {
        JointForestView view = _forest.View;
        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            if (_forest.Trees[tree->Group].Tempers)
            {
                _solver.Limits.Save(tree);
                _solver.Positions.Clear(tree);
                TreeWalk.Begin(view, tree);
            }
        }

        for (int i = 0; i < agendaCount; i++)
        {
            if (agenda[i] < 0 && GroupAt(agenda[i])->Tempers)
            {
                _contactPass.Carry(_contacts.Pointer + ~agenda[i]);
            }
        }

        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            if (_forest.Trees[tree->Group].Tempers)
            {
                TreeWalk.End(view, tree);
            }
        }

        for (int i = 0; i < agendaCount; i++)
        {
            if (agenda[i] < 0 && GroupAt(agenda[i])->Tempers)
            {
                GroupAt(agenda[i])->Answered += _contactPass.OwnPower(_contacts.Pointer + ~agenda[i]);
            }
        }

        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            if (_forest.Trees[tree->Group].Tempers)
            {
                _solver.Limits.Restore(tree);
            }
        }
    }
}
