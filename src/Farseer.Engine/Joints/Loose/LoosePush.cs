using Farseer.Engine.Bodies;

namespace Farseer.Engine.Joints.Loose;

/// <summary>
/// How much further than its velocity the store has moved a body in a substep. Bodies of limits alone are not asked: a limit that contacts
/// do not let be reached pulls back at once what was pushed apart, and the two would gain energy from each other.
/// </summary>
internal struct LoosePush
{
    public double X;
    public double Y;
    public double Turn;

    /// <param name="step">What the joints see of the step.</param>
    /// <param name="body">A body that has moved plainly by its velocity.</param>
    /// <param name="before">Its displacement and turn before.</param>
    public static unsafe LoosePush Of(in JointStep step, int body, double* before)
    {
        BodyState* state = step.Bodies.State.Pointer + body;
        float h = (float)step.Substep;
        LoosePush push;
        push.X = state->DeltaPosition.X - (float)((float)before[0] + (float)(h * state->LinearVelocity.X));
        push.Y = state->DeltaPosition.Y - (float)((float)before[1] + (float)(h * state->LinearVelocity.Y));
        push.Turn = step.Bodies.Motion[body].Turned - (float)((float)before[2] + (float)(h * state->AngularVelocity));
        return push;
    }
}
