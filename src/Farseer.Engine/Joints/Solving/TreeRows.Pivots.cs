using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints.Solving;

/// <content>
/// Rigid pivots, with limits of their angles or without. Most joints are such, and all is asked of them several times a substep: written
/// out it is a third of the work, and the same to the last bit.
/// </content>
internal sealed unsafe partial class TreeRows
{
    public const int LowerRow = 2;

    public const int UpperRow = 3;

    /// <summary>
    /// A limit that a substep brings nearer by less than this share of its distance is not passed, whatever rounding does.
    /// </summary>
    private const double OutOfReach = 0.5;

    /// <summary>Of the rows of a rigid pivot only arms and errors change.</summary>
    /// <param name="joint">The joint.</param>
    /// <param name="rows">Its rows.</param>
    /// <param name="armed">Its errors have been written at these poses.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void RewritePivot(ActiveJoint* joint, JointRows* rows, bool armed)
    {
        if (!armed)
        {
            ReadFrame(joint, out JointFrame f);
            WritePivotErrors(joint, rows, f);
        }

        rows->A[2] = joint->ArmA[1];
        rows->A[5] = -joint->ArmA[0];
        rows->B[2] = -joint->ArmB[1];
        rows->B[5] = joint->ArmB[0];
        rows->ArmX = joint->ArmB[0];
        rows->ArmY = joint->ArmB[1];
        rows->JointError = Math.Sqrt((rows->Error[0] * rows->Error[0]) + (rows->Error[1] * rows->Error[1]));
        if (_work.Step.Drifts)
        {
            JointRows.ForgetErrors(rows);
        }
    }

    /// <summary>The errors, and for when the rows are written the arms: until then these keep their directions.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void WritePivotErrors(ActiveJoint* joint, JointRows* rows, in JointFrame f)
    {
        joint->ArmA[0] = f.RAX;
        joint->ArmA[1] = f.RAY;
        joint->ArmB[0] = f.RBX;
        joint->ArmB[1] = f.RBY;
        rows->Error[0] = f.DX;
        rows->Error[1] = f.DY;
        if (joint->Pivot == PivotKind.Limited)
        {
            double angle = f.BAngle - f.AAngle - joint->Settings.Target;
            rows->Error[LowerRow] = angle - joint->Settings.Lower - joint->Outside[LowerRow];
            rows->Error[UpperRow] = joint->Settings.Upper - angle - joint->Outside[UpperRow];
        }
    }

    /// <summary>The targets of the rows of an edge that is a pivot, as <see cref="Target"/> finds them.</summary>
    /// <returns>The first row that is not written.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int WritePivotTargets(TreeNode* node, TargetKind kind, JointTree* tree)
    {
        ActiveJoint* joint = _active.Pointer + node->RowJoint[0];
        if (node->HardRows < JointRows.OfPoint || joint->Pivot == PivotKind.None || kind == TargetKind.Pull)
        {
            return 0;
        }

        if (kind == TargetKind.Relaxed || (kind == TargetKind.Correction && tree->Disturbed))
        {
            node->Target[0] = 0;
            node->Target[1] = 0;
            return JointRows.OfPoint;
        }

        JointRows* rows = _rows.Pointer + node->RowJoint[0];
        node->Target[0] = PointTarget(joint, rows, 0, kind, tree);
        node->Target[1] = PointTarget(joint, rows, 1, kind, tree);
        return JointRows.OfPoint;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private double PointTarget(ActiveJoint* joint, JointRows* rows, int r, TargetKind kind, JointTree* tree)
    {
        double error = rows->Error[r];
        double share = Math.Abs(error) / rows->Size;
        tree->Worst = Math.Max(tree->Worst, rows->Size > 0 ? share : 0);
        if (kind != TargetKind.Biased)
        {
            return -error / _work.Step.Substep;
        }

        tree->Disturbed |= tree->IsOutside(share);
        double speed = -(error / _work.Step.Substep);
        return tree->Disturbed ? 0 : tree->HasRows ? speed - (joint->Foreseen[r] * _work.Step.Substep) : speed;
    }

    /// <summary>As <see cref="TreeLimits.IsPassed"/> of both limits of a pivot's angle.</summary>
    /// <returns>The row of the one that is passed, -1: none.</returns>
    public int FindTurnedPast(ActiveJoint* joint, JointRows* rows, TargetKind kind)
    {
        double a = SpinOf(joint->Ends.NodeA, joint->Ends.BodyA);
        double b = SpinOf(joint->Ends.NodeB, joint->Ends.BodyB);
        double rounding = TreeLimits.SpeedRounding * (Math.Abs(a) + Math.Abs(b));
        return IsTurnedPast(joint, rows, LowerRow, b - a, rounding, kind) ? LowerRow
            : IsTurnedPast(joint, rows, UpperRow, a - b, rounding, kind) ? UpperRow : -1;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool IsTurnedPast(ActiveJoint* joint, JointRows* rows, int row, double speed, double rounding, TargetKind kind)
    {
        if (TreeLimits.IsJustLetGo(joint, row))
        {
            return false;
        }

        double gap = rows->Error[row];
        if (gap > 0 && !IsDisplacement(kind) && speed * _work.Step.Substep > -OutOfReach * gap)
        {
            joint->Goal[row] = 0;
            return false;
        }

        return speed < _solver.Limits.LimitTarget(joint, rows, row, kind) - rounding;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private double SpinOf(int node, int body) =>
        node >= 0 ? _forest.Nodes[node].Velocity[2] : _work.Step.Bodies.State[body].AngularVelocity;
}
