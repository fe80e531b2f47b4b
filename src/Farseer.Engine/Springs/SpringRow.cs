using System.Numerics;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Springs;

internal enum SpringKind
{
    /// <summary>Along the line between two anchors.</summary>
    Linear,

    /// <summary>About the difference of two angles.</summary>
    Angular,
}

/// <summary>How a spring is integrated within a substep; chosen in each step.</summary>
internal enum SpringForm
{
    /// <summary>Neither body moves.</summary>
    Idle,

    /// <summary>Linear and alone: the exact solution of the damped oscillator over a substep.</summary>
    Exact,

    /// <summary>Solved together with the springs that share its bodies.</summary>
    Mesh,
}

/// <summary>What a facade asks for; body 0 is the world.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 4)]
internal struct SpringDef
{
    public SpringKind Kind;
    public int BodyA;
    public int BodyB;

    /// <summary>In body coordinates; of body 0 in world coordinates. Linear springs only.</summary>
    public Vector2 AnchorA;
    public Vector2 AnchorB;

    /// <summary>Length, or angle of B minus angle of A, without force.</summary>
    public double Rest;

    /// <summary>Force per length, or torque per radian; 0 or more.</summary>
    public double Stiffness;

    /// <summary>Force per speed, or torque per angular speed; 0 or more. An angular spring damps each body by its own spin.</summary>
    public double Damping;

    /// <summary>Largest torque on a body; infinite: no limit. Angular springs only.</summary>
    public double MaxTorque;

    public readonly bool IsSameAs(in SpringDef other) =>
        Kind == other.Kind && BodyA == other.BodyA && BodyB == other.BodyB && AnchorA == other.AnchorA && AnchorB == other.AnchorB
        && Rest.Equals(other.Rest)
        && Stiffness.Equals(other.Stiffness)
        && Damping.Equals(other.Damping)
        && MaxTorque.Equals(other.MaxTorque);
}

/// <summary>One spring during a step: what was asked for, and what the substeps need.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 4)]
internal struct SpringRow
{
    public SpringDef Def;
    public SpringForm Form;

    /// <summary>1 if the body moves; the inverses below are 0 if it does not.</summary>
    public int MovesA;
    public int MovesB;

    /// <summary>1 if the body moves or is driven: then its turn within the step is counted from the foreseen middle of it.</summary>
    public int ActsA;
    public int ActsB;

    /// <summary>1 if the body has constraints besides springs: the solver's positions then speak for all changes of its velocity.</summary>
    public int HeldA;
    public int HeldB;

    public double InverseMassA;
    public double InverseMassB;
    public double InverseInertiaA;
    public double InverseInertiaB;

    /// <summary>
    /// Centre of B minus centre of A at the step's start, or (in X) the difference of the angles in its foreseen middle less the rest.
    /// </summary>
    public double OffsetX;
    public double OffsetY;

    /// <summary>Anchors from the centres, in world axes, as they are in the foreseen middle of the step.</summary>
    public double ArmAX;
    public double ArmAY;
    public double ArmBX;
    public double ArmBY;

    /// <summary>The inverse mass for which <see cref="Law"/> was worked out.</summary>
    public double LawMass;
    public SpringLaw Law;

    /// <summary>Row of the Jacobian in this substep: velocities (linear A, turn A, linear B, turn B) to speed of lengthening.</summary>
    public double NormalX;
    public double NormalY;
    public double TurnA;
    public double TurnB;

    /// <summary>Lengthening from which the mesh reckons.</summary>
    public double Stretch;

    /// <summary>The torque limit was reached: the impulses on the bodies are given, not sought.</summary>
    public int Saturated;
    public double GivenA;
    public double GivenB;
}
