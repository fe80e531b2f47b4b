using System;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>
/// Limits of joints that close the loops of a tree, rows of <see cref="TreeLoops"/> when they hold: what <see cref="TreeLimits"/> asks of
/// them, as of those of edges and anchors.
/// </summary>
[NotState(Why.Fixed)]
internal sealed unsafe class LoopLimits : JointPart
{
    public LoopLimits(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>A limit that holds would pull, or another is passed.</summary>
    public bool Turn(JointTree* tree, TargetKind kind)
    {
        for (int row = tree->FirstLoopLimit; row < tree->LoopRowEnd; row++)
        {
            if (_active[_loops.JointOf(row)].Lambda[_loops.IndexOf(row)] < 0)
            {
                return true;
            }
        }

        for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
        {
            if (FindPassed(tree, _loops.JointAt(at), kind) >= 0)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Lets go of limits that would pull.</summary>
    /// <returns>True if there were some.</returns>
    public bool Release(JointTree* tree)
    {
        bool changed = false;
        for (int row = tree->FirstLoopLimit, end = _loops.ReleaseAll(tree); row < end; row++)
        {
            int joint = _loops.JointOf(row);
            int index = _loops.IndexOf(row);
            if (_active[joint].Lambda[index] + _loops.LambdaOf(row) >= 0)
            {
                _loops.Keep(tree, row);
            }
            else
            {
                _solver.Limits.TakeBack(joint, index);
                changed = true;
            }
        }

        return changed;
    }

    /// <summary>Holds limits that are being passed.</summary>
    /// <returns>True if there were some.</returns>
    public bool Lock(JointTree* tree, TargetKind kind)
    {
        bool changed = false;
        for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
        {
            int joint = _loops.JointAt(at);
            for (int index = FindPassed(tree, joint, kind); index >= 0; index = FindPassed(tree, joint, kind))
            {
                _loops.Hold(tree, joint, index);
                changed = true;
            }
        }

        return changed;
    }

    /// <summary>Lets go of limits by their joint and row.</summary>
    /// <returns>True if there were some.</returns>
    public bool LetGoWhere(JointTree* tree, Func<int, int, bool> goes)
    {
        int held = tree->LoopRows;
        for (int row = tree->FirstLoopLimit, end = _loops.ReleaseAll(tree); row < end; row++)
        {
            if (!goes(_loops.JointOf(row), _loops.IndexOf(row)))
            {
                _loops.Keep(tree, row);
            }
        }

        return tree->LoopRows != held;
    }

    /// <summary>Whether any holds.</summary>
    /// <param name="tree">The tree.</param>
    /// <param name="open">Only limits that hold at the speed which closes their gap.</param>
    public bool AnyHolds(JointTree* tree, bool open)
    {
        for (int row = tree->FirstLoopLimit; row < tree->LoopRowEnd; row++)
        {
            if (!open || TreeLimits.IsOpen(_rows.Pointer + _loops.JointOf(row), _loops.IndexOf(row)))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>A limit of a joint that closes a loop which is passed and does not hold yet.</summary>
    /// <returns>Its row in the joint, -1: none.</returns>
    private int FindPassed(JointTree* tree, int joint, TargetKind kind)
    {
        JointRows* rows = _rows.Pointer + joint;
        for (int row = rows->Hard; row < rows->Count && _active[joint].BlockLimits; row++)
        {
            if (!_loops.Holds(tree, joint, row) && _solver.Limits.IsPassed(_active.Pointer + joint, rows, row, kind))
            {
                return row;
            }
        }

        return -1;
    }
}
