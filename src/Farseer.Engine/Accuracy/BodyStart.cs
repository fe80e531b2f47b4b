using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;

namespace Farseer.Engine.Accuracy;

/// <summary>A body as the step found it, and what is told of it on the way.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 4)]
internal struct BodyStart
{
    public double X;
    public double Y;
    public double Angle;
    public double Energy;

    /// <summary>Energy and velocity after stored impulses have acted, before anything moves.</summary>
    public double AfterImpulses;
    public VelocityChange Velocity;
    public BodyForce Force;

    /// <summary>Energy that drag, springs and a user's joints gave in the substeps.</summary>
    public double Aside;

    /// <summary>Energy that drag gave it in its flight, if it has been struck outside the solver since.</summary>
    public double Dragged;

    /// <summary>1 for such a body.</summary>
    public int Struck;

    /// <summary>1 for a body that went through substeps.</summary>
    public int Solved;
}

/// <summary>A velocity or a change of it.</summary>
internal struct VelocityChange
{
    public double X;
    public double Y;
    public double W;
}
