using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>The passes over the trees of a substep: trees exactly, then the rows that are iterated, in their order.</summary>
[NotState(Why.Fixed)]
internal sealed unsafe class TreeSweeps : JointPart
{
    /// <summary>
    /// Sweeps over the contacts of a group of trees in a pass, at most. One is enough where they go on pressing, since they start from the
    /// impulses of the substep before. Of a blow nothing is known beforehand: with one sweep a ring of light links that a box fell on at
    /// 6 m/s lay 60 mm deep in itself three steps later, and rings in a pit had overlaps as thick as their links; with sixteen both stay
    /// within 3 mm.
    /// </summary>
    private const int MostSweeps = 16;

    /// <summary>
    /// A sweep that changes speeds by less than this share of the largest change so far is the last one. Where there is gravity, so is
    /// one that changes them by less than that brings in a substep: the next substep has as much to do.
    /// </summary>
    private const double SettledShare = 0.02;

    /// <summary>The last sweeps of so many take back what conjugate directions went too far.</summary>
    private const int PlainSweeps = 4;

    public TreeSweeps(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>
    /// The trees, then the rows. Where rows pushed at limits, which then are to be held or let go, both once more: a contact that opens
    /// a limit would have a whole substep for it otherwise.
    /// </summary>
    public void RunPass(TargetKind kind, SweepKind pass, bool again, int sweeps)
    {
        _solver.Limits.SolveTrees(kind, again);
        bool kept = _solver.Limits.KeepBeforeRows();
        Sweep(pass, sweeps);
        if (_work.AgendaCount > 0 && _solver.Limits.SolveTrees(kind, true))
        {
            Sweep(pass, some: true);
            if (kept)
            {
                _solver.Limits.AskAgainWithoutLimits(kind, pass, sweeps);
            }
        }

        _solver.Bodies.StoreVelocities();
    }

    /// <summary>
    /// Sweeps over all iterated rows, in the order of the trees. Several are one walk: the bodies between the rows wait for their
    /// velocities until the last of them.
    /// </summary>
    /// <param name="pass">What the rows do.</param>
    /// <param name="sweeps">How often; friction waits for the second half.</param>
    /// <param name="some">Only in the groups of trees that are marked: what others do is no concern of a tree that no row ties to
    /// them.</param>
    public void Sweep(SweepKind pass, int sweeps = 1, bool some = false)
    {
        if (_work.AgendaCount == 0)
        {
            return;
        }

        JointForestView view = _forest.View;
        bool chains = _chains.AnyPressed && (pass <= SweepKind.RelaxedSmooth || pass == SweepKind.Correction);
        if (chains)
        {
            _chains.Pressed.BeginWalks(some);
        }

        Walk(_trees, _work.TreeCount, _agenda, _work.AgendaCount, pass, sweeps, some);
        if (chains)
        {
            _chains.Pressed.EndWalks(some, pass == SweepKind.Correction);
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            if (tree->HasRows && TakesPart(tree, some) && tree->Carries)
            {
                if (pass < SweepKind.PushOut)
                {
                    TreeReactions.EndWalk(_forest, tree, _active.Pointer, _rows.Pointer);
                }
                else
                {
                    TreeWalk.End(view, tree);
                }
            }
        }
    }

    /// <summary>Begins a walk of trees and sweeps over their rows.</summary>
    public void Walk(Column<int> trees, int treeCount, Column<int> agenda, int agendaCount, SweepKind pass, int sweeps, bool some)
    {
        JointForestView view = _forest.View;
        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            if (tree->HasRows && TakesPart(tree, some))
            {
                TreeWalk.Begin(view, tree);
            }
        }

        for (int i = 0; i < agendaCount; i++)
        {
            JointTree* group = _solver.Contacts.GroupAt(agenda[i]);
            group->Change = 0;
            group->LargestChange = 0;
            group->Goes = true;
            group->Residual = 0;
            group->ResidualBefore = 0;
        }

        bool blows = pass is SweepKind.Biased or SweepKind.Relaxed;
        for (int sweep = 0; sweep < sweeps || (blows && sweep < MostSweeps && AnyGoes(agenda, agendaCount)); sweep++)
        {
            if (pass == SweepKind.Relaxed && sweep > 0 && sweep < MostSweeps - PlainSweeps)
            {
                GoOn(trees, treeCount, agenda, agendaCount, sweep == 1);
            }

            SweepOnce(agenda, agendaCount, pass == SweepKind.Relaxed && sweep * 2 < sweeps - 1 ? SweepKind.RelaxedSmooth : pass, some);
        }
    }

    /// <summary>Which groups of trees are swept over once more.</summary>
    private bool AnyGoes(Column<int> agenda, int agendaCount)
    {
        bool any = false;
        for (int i = 0; i < agendaCount; i++)
        {
            JointTree* group = _solver.Contacts.GroupAt(agenda[i]);
            group->LargestChange = Math.Max(group->LargestChange, group->Change);
            group->Goes = group->Change > Math.Max(_contactPass.Fall, SettledShare * group->LargestChange);
            any |= group->Goes;
        }

        for (int i = 0; i < agendaCount && any; i++)
        {
            _solver.Contacts.GroupAt(agenda[i])->Change = 0;
        }

        return any;
    }

    /// <summary>
    /// Between sweeps the normal impulses go on in the conjugate direction p: with d what the last sweep changed, β = d²/d² of the sweep
    /// before, λ += β p and p = β p + d, or from anew where β &gt; 1 (Silcowitz, Niebel, Erleben: nonsmooth nonlinear conjugate gradients,
    /// 2010). Of ten rings of 24 that fell in a pit links were 15 mm in each other with plain sweeps, and 2.4 mm with these. Not in the
    /// biased pass, nor for what is pulled: impulses that contradict each other would gather the faster.
    /// </summary>
    private void GoOn(Column<int> trees, int treeCount, Column<int> agenda, int agendaCount, bool begins)
    {
        for (int i = 0; i < agendaCount; i++)
        {
            JointTree* group = _solver.Contacts.GroupAt(agenda[i]);
            if (agenda[i] < 0 && group->Goes)
            {
                TreeContact* contact = _contacts.Pointer + ~agenda[i];
                if (begins)
                {
                    TreeContactPass.BeginDirection(contact);
                }

                group->Residual += TreeContactPass.Residual(contact);
            }
        }

        for (int i = 0; i < agendaCount; i++)
        {
            JointTree* group = _solver.Contacts.GroupAt(agenda[i]);
            if (agenda[i] < 0 && group->Goes && !IsPulled(agenda[i]))
            {
                double share = group->Residual < group->ResidualBefore ? group->Residual / group->ResidualBefore : 0;
                _contactPass.GoOn(_contacts.Pointer + ~agenda[i], share);
            }
        }

        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            tree->ResidualBefore = tree->Residual;
            tree->Residual = 0;
        }
    }

    private void SweepOnce(Column<int> agenda, int agendaCount, SweepKind pass, bool some)
    {
        for (int i = 0; i < agendaCount; i++)
        {
            int item = agenda[i];
            JointTree* group = _solver.Contacts.GroupAt(item);
            if ((some && !group->GroupActs) || !group->Goes)
            {
                continue;
            }

            if (_work.AnyWishes
                && pass <= SweepKind.RelaxedSmooth
                && (group->Wishes && _solver.Wishes.IsWish(item)) != _work.Wishing)
            {
                continue;
            }

            if (item < 0)
            {
                _contactPass.Changed = 0;
                Solve(_contacts.Pointer + ~item, pass);
                group->Change = Math.Max(group->Change, pass == SweepKind.Biased && IsPulled(item) ? 0 : _contactPass.Changed);
            }
            else
            {
                if (_active[item].LeadsLoops)
                {
                    _loops.Sweep(_forest.Trees + _forest.TreeOf(_active[item].Ends));
                }

                Solve(_active.Pointer + item, _rows.Pointer + item, pass);
            }
        }
    }

    /// <summary>
    /// A joint or a limit pulls a body of the contact back into its place. Where that is in another body the two contradict each other in
    /// the biased pass, and each sweep would gather more of what both push with: a pair of which one was put beneath a floor was thrown at
    /// 7 m/s, and surfaces between which a limit squeezed them gave their bodies a hundred times their momentum.
    /// </summary>
    public bool IsPulled(int item) => IsPulledBack(_contacts[~item].Ends.NodeA) || IsPulledBack(_contacts[~item].Ends.NodeB);

    private bool IsPulledBack(int node)
    {
        if (node < 0)
        {
            return false;
        }

        JointTree* tree = _forest.Trees + _forest.Nodes[node].Tree;
        return tree->Disturbed || tree->Overrun;
    }

    private bool TakesPart(JointTree* tree, bool some) => !some || _forest.Trees[tree->Group].GroupActs;

    public void ClearGroups()
    {
        for (int at = 0; at < _work.TreeCount; at++)
        {
            _forest.Trees[_trees[at]].GroupActs = false;
        }

        _chains.Pressed.ClearGroups();
    }

    public ref RowEnds EndsOf(int item) => ref item < 0 ? ref _contacts[~item].Ends : ref _active[item].Ends;

    public void Solve(TreeContact* contact, SweepKind pass)
    {
        if (contact->Held && pass != SweepKind.Impact)
        {
            return;
        }

        switch (pass)
        {
            case SweepKind.Biased:
                _contactPass.SolveBiased(contact);
                break;
            case SweepKind.Relaxed:
            case SweepKind.RelaxedSmooth:
                _contactPass.Relax(contact, pass == SweepKind.Relaxed);
                break;
            case SweepKind.Impact:
                _contactPass.Strike(contact);
                break;
            case SweepKind.Correction:
                _contactPass.Hold(contact);
                break;
            case SweepKind.PushOut:
                _contactPass.PushOut(contact, _work.PushRate);
                break;
            case SweepKind.Pull:
                _contactPass.Block(contact);
                break;
        }
    }

    public void Solve(ActiveJoint* joint, JointRows* rows, SweepKind pass)
    {
        switch (pass)
        {
            case SweepKind.Biased:
            case SweepKind.Relaxed:
            case SweepKind.RelaxedSmooth:
            case SweepKind.Settle:
                _pass.Solve(joint, rows, _work.Step, pass == SweepKind.Biased);
                break;
            case SweepKind.Correction:
                _pass.HoldPoint(joint, rows);
                break;
            case SweepKind.Pull:
                _pass.Pull(joint, rows, _work.Step);
                break;
        }
    }

    public void FactorAll()
    {
        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            _solver.Responses.Factor(tree);
            if (tree->HasRows)
            {
                TreeFactor.CompleteMasses(_forest, tree);
            }

            tree->Refactored = false;
        }

        _solver.Lanes.PrepareFrom(0);
    }

    public void Prepare(int item)
    {
        if (item < 0)
        {
            _contactPass.Prepare(_contacts.Pointer + ~item);
        }
        else
        {
            _pass.Prepare(_active.Pointer + item, _rows.Pointer + item, _work.Step.Substep);
        }
    }
}
