using System;
using Farseer.Engine.Joints.Nets;

namespace Farseer.Engine.Joints;

/// <summary>What the rows of a rigid pivot are.</summary>
internal enum PivotKind : byte
{
    /// <summary>It is none, or has other rows.</summary>
    None,

    /// <summary>Two hard rows that hold two points together.</summary>
    Point,

    /// <summary>The same, and behind them the lower and the upper limit of the angle.</summary>
    Limited,
}

/// <summary>
/// A kind of joint: the equations φ(xA, xB) that it keeps, written as rows. Everything else (factorisation, iteration, warm
/// start, limits, motors, springs) is the same for all kinds and is written once, in the solver.
/// </summary>
internal abstract class JointForm
{
    private const double TwoPi = 6.283185307179586;

    /// <summary>Writes the rows at a pose; <see cref="JointFrame.SetAnchors"/> has been called.</summary>
    public abstract void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows);

    /// <summary>The form in which nets have it on lanes: hard rows of that form and no others.</summary>
    public virtual NetForm NetFormOf(in JointSettings s, JointFlags flags) => NetForm.None;

    /// <summary>Whether it is a rigid pivot that can be written without the form.</summary>
    public virtual PivotKind PivotOf(in JointSettings s, JointFlags flags) => PivotKind.None;

    /// <summary>
    /// The original's softness σ: dφ/dt + β·φ/dt + σ·P = 0 with the impulse P of a whole step, so that a force F holds it at
    /// φ = σ·F·dt²/β. The speed -β·φ/dt is kept for the step, and the impulses of its substeps are P·h/dt.
    /// </summary>
    protected static void Soften(ref JointRows rows, int row, in JointFrame f, in JointSettings s)
    {
        rows.SetMotor(row, -s.BiasFactor * rows.ErrorOf(row) / f.PullTime, s.MaxImpulse);
        rows.SetSpring(row, 0, s.Softness * f.PullTime / f.H);
    }

    protected static double AngularFrequency(in JointSettings s) => TwoPi * s.Frequency;

    /// <summary>
    /// A row that turns towards φ = 0: the speed takes away the share β of the error in a step. With an unbounded impulse and
    /// no softness it belongs to the block.
    /// </summary>
    protected static void AddServo(in JointFrame f, in JointSettings s, ref JointRows rows, double wa, double wb, double error)
    {
        bool rigid = double.IsInfinity(s.MaxImpulse) && s.Softness == 0;
        int row = rows.Add(rigid ? RowType.Servo : RowType.Motor, 0, 0, wa, 0, 0, wb, error);
        rows.SetMotor(row, -s.BiasFactor * error / f.PullTime, s.MaxImpulse);
        rows.SetShare(row, 1 - s.Softness);
        rows.JointError = error;
    }

    /// <summary>The unit vector from anchor to anchor; the x axis where they coincide.</summary>
    protected static double Direction(in JointFrame f, out double nx, out double ny)
    {
        double length = Math.Sqrt((f.DX * f.DX) + (f.DY * f.DY));
        if (length > 0)
        {
            nx = f.DX / length;
            ny = f.DY / length;
        }
        else
        {
            nx = 1;
            ny = 0;
        }

        return length;
    }

    protected static double Distance(in JointFrame f) => Math.Sqrt((f.DX * f.DX) + (f.DY * f.DY));
}
