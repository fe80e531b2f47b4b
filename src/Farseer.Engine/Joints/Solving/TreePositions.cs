using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>
/// The correction of positions. It goes along the directions of the substep's start, which makes the motion symplectic; where that
/// does not converge (the whip of a rope), the tree is projected along the directions at its present pose instead, which always
/// holds together but costs energy. Loops and surfaces that press on each other take part: without them the correction undoes
/// what they had found, and a load sinks four times as deep.
/// </summary>
[NotState(Why.Fixed)]
internal sealed unsafe partial class TreePositions : JointPart
{
    /// <summary>
    /// Rounds of the correction at most. A whip turns its links by so much in a substep that each round leaves half of the error: four
    /// left joints open by up to 1e-4 of their size.
    /// </summary>
    private const int Corrections = 12;

    /// <summary>
    /// Rounds in which a tree goes on down to <see cref="Tolerance"/>; one that is still open by more than <see cref="Failed"/> after them
    /// went astray. Corrections go along the substep's first directions: of a large error twelve rounds make a speed, and three links
    /// between two free bodies had twice their energy. Those with rows end here: which surfaces press and which limits hold is asked
    /// again after the rounds, and more of them would follow what may no longer be so.
    /// </summary>
    private const int UsualCorrections = 4;

    /// <summary>Sweeps over loops and contacts in a correction.</summary>
    public const int CorrectionSweeps = 2;

    /// <summary>Errors in terms of the joint's size: none, good enough to stay with, and too large after all corrections.</summary>
    public const double Tolerance = 1e-8;

    public const double Loose = 2e-6;

    /// <summary>
    /// None of a tree that contacts press on. What is left is met by the next biased pass and does not add up; the energy that a correction
    /// would keep is nothing beside what contacts take, and most substeps of a bridge under its load need none.
    /// </summary>
    private const double PressedTolerance = 3e-7;

    public const double Failed = 1e-4;

    /// <summary>A correction that does not shrink the error to this share goes astray; so does one that turns a body further.</summary>
    public const double Shrink = 0.7;

    public const double LargestBend = 0.3;

    /// <summary>Change of a joint's bend from one substep to the next up to which it is carried on.</summary>
    internal const double Alike = 0.25;

    /// <summary>
    /// The same for chains that are solved as such, of which none is taut: a bridge under its load takes half as many corrections as with a
    /// quarter. Bends that alternate change by twice their size, and are not carried on by any share below that.
    /// </summary>
    internal const double AlikeInChains = 0.5;

    public TreePositions(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>After the positions moved: what is left of the errors is taken out of positions and velocities alike.</summary>
    /// <param name="pushRate">Share of a deep overlap that goes in this substep.</param>
    public void CorrectPositions(double pushRate)
    {
        _solver.Bodies.LoadVelocities();
        Move(pushRate > 0);
        _solver.Bodies.LoadPoses();
        _solver.Rows.WriteErrors();
        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            _solver.Rows.SetTargets(tree, TargetKind.Correction);
            tree->Before = double.PositiveInfinity;
            tree->Astray = false;
        }

        NoteBends();
        _chains.Pressed.Move();

        for (int round = 0; ChooseTrees(round); round++)
        {
            Correct(round == 0);
            _solver.Bodies.LoadPoses();
            _solver.Rows.WriteErrors();
            FindAstray(round);
            _solver.Chains.LeaveAstray(round);
        }

        _solver.Lanes.CorrectLanes(pushRate > 0);
        Displace(_solver.Projection.ProjectTrees(), pushRate);
    }

    /// <summary>The bodies stand where they stay in this substep.</summary>
    public void EndPositions()
    {
        _solver.Chains.EndPressed();
        if (!_work.Posed)
        {
            _solver.Bodies.LoadPoses();
        }

        _solver.Rows.WriteRows(false);
        _solver.Overruns.EaseOverruns();
        _solver.Limits.LetGoOfOpenLimits();
        _solver.Sweeps.FactorAll();
        _solver.Lanes.PrepareOnLanes(false);
        if (_loose.Any)
        {
            _loose.EndPositions();
        }

        _solver.Bodies.Kick(0.5f);
        Resume();
        _nets.Moved();
    }

    /// <summary>Motors and limits of free trees go on.</summary>
    private void Resume()
    {
        for (int i = 0; i < _work.AgendaCount; i++)
        {
            int item = _agenda[i];
            if (item >= 0)
            {
                _pass.Resume(_active.Pointer + item, _rows.Pointer + item);
            }
        }

        for (int at = 0; at < _work.NodeCount && _work.AgendaCount > 0; at++)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            if (_forest.Trees[node->Tree].Free)
            {
                TreeBodies.StoreVelocity(node->Velocity, _work.Step.Bodies.State.Pointer + node->Body);
            }
        }
    }

    private static void NotePlain(TreeNode* node)
    {
        for (int k = 0; k < 3; k++)
        {
            node->PlainMove[k] = node->Move[k];
            node->PlainVelocity[k] = node->Velocity[k];
        }

        node->Bent = 0;
    }

    /// <summary>Exact trees move by h·v in double; the others have been moved.</summary>
    /// <param name="pushed">The store has also moved bodies by velocities that push them apart.</param>
    private void Move(bool pushed)
    {
        double h = _work.Step.Substep;
        _solver.Bodies.ClearMoves();
        for (int at = 0; at < _work.NodeCount; at++)
        {
            int i = _nodes[at];
            TreeNode* node = _forest.Nodes + i;
            if (_forest.Trees[node->Tree].Exact)
            {
                double* v = node->Velocity;
                if (pushed && _solver.Wishes.IsPushed(node))
                {
                    LoosePush push = LoosePush.Of(_work.Step, node->Body, node->Move);
                    double x = node->Move[0] + ((h * v[0]) + push.X);
                    double y = node->Move[1] + ((h * v[1]) + push.Y);
                    _solver.Bodies.NoteMove(i, x, y, node->Move[2] + ((h * v[2]) + push.Turn));
                    NotePlain(node);
                    continue;
                }

                double turned = pushed && _forest.Trees[node->Tree].Wheel ? _solver.Contacts.TurnOf(node) : node->Move[2] + (h * v[2]);
                _solver.Bodies.NoteMove(i, node->Move[0] + (h * v[0]), node->Move[1] + (h * v[1]), turned);
            }
            else
            {
                _solver.Bodies.LoadMove(node);
            }

            NotePlain(node);
        }

        _solver.Bodies.StoreMoves();

        for (int i = 0; i < _work.ContactCount; i++)
        {
            _contacts[i].Point0.Plain = _contacts[i].Point0.Normal;
            _contacts[i].Point1.Plain = _contacts[i].Point1.Normal;
        }

        for (int at = 0; at < _work.JointCount; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            Copy(joint->Lambda, joint->PlainLambda, JointRows.Most);
            Copy(joint->Given, joint->PlainGiven, 3);
        }
    }

    /// <summary>
    /// A straight way leaves a joint by half of its acceleration times h², which changes little from one substep to the next. Known
    /// beforehand it is a part of what the biased pass meets, and the correction, whose rounds and sweeps are half of the cost of a tree
    /// with rows, has little to do. The directions are the same, so what is found in the end is too.
    /// </summary>
    private void NoteBends()
    {
        double h = _work.Step.Substep;
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            ActiveJoint* joint = _active.Pointer + i;
            JointTree* tree = _forest.Trees + _forest.TreeOf(joint->Ends);
            if (!tree->HasRows || joint->Role == JointRole.Iterated)
            {
                continue;
            }

            if (tree->Disturbed)
            {
                ForgetBends(joint);
                continue;
            }

            Foresee(joint, _rows.Pointer + i, h);
        }
    }

    /// <summary>The next bend, if the last two are like each other: after a blow nothing is foreseen.</summary>
    private static void Foresee(ActiveJoint* joint, JointRows* rows, double h)
    {
        double* change = stackalloc double[TreeFactor.MostRows];
        double largest = 0;
        double largestChange = 0;
        for (int r = 0; r < rows->Hard; r++)
        {
            double bend = (rows->Error[r] / (h * h)) + joint->Foreseen[r];
            change[r] = bend - joint->Bend[r];
            joint->Bend[r] = bend;
            double size = rows->SizeOf(r);
            double share = size > 0 ? 1 / size : 0;
            largest = Math.Max(largest, share * Math.Abs(bend));
            largestChange = Math.Max(largestChange, share * Math.Abs(change[r]));
        }

        bool alike = largestChange <= Alike * largest;
        for (int r = 0; r < rows->Hard; r++)
        {
            joint->Foreseen[r] = alike ? joint->Bend[r] + change[r] : 0;
        }
    }

    public static void ForgetBends(ActiveJoint* joint)
    {
        for (int r = 0; r < TreeFactor.MostRows; r++)
        {
            joint->Bend[r] = 0;
            joint->Foreseen[r] = 0;
        }
    }

    public static void Copy(double* from, double* to, int count)
    {
        for (int i = 0; i < count; i++)
        {
            to[i] = from[i];
        }
    }

    /// <summary>The error above which a tree takes part in a round; infinite in the one after its last, so that rounds end.</summary>
    /// <param name="round">From 0.</param>
    /// <param name="pressed">Contacts press on the tree.</param>
    /// <param name="rows">It has rows.</param>
    public static double ToleranceAt(int round, bool pressed, bool rows)
    {
        if (round >= (rows ? UsualCorrections : Corrections))
        {
            return double.PositiveInfinity;
        }

        return pressed || round >= UsualCorrections ? PressedTolerance : Tolerance;
    }

    /// <summary>A tree that is open by more than <see cref="Failed"/> after this round went astray.</summary>
    public static bool IsLate(int round) => round >= UsualCorrections - 1;

    /// <summary>A tree takes part if its error is too large, or that of another to which rows tie it.</summary>
    private bool ChooseTrees(int round)
    {
        _solver.Sweeps.ClearGroups();
        bool any = _chains.Pressed.Choose(round);
        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            tree->Corrects = tree->Eliminates && tree->Worst > ToleranceAt(round, tree->Pressed, tree->HasRows) && !tree->Astray;
            any |= tree->Corrects;
            _forest.Trees[tree->Group].GroupActs |= tree->Corrects && tree->HasRows;
        }

        for (int at = 0; any && at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->Corrects |= tree->HasRows && _forest.Trees[tree->Group].GroupActs;
        }

        return any;
    }

    /// <summary>One round: the velocity changes that take the errors away, found as the velocities are.</summary>
    public void Correct(bool first)
    {
        bool anyRows = _chains.Pressed.Correct(first);
        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            if (tree->Corrects || tree->HasRows)
            {
                _solver.Limits.Save(tree);
                Clear(tree);
            }

            if (tree->Corrects && tree->Eliminates)
            {
                // Its targets were written with its largest error.
                _loops.Solve(tree);
                TreeReactions.OfSolve(_forest, tree);
                _solver.Responses.Give(tree);
                anyRows |= tree->HasRows;
            }
        }

        if (anyRows)
        {
            _solver.Sweeps.Sweep(SweepKind.Correction, CorrectionSweeps, true);
        }

        double h = _work.Step.Substep;
        _solver.Bodies.ClearMoves();
        for (int at = 0; at < _work.NodeCount; at++)
        {
            int i = _nodes[at];
            TreeNode* node = _forest.Nodes + i;
            JointTree* tree = _forest.Trees + node->Tree;
            if (tree->Corrects || tree->HasRows)
            {
                double* change = node->Velocity;
                if (tree->Corrects)
                {
                    node->Bent += Math.Abs(h * change[2]);
                    _solver.Bodies.NoteMove(
                        i, node->Move[0] + (h * change[0]), node->Move[1] + (h * change[1]), node->Move[2] + (h * change[2]));
                }

                change[0] += node->Saved[0];
                change[1] += node->Saved[1];
                change[2] += node->Saved[2];
            }
        }

        _solver.Bodies.StoreMoves();
        _solver.Bodies.StoreVelocities();
    }

    public void Clear(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            node->Velocity[0] = 0;
            node->Velocity[1] = 0;
            node->Velocity[2] = 0;
        }
    }

    private void FindAstray(int round)
    {
        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            if (!tree->Corrects || !tree->Eliminates)
            {
                continue;
            }

            double bent = 0;
            for (int k = tree->First; k < tree->End; k++)
            {
                bent = Math.Max(bent, _forest.Nodes[k].Bent);
            }

            _solver.Rows.SetTargets(tree, TargetKind.Correction);
            tree->Astray |= TreesOnLanes.IsAstray(tree->Worst, tree->Before, bent, round);
            tree->Before = tree->Worst;
        }
    }
}
