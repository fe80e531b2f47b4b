using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>
/// The iterated rows of joints: motors, springs, limits that no block holds, and the blocks of joints that close a loop. Each is
/// solved in turn against the full inverse mass of its bodies' trees.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe partial class JointPass
{
    /// <summary>The row of a target's spring across the way.</summary>
    private const int Across = 1;

    /// <summary>An impulse on a limit that changes the speed by less than this share is a tie, decided by rounding.</summary>
    public const double Touching = 1e-2;

    // Blocks of a net are soft, tied to the substep rate as contacts are: ωh = π/2, ζ = 2.
    private const double AngularStep = 1.5707963267948966;
    private const double NetDamping = 4 + AngularStep;
    public const double NetProduct = AngularStep * NetDamping;
    public const double NetBias = AngularStep / NetDamping;

    /// <summary>
    /// How many of its sizes, or how many radians, a joint of a net may close in a step. Errors from outside (joints switched on that had
    /// drifted apart) contradict each other: at the full rate their speeds were a thousand sizes a second, of which much stayed.
    /// </summary>
    public const double NetHurry = 0.3;

    private BodyState* _states;
    private JointForestView _view;

    /// <summary>The poses and trees of a substep: to be called before the other members.</summary>
    public void Enter(in JointForestView view, BodyState* states)
    {
        _view = view;
        _states = states;
    }

    /// <summary>Responses, springs and blocks of a joint at the present poses.</summary>
    public void Prepare(ActiveJoint* joint, JointRows* r, double h)
    {
        TreeNode* nodes = _view.Nodes;
        if (joint->Ends.Coupled)
        {
            TreeCross.Write(nodes, joint->Ends.NodeA, joint->Ends.NodeB, joint->Ends.Cross);
        }

        for (int k = 0; k < r->Count; k++)
        {
            joint->Response[k] = IsStalled(joint, r, k) ? 0 : RowEnds.Response(nodes, &joint->Ends, r->A + (k * 3), r->B + (k * 3));
            SetSpring(_view.Trees, nodes, joint, r, k, h);
        }

        if (r->SoftPoint)
        {
            joint->PointCoupling = Coupling(joint, r, 0, 1);
        }

        if (joint->Role == JointRole.Iterated && r->Hard > 0)
        {
            PrepareBlock(joint, r);
        }
    }

    /// <summary>
    /// The impulses of the substep before, on the bodies' own masses: the trees are solved afterwards. None where bodies are being
    /// displaced: a limit that three joints contradicted kept 1,600 N·s there, which displacements turned into 3·10⁸ J.
    /// </summary>
    public void WarmStart(ActiveJoint* joint, JointRows* r)
    {
        bool displaced = IsDisplaced(joint->Ends.NodeA) || IsDisplaced(joint->Ends.NodeB);
        double early = Early(joint);
        for (int k = joint->Role == JointRole.Iterated ? 0 : r->Hard; k < r->Count; k++)
        {
            if (IsInBlock(joint, r, k))
            {
                continue;
            }

            if (r->Type[k] >= (byte)RowType.Spring || displaced)
            {
                joint->Lambda[k] = 0;
                joint->Start[k] = 0;
                continue;
            }

            joint->Lambda[k] *= k < r->Hard ? 1 : early;
            joint->Start[k] = joint->Lambda[k];
            Push(joint, r, k, joint->Lambda[k]);
        }
    }

    /// <summary>
    /// Motors and limits of free trees, which have moved, start their other half as they did the first. So a motor of the torque M turns a
    /// wheel of the inertia I by h·(ω₀ + ½h·M/I) and not by h·(ω₀ + h·M/I), and holds half of a weight with half of its force twice; a rope
    /// of the pull T moves its bodies by ½h²·T/m and not by h²·T/m.
    /// </summary>
    public void Resume(ActiveJoint* joint, JointRows* r)
    {
        if (Early(joint) == 1 || IsDisplaced(joint->Ends.NodeA) || IsDisplaced(joint->Ends.NodeB))
        {
            return;
        }

        for (int k = r->Hard; k < r->Count; k++)
        {
            if (!IsInBlock(joint, r, k))
            {
                joint->Lambda[k] += joint->Start[k];
                Push(joint, r, k, joint->Start[k]);
            }
        }
    }

    /// <summary>The row is a limit that is solved with the hard rows.</summary>
    public static bool IsInBlock(ActiveJoint* joint, JointRows* r, int k) => joint->BlockLimits && r->Type[k] == (byte)RowType.Limit;

    /// <summary>Share of the impulse of a motor or limit in a substep that comes before the move.</summary>
    private double Early(ActiveJoint* joint)
    {
        int node = joint->Ends.NodeA >= 0 ? joint->Ends.NodeA : joint->Ends.NodeB;
        return EarlyOf(_view.Trees + _view.Nodes[node].Tree);
    }

    public static double EarlyOf(JointTree* tree) => tree->Free ? 0.5 : 1;

    public void Solve(ActiveJoint* joint, JointRows* r, in JointStep step, bool biased)
    {
        RowEnds.Visit(_view, &joint->Ends);
        double share = biased ? Early(joint) : 1;
        for (int k = r->SoftPoint && SolvePoint(joint, r, share) ? JointRows.OfPoint : r->Hard; k < r->Count; k++)
        {
            if (!IsInBlock(joint, r, k))
            {
                SolveRow(joint, r, k, step, biased, share);
            }
        }

        if (joint->Role == JointRole.Iterated && r->Hard > 0)
        {
            SolveBlock(joint, r, step, biased);
        }
    }

    /// <summary>Displacements have turned the rows since the substep before.</summary>
    private bool IsDisplaced(int node) => node >= 0 && _view.Trees[_view.Nodes[node].Tree].Disturbed;

    private static void Scale(double* j, double factor, double* r)
    {
        r[0] = j[0] * factor;
        r[1] = j[1] * factor;
        r[2] = j[2] * factor;
    }

    /// <summary>J A Jᵀ between two rows of a joint.</summary>
    private double Coupling(ActiveJoint* joint, JointRows* r, int p, int q) =>
        RowEnds.Response(_view.Nodes, &joint->Ends, r->A + (p * 3), r->B + (p * 3), r->A + (q * 3), r->B + (q * 3));

    /// <summary>J M⁻¹ Jᵀ with the mass of the body alone.</summary>
    private static double Own(TreeNode* nodes, int node, double* j) => node < 0
        ? 0
        : (nodes[node].InverseMass * ((j[0] * j[0]) + (j[1] * j[1]))) + (nodes[node].InverseInertia * j[2] * j[2]);

    private void PrepareBlock(ActiveJoint* joint, JointRows* r)
    {
        double* k = stackalloc double[9];
        int n = r->Hard;
        for (int p = 0; p < n; p++)
        {
            for (int q = 0; q < n; q++)
            {
                k[(p * n) + q] = Coupling(joint, r, p, q);
            }
        }

        for (int p = 0; p < n; p++)
        {
            k[(p * n) + p] *= 1 + 1e-9;
        }

        SmallMatrix.Invert(k, n, joint->Block);
    }

    private double RowSpeed(ActiveJoint* joint, JointRows* r, int k) =>
        RowEnds.Speed(_view.Nodes, _states, joint->Ends.NodeA, joint->Ends.BodyA, r->A + (k * 3))
        + RowEnds.Speed(_view.Nodes, _states, joint->Ends.NodeB, joint->Ends.BodyB, r->B + (k * 3));

    /// <summary>Applies an impulse along a row; both bodies stay up to date.</summary>
    private void Apply(ActiveJoint* joint, JointRows* r, int k, double impulse)
    {
        if (impulse == 0)
        {
            return;
        }

        Give(joint, r, k, impulse);
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        Scale(r->A + (k * 3), impulse, a);
        Scale(r->B + (k * 3), impulse, b);
        RowEnds.Apply(_view, &joint->Ends, a, b);
    }

    /// <summary>Applies an impulse along a row to the bodies' own masses, before the trees are solved.</summary>
    private void Push(ActiveJoint* joint, JointRows* r, int k, double impulse)
    {
        Give(joint, r, k, impulse);
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        Scale(r->A + (k * 3), impulse, a);
        Scale(r->B + (k * 3), impulse, b);
        RowEnds.Push(_view.Nodes, &joint->Ends, a, b);
    }

    private static void Give(ActiveJoint* joint, JointRows* r, int k, double impulse)
    {
        joint->Given[0] += r->B[k * 3] * impulse;
        joint->Given[1] += r->B[(k * 3) + 1] * impulse;
        joint->Given[2] += r->B[(k * 3) + 2] * impulse;
    }

    /// <param name="joint">The joint.</param>
    /// <param name="r">Its rows.</param>
    /// <param name="k">Which of them.</param>
    /// <param name="step">The step.</param>
    /// <param name="biased">The biased pass.</param>
    /// <param name="share">What a motor may have given by now of its bounds in a substep.</param>
    private void SolveRow(ActiveJoint* joint, JointRows* r, int k, in JointStep step, bool biased, double share)
    {
        double h = step.Substep;
        double response = joint->Response[k];
        if (!(response > 0))
        {
            Press(joint, r, k, share);
            return;
        }

        double v = RowSpeed(joint, r, k);
        double old = joint->Lambda[k];
        double now;
        switch ((RowType)r->Type[k])
        {
            case RowType.Motor:
                now = old - (r->Share[k] * (v - r->Speed[k] + (r->Damping[k] * old)) / (response + r->Damping[k]));
                now = Math.Max(share * r->Low[k], Math.Min(share * r->High[k], now));
                break;
            case RowType.Limit:
                // What is only just reached in this substep holds in the next one: a tie is no impact yet.
                double need = biased ? -(v + (Math.Max(r->Error[k], 0) / h)) : old * response;
                if (old <= 0 && r->Error[k] > 0 && need <= Touching * Math.Abs(v))
                {
                    return;
                }

                if (!biased && need <= Touching * Math.Abs(v))
                {
                    return;
                }

                now = Math.Max(0, old + Limit(joint, r, k, v, step, biased));
                break;
            default:
                if (!biased)
                {
                    return;
                }

                now = old - (((joint->SpringQ[k] * v) + (joint->SpringKappa[k] * (r->Error[k] + joint->SpringAhead[k])) + (response * old))
                    / (response * (1 + joint->SpringQ[k])));
                if (joint->Kind == JointKind.Target && k == Across)
                {
                    PullAtMost(joint, r, now);
                    return;
                }

                now = Math.Max(r->Low[k], Math.Min(r->High[k], now));
                break;
        }

        joint->Lambda[k] = now;
        Apply(joint, r, k, now - old);
    }

    /// <summary>
    /// The two springs towards a target are one force: its length is bounded, whatever its direction. Each bounded by itself would pull
    /// up to the square root of two times as hard.
    /// </summary>
    private void PullAtMost(ActiveJoint* joint, JointRows* r, double across)
    {
        double along = joint->Lambda[0];
        double length = Math.Sqrt((along * along) + (across * across));
        double share = length > r->High[Across] ? r->High[Across] / length : 1;
        double old = joint->Lambda[Across];
        joint->Lambda[0] = share * along;
        joint->Lambda[Across] = share * across;
        Apply(joint, r, 0, joint->Lambda[0] - along);
        Apply(joint, r, Across, joint->Lambda[Across] - old);
    }

    /// <summary>Soft joints are motors too, with a compliance that leaves them a response.</summary>
    private static bool IsRigidMotor(JointRows* r, int k) => r->Type[k] == (byte)RowType.Motor && !(r->Damping[k] > 0);

    /// <summary>A motor whose tree leaves it no freedom: its own limit holds, or joints on both sides of it.</summary>
    private bool IsStalled(ActiveJoint* joint, JointRows* r, int k)
    {
        if (!IsRigidMotor(r, k))
        {
            return false;
        }

        double* a = r->A + (k * 3);
        double* b = r->B + (k * 3);
        return RowEnds.Response(_view.Nodes, &joint->Ends, a, b, a, b)
            <= RowEnds.Dead * RowEnds.Own(_view.Nodes, &joint->Ends, a, b);
    }

    /// <summary>
    /// A stalled motor pushes with what it has, or with what would set its bodies alone going. The tree takes that up; the limit that it
    /// pushes away from is let go when the trees are next solved. Nothing gathers: what it pushed before does not count.
    /// </summary>
    private void Press(ActiveJoint* joint, JointRows* r, int k, double share)
    {
        if (!IsRigidMotor(r, k))
        {
            return;
        }

        double own = RowEnds.Own(_view.Nodes, &joint->Ends, r->A + (k * 3), r->B + (k * 3));
        if (own > 0)
        {
            double old = joint->Lambda[k];
            double wanted = (r->Speed[k] - RowSpeed(joint, r, k)) / own;
            joint->Lambda[k] = Math.Max(share * r->Low[k], Math.Min(share * r->High[k], wanted));
            Apply(joint, r, k, joint->Lambda[k] - old);
        }
    }

    private static double Limit(ActiveJoint* joint, JointRows* r, int k, double v, in JointStep step, bool biased)
    {
        double gap = r->Error[k];
        double response = joint->Response[k];
        if (gap > 0 || !biased)
        {
            return -(v + (Math.Max(gap, 0) / step.Substep)) / response;
        }

        double over = Math.Min(0, gap + r->Share[k]);
        return -(v + (step.Pace.Recovery * over / step.Substep) + (r->Damping[k] * joint->Lambda[k])) / (response + r->Damping[k]);
    }

    private static double Bias(JointRows* r, int k, in JointStep step)
    {
        double fastest = NetHurry * r->SizeOf(k) / step.PullTime;
        return Math.Max(-fastest, Math.Min(fastest, step.ErrorScale * r->Error[k] * NetBias / step.Substep));
    }

    private void SolveBlock(ActiveJoint* joint, JointRows* r, in JointStep step, bool biased)
    {
        double* residual = stackalloc double[3];
        int n = r->Hard;
        for (int k = 0; k < n; k++)
        {
            bool servo = r->Type[k] == (byte)RowType.Servo;
            double bias = servo ? -r->Speed[k] : biased ? Bias(r, k, step) : 0;
            residual[k] = RowSpeed(joint, r, k) + bias;
        }

        for (int k = 0; k < n; k++)
        {
            double impulse = 0;
            for (int q = 0; q < n; q++)
            {
                impulse -= joint->Block[(k * n) + q] * residual[q];
            }

            if (biased && r->Type[k] != (byte)RowType.Servo)
            {
                impulse = ((impulse * NetProduct) - joint->Lambda[k]) / (1 + NetProduct);
            }

            joint->Lambda[k] += impulse;
            Apply(joint, r, k, impulse);
        }
    }
}
