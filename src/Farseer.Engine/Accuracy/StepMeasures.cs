using System.Runtime.InteropServices;

namespace Farseer.Engine.Accuracy;

/// <summary>What a step did, in its own units. Bodies are indices; -1: none.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 4)]
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

    /// <summary>Farthest way of a contact that sticks along its tangent in the step, and since it began to stick.</summary>
    public double LargestSlip;
    public double LargestCreep;

    /// <summary>Of the group where it is largest: energy beyond the law of impacts, below 0 what is missing.</summary>
    public double ImpactEnergyError;

    /// <summary>The error of the way that it makes in a step.</summary>
    public double LargestImpactError;

    /// <summary>Largest estimated error of the way of a body in the step, and the body.</summary>
    public double MotionError;
    public int MotionBody;

    /// <summary>The largest of all errors but that of the motion.</summary>
    public double ConstraintError;

    /// <summary>The largest of all errors, and the largest share of the size of what it is an error of.</summary>
    public double Error;
    public double ErrorShare;

    /// <summary>The same of what more substeps would make less.</summary>
    public double Curable;
    public double CurableShare;

    public ErrorCause Cause;
    public int WorstBody;
    public int WorstPartner;

    /// <summary>The joint, where one is apart; else -1.</summary>
    public int WorstJoint;
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
