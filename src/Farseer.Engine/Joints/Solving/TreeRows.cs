using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>What hard rows are to reach.</summary>
internal enum TargetKind
{
    /// <summary>The velocities that take the errors away within the substep.</summary>
    Biased,

    /// <summary>The velocity changes that take away what is left of them.</summary>
    Correction,

    /// <summary>The same, whatever their size, in trees that went astray.</summary>
    Projection,

    /// <summary>Standstill.</summary>
    Relaxed,

    /// <summary>The displacements, as velocities, that take away errors put there from outside at the rate of the bias factor.</summary>
    Pull,
}

/// <summary>Rows and targets.</summary>
[NotState(Why.Fixed)]
internal sealed unsafe partial class TreeRows : JointPart
{
    public const double Small = 0.02;

    public TreeRows(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>The rows at the present poses; servo and motor keep the speeds and bounds of the step's start.</summary>
    public void WriteRows(bool begin)
    {
        int armed = begin || !_work.Posed || _work.Step.Drifts ? 0 : _work.Armed;
        for (int at = 0; at < _work.JointCount; at++)
        {
            if (begin)
            {
                WriteJoint(_joints[at]);
            }
            else
            {
                Rewrite(_joints[at], at < armed);
            }
        }
    }

    /// <summary>The rows of a joint at the present poses, with the speeds and bounds of the step's start.</summary>
    public void Rewrite(int index, bool armed = false)
    {
        JointRows* rows = _rows.Pointer + index;
        if (_active[index].Pivot != PivotKind.None)
        {
            RewritePivot(_active.Pointer + index, rows, armed);
            return;
        }

        double* speeds = stackalloc double[JointRows.Most];
        double* lows = stackalloc double[JointRows.Most];
        double* highs = stackalloc double[JointRows.Most];
        int before = rows->Count;
        TreePositions.Copy(rows->Speed, speeds, before);
        TreePositions.Copy(rows->Low, lows, before);
        TreePositions.Copy(rows->High, highs, before);
        WriteJoint(index);
        TreePositions.Copy(speeds, rows->Speed, before);
        TreePositions.Copy(lows, rows->Low, before);
        TreePositions.Copy(highs, rows->High, before);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void ReadFrame(ActiveJoint* joint, out JointFrame frame)
    {
        frame = default;
        frame.PullTime = _work.Step.PullTime;
        frame.H = _work.Step.Substep;
        ReadPose(joint->Ends.NodeA, joint->Ends.BodyA, out frame.AX, out frame.AY, out frame.AAngle, out frame.ACos, out frame.ASin);
        ReadPose(joint->Ends.NodeB, joint->Ends.BodyB, out frame.BX, out frame.BY, out frame.BAngle, out frame.BCos, out frame.BSin);
        frame.SetAnchors(joint->Settings);
    }

    public void WriteErrors()
    {
        // The directions stay those of the substep's start until the correction is done, or it would not be symplectic.
        JointRows fresh = default;
        fresh.ErrorsOnly = true;
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            JointRows* rows = _rows.Pointer + i;
            if (_active[i].Pivot != PivotKind.None)
            {
                ReadFrame(_active.Pointer + i, out JointFrame frame);
                WritePivotErrors(_active.Pointer + i, rows, frame);
            }
            else
            {
                fresh.Count = 0;
                fresh.Hard = 0;
                WriteInto(i, ref fresh);
                for (int k = 0; k < rows->Count; k++)
                {
                    rows->Error[k] = fresh.Error[k];
                }
            }

            if (_work.Step.Drifts)
            {
                JointRows.ForgetErrors(rows);
            }
        }

        _work.Armed = _work.JointCount;
    }

    public void WriteJoint(int index)
    {
        ref JointRows rows = ref _rows[index];
        rows.Count = 0;
        rows.Hard = 0;
        WriteInto(index, ref rows);
        if (_work.Step.Drifts)
        {
            JointRows.ForgetErrors(_rows.Pointer + index);
        }
    }

    /// <summary>Not made part of its callers, in which the budget for inlining runs out before the rows are written.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void WriteInto(int index, ref JointRows rows)
    {
        ref ActiveJoint joint = ref _active[index];
        ref JointSettings settings = ref joint.Settings;
        ReadFrame(_active.Pointer + index, out JointFrame frame);
        if (!rows.ErrorsOnly)
        {
            rows.SoftPoint = false;
            rows.Bias = settings.BiasFactor;
            rows.ArmX = frame.RBX;
            rows.ArmY = frame.RBY;
            rows.Size = Math.Sqrt((frame.RAX * frame.RAX) + (frame.RAY * frame.RAY))
                + Math.Sqrt((frame.RBX * frame.RBX) + (frame.RBY * frame.RBY));
        }

        _kinds.Of(joint.Kind).Write(frame, settings, joint.Flags, ref rows);
        for (int k = rows.Hard; k < rows.Count && joint.Overrun; k++)
        {
            rows.Error[k] -= joint.Outside[k];
        }
    }

    /// <summary>
    /// How far the hard rows would be off if the bodies went on as they move now, at the end of a step, for a whole one. An exact
    /// joint has no error to break by; an iterated one, which takes the share β of its error away in a step, has this much over β,
    /// and so games choose their breaking points by it.
    /// </summary>
    /// <remarks>
    /// A compliant row has some of it already. With D = n·σ for n substeps and the response K a substep gives, besides h·a, only
    /// the share D/(K + D) of the turning c = v²h/L before it moves: the relax pass gives the rest after. So it is c·h/2 off as all
    /// that goes straight, less c·h·D/(K + D): in n substeps (K - D)/(K + D)/n of what a whole step is.
    /// </remarks>
    public double StraightDrift(int index)
    {
        ref ActiveJoint joint = ref _active[index];
        JointRows* now = _rows.Pointer + index;
        JointRows then = default;
        JointFrame frame = default;
        frame.PullTime = _work.Step.PullTime;
        frame.H = _work.Step.Substep;
        BodyState* a = _work.Step.Bodies.State.Pointer + joint.Ends.BodyA;
        BodyState* b = _work.Step.Bodies.State.Pointer + joint.Ends.BodyB;
        ReadPose(joint.Ends.NodeA, joint.Ends.BodyA, out frame.AX, out frame.AY, out frame.AAngle, out frame.ACos, out frame.ASin);
        ReadPose(joint.Ends.NodeB, joint.Ends.BodyB, out frame.BX, out frame.BY, out frame.BAngle, out frame.BCos, out frame.BSin);
        frame.AX += a->LinearVelocity.X * _work.Step.Dt;
        frame.AY += a->LinearVelocity.Y * _work.Step.Dt;
        frame.AAngle += a->AngularVelocity * _work.Step.Dt;
        StableMath.SinCos(frame.AAngle, out frame.ASin, out frame.ACos);
        frame.BX += b->LinearVelocity.X * _work.Step.Dt;
        frame.BY += b->LinearVelocity.Y * _work.Step.Dt;
        frame.BAngle += b->AngularVelocity * _work.Step.Dt;
        StableMath.SinCos(frame.BAngle, out frame.BSin, out frame.BCos);
        frame.SetAnchors(joint.Settings);
        _kinds.Of(joint.Kind).Write(frame, joint.Settings, joint.Flags, ref then);
        double sum = 0;
        for (int k = 0; k < now->Count; k++)
        {
            if (now->Type[k] == (byte)RowType.Hard || (now->Type[k] == (byte)RowType.Motor && now->Damping[k] > 0))
            {
                double* ja = now->A + (k * 3);
                double* jb = now->B + (k * 3);
                double speed = (ja[0] * a->LinearVelocity.X) + (ja[1] * a->LinearVelocity.Y) + (ja[2] * a->AngularVelocity)
                    + (jb[0] * b->LinearVelocity.X) + (jb[1] * b->LinearVelocity.Y) + (jb[2] * b->AngularVelocity);
                double drift = then.Error[k] - now->Error[k] - (speed * _work.Step.Dt);
                double response = now->Type[k] == (byte)RowType.Hard ? 0 : joint.Response[k];
                drift *= response > 0
                    ? 1 - ((response - now->Damping[k]) / (response + now->Damping[k]) * _work.Step.Substep / _work.Step.Dt)
                    : 1;
                sum += drift * drift;
            }
        }

        return Math.Sqrt(sum);
    }

    private void ReadPose(int node, int body, out double x, out double y, out double angle, out double cos, out double sin)
    {
        if (node >= 0)
        {
            TreeNode* n = _forest.Nodes + node;
            x = n->X;
            y = n->Y;
            angle = n->Angle;
            cos = n->Cos;
            sin = n->Sin;
            return;
        }

        angle = TreesOnLanes.ReadStill(_work.Step.Bodies, body, out x, out y);
        StableMath.SinCos(angle, out sin, out cos);
    }

    /// <summary>Writes what the rows of a tree's blocks are to reach, and finds the tree's largest error.</summary>
    public void SetTargets(JointTree* tree, TargetKind kind)
    {
        if (kind == TargetKind.Biased)
        {
            tree->Unsettled = tree->Disturbed;
            tree->Disturbed = false;
        }

        WriteTargets(tree, kind);
        if (kind == TargetKind.Biased && tree->Disturbed)
        {
            // The rows before the one that was found to be off.
            WriteTargets(tree, kind);
        }
    }

    private void WriteTargets(JointTree* tree, TargetKind kind)
    {
        tree->Worst = 0;
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            for (int r = WritePivotTargets(node, kind, tree); r < node->Rows; r++)
            {
                int joint = node->RowJoint[r];
                node->Target[r] = Target(_active.Pointer + joint, _rows.Pointer + joint, node->RowIndex[r], kind, tree);
            }
        }

        for (int row = tree->LoopRow; row < tree->LoopRowEnd; row++)
        {
            int joint = _loops.JointOf(row);
            _loops.TargetOf(row) = Target(_active.Pointer + joint, _rows.Pointer + joint, _loops.IndexOf(row), kind, tree);
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = _forest.Anchors + i;
            JointRows* rows = _rows.Pointer + anchor->Active;
            ActiveJoint* joint = _active.Pointer + anchor->Active;
            bool movesA = joint->Ends.NodeA == anchor->Node;
            BodyState* still = _work.Step.Bodies.State.Pointer + (movesA ? joint->Ends.BodyB : joint->Ends.BodyA);
            for (int r = 0; r < anchor->Rows; r++)
            {
                int row = anchor->RowIndex[r];
                double target = Target(joint, rows, row, kind, tree);
                if (!IsDisplacement(kind))
                {
                    // What cannot be moved may yet be moving: a kinematic body.
                    double* j = (movesA ? rows->B : rows->A) + (row * 3);
                    target -= (j[0] * still->LinearVelocity.X) + (j[1] * still->LinearVelocity.Y) + (j[2] * still->AngularVelocity);
                }

                anchor->Target[r] = target;
            }
        }
    }

    public static bool IsDisplacement(TargetKind kind) =>
        kind == TargetKind.Correction || kind == TargetKind.Projection || kind == TargetKind.Pull;

    /// <summary>
    /// An error up to the share <see cref="Small"/> of the joint's size comes from the motion and is taken out at once. What is
    /// beyond it was put there from outside (a body moved by hand or exchanged, another length) and goes at the rate of the bias factor,
    /// by displacements alone, and so do all errors of its tree until none is left: the last 2 % as speeds, six sizes a second and more,
    /// threw bodies off that had been pulled together from afar.
    /// </summary>
    private double Target(ActiveJoint* joint, JointRows* rows, int r, TargetKind kind, JointTree* tree)
    {
        if (r >= rows->Hard)
        {
            // A limit that holds leaves its place by the bend of its bodies' ways, as a hard row does.
            double way = _solver.Limits.LimitTarget(joint, rows, r, kind);
            if (!tree->Disturbed && IsDisplacement(kind))
            {
                double span = rows->SizeOf(r);
                tree->Worst = Math.Max(tree->Worst, span > 0 ? Math.Abs(way) * _work.Step.Substep / span : 0);
            }

            return way;
        }

        bool positions = IsDisplacement(kind);
        if (rows->Type[r] == (byte)RowType.Servo || kind == TargetKind.Relaxed)
        {
            return positions ? 0 : rows->Speed[r];
        }

        if (kind == TargetKind.Correction && tree->Disturbed)
        {
            return 0;
        }

        double error = rows->Error[r];
        double size = rows->SizeOf(r);
        double magnitude = Math.Abs(error);
        tree->Worst = Math.Max(tree->Worst, size > 0 ? magnitude / size : 0);
        if (kind == TargetKind.Pull)
        {
            return -PullSpeed(rows, r, _work.Step);
        }

        if (kind == TargetKind.Biased)
        {
            tree->Disturbed |= tree->IsOutside(magnitude / size);
            if (tree->Disturbed)
            {
                return 0;
            }

            if (tree->HasRows)
            {
                return -(error / _work.Step.Substep) - (joint->Foreseen[r] * _work.Step.Substep);
            }
        }

        return -error / _work.Step.Substep;
    }

    /// <summary>A displacement as a speed: a small error at once, what is beyond at the rate of the bias factor.</summary>
    public static double PullSpeed(JointRows* rows, int r, in JointStep step) => PullSpeed(rows->Error[r], rows, r, step);

    /// <summary>The same of another error than the row has.</summary>
    public static double PullSpeed(double error, JointRows* rows, int r, in JointStep step)
    {
        double magnitude = Math.Abs(error);
        double small = Math.Min(magnitude, Small * rows->SizeOf(r));
        double rest = (magnitude - small) * Math.Min(1, rows->Bias * step.Substep / step.PullTime);
        return (error < 0 ? -1 : 1) * (small + rest) / step.Substep;
    }
}
