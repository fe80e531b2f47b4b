using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>What the joints see of a step.</summary>
[NotState(Why.OfOneStep)]
internal unsafe struct JointStep
{
    private const double FarShorter = 0.5;

    public StageRunner Runner;
    public BodyStore Bodies;

    /// <summary>1 for a body that the solver may move.</summary>
    public byte* Moves;
    public double Dt;
    public double Substep;

    /// <summary>Contact rows at each body.</summary>
    public int* Touches;

    /// <summary>Contacts that there is room for.</summary>
    public int ContactRoom;

    /// <summary>Ratio of this step's substep to the last one's.</summary>
    public double ImpulseScale;

    /// <summary>
    /// The share of the last impulses to start from: those of a longer substep by the ratio, those of a shorter one as they are. Of an
    /// impulse nothing says how much was a blow, which does not go by the length of the substep; a step of 1/60 s after one of 10⁻⁴ s would
    /// repeat it 167 times as hard.
    /// </summary>
    public readonly double StartScale => Math.Min(1, ImpulseScale);

    /// <summary>
    /// The substep in terms of the longest of late, at most 1: which share of what goes in a substep goes in this one. What is left of
    /// errors was made by that: taken for motion of this step, an impact's 50 mm became 130 m/s in a step of 13 µs.
    /// </summary>
    public double ErrorScale;

    /// <summary>
    /// What longer steps left of errors is too much to be this one's motion. Steps of nearly the same length leave what each may have.
    /// </summary>
    public readonly bool IsFarShorter => ErrorScale < FarShorter;

    /// <summary>
    /// The longest step of late, seconds: the time in which the share β of an error goes, and by which soft joints are as stiff as they
    /// are.
    /// </summary>
    public readonly double PullTime => Dt / ErrorScale;

    /// <summary>How limits take back what they are past.</summary>
    public readonly LimitPace Pace => new LimitPace(Substep, ErrorScale);

    /// <summary>Errors stay: joints only stop what would make them larger.</summary>
    public bool Drifts;

    /// <summary>Somebody asks for the work of motors and springs, or for what contacts give.</summary>
    public bool Audited;

    /// <summary>Sums what contacts give, if somebody reads it.</summary>
    public ContactImpulses? Impulses;

    /// <summary>Others look at velocities between the passes, or change them: springs, joints that a user wrote, accounts.</summary>
    public bool Watched;

    /// <summary>A joint that breaks still acts in the step.</summary>
    public bool BreaksLate;
}
