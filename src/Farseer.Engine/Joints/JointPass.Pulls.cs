using System;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>What rows do while bodies are displaced.</content>
internal sealed unsafe partial class JointPass
{
    /// <summary>While bodies are displaced: limits that stand aside are pulled to their places; by nothing else, and no further.</summary>
    public void Pull(ActiveJoint* joint, JointRows* r, in JointStep step)
    {
        if (!joint->Overrun || joint->BlockLimits)
        {
            return;
        }

        RowEnds.Visit(_view, &joint->Ends);
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        for (int k = r->Hard; k < r->Count; k++)
        {
            if (r->Type[k] != (byte)RowType.Limit || !(joint->Outside[k] < 0) || !(joint->Response[k] > 0))
            {
                continue;
            }

            double v = Displacing(joint->Ends.NodeA, r->A + (k * 3)) + Displacing(joint->Ends.NodeB, r->B + (k * 3));
            double old = joint->PlainLambda[k];
            double pull = JointSolver.PullSpeed(joint->Outside[k], r, k, step);
            joint->PlainLambda[k] = Math.Max(0, old - ((v + pull) / joint->Response[k]));
            Scale(r->A + (k * 3), joint->PlainLambda[k] - old, a);
            Scale(r->B + (k * 3), joint->PlainLambda[k] - old, b);
            RowEnds.Apply(_view, &joint->Ends, a, b);
        }
    }

    /// <summary>What cannot be moved is not displaced, though it may be moving.</summary>
    private double Displacing(int node, double* j) => node >= 0 ? SmallMatrix.Dot(j, _view.Nodes[node].Velocity) : 0;
}
