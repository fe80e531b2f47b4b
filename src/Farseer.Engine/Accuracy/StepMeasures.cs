using System.Runtime.InteropServices;

namespace Farseer.Engine.Accuracy;

/// <summary>What a step did, in its own units. Bodies are indices; -1: none.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct StepMeasures
{
    public int Substeps;

    /// <summary>Of the island that took most.</summary>
    public int MostSubsteps;

    /// <summary>Pairs of pieces that push each other apart and touched in the step.</summary>
    public int Contacts;
    public double LargestPenetration;
    public double RmsPenetration;

    /// <summary>Fastest approach of two surfaces that overlap, after the step.</summary>
    public double ContactSpeed;

    public int Joints;

    /// <summary>Error of a joint's rigid rows that are lengths, over the joint.</summary>
    public double LargestSeparation;
    public double RmsSeparation;

    /// <summary>Error of a rigid row, or overrun of a limit, that is an angle.</summary>
    public double LargestTurn;
    public double JointSpeed;

    /// <summary>The larger of penetration beyond what is allowed and separation, and the same as a share of the smaller piece's side.</summary>
    public double Error;
    public double ErrorShare;
    public int WorstBody;
    public int WorstPartner;
    public int WorstIsland;

    public double Kinetic;
    public double KineticChange;
    public double GravityWork;
    public double ForceWork;
    public double ImpulseWork;
    public double DragWork;
    public double SpringWork;
    public double MotorWork;
    public double JointWork;
    public double UserJointWork;
    public double ContactWork;
    public double BounceWork;

    /// <summary>Momentum after the step, its change in it, and what the static world gave of that through contacts and joints.</summary>
    public double MomentumX;
    public double MomentumY;
    public double SupportX;
    public double SupportY;

    /// <summary>Largest sum of inner impulses over a group of bodies that nothing fixed holds; 0 by Newton's third law.</summary>
    public double MomentumError;

    /// <summary>Change of the kinetic energy that no work explains: bodies moved without speed, and rounding.</summary>
    public double EnergyError => KineticChange - (GravityWork + ForceWork + ImpulseWork + DragWork + SpringWork + MotorWork + JointWork
        + UserJointWork + ContactWork + BounceWork);
}
