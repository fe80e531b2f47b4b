using System;
using Farseer.Engine.Accuracy;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// How exact the last update was, measured at the state that it ended with; see <see cref="PhysicsSimulator.Report"/>. Lengths,
/// speeds, masses and energies are in the units of the scene. (An addition to the original.)
/// </summary>
/// <remarks>
/// Each work is the energy that its cause gave to the bodies in the update, negative where it took some away. The works and
/// <see cref="EnergyError"/> together are the change of the kinetic energy, to rounding.
/// </remarks>
/// <example>
/// <code>
/// simulator.EnableReport = true;
/// simulator.Update(1f / 60);
/// StepReport report = simulator.Report;
/// Console.WriteLine($"overlap {report.LargestPenetration}, joints open by {report.LargestSeparation}");
/// </code>
/// </example>
public readonly struct StepReport
{
    private readonly StepMeasures _measures;

    internal StepReport(
        in StepMeasures measures,
        Body? worstBody,
        Body? worstPartner,
        Joint? worstJoint,
        double budgetLoad,
        TimeSpan stepTime,
        TimeSpan timeLimit)
    {
        WorstJoint = worstJoint;
        StepTime = stepTime;
        IsWithinTimeLimit = timeLimit == TimeSpan.Zero || stepTime <= timeLimit;
        _measures = measures;
        WorstBody = worstBody;
        WorstPartner = worstPartner;
        BudgetLoad = budgetLoad;
    }

    /// <summary>Iterations that the update took; 0 if none has been measured yet.</summary>
    public int Iterations => _measures.Substeps;

    /// <summary>Iterations of the island that took most: heavy loads on chains are solved in finer steps than the rest.</summary>
    public int MostIterations => _measures.MostSubsteps;

    /// <summary>Pairs of convex pieces that pushed each other apart or were about to.</summary>
    public int Contacts => _measures.Contacts;

    /// <summary>Deepest overlap of two geoms that push each other apart, a length.</summary>
    public double LargestPenetration => _measures.LargestPenetration;

    /// <summary>Root of the mean square of the overlaps over all <see cref="Contacts"/>, a length.</summary>
    public double RmsPenetration => _measures.RmsPenetration;

    /// <summary>Fastest approach of two surfaces that overlap, length/s: what the next update begins with.</summary>
    public double ResidualContactSpeed => _measures.ContactSpeed;

    /// <summary>Joints that act on a body that can move.</summary>
    public int Joints => _measures.Joints;

    /// <summary>Farthest that a rigid joint is apart, or a limit is overrun, a length.</summary>
    public double LargestSeparation => _measures.LargestSeparation;

    /// <summary>Root of the mean square of the separations over all <see cref="Joints"/>, a length.</summary>
    public double RmsSeparation => _measures.RmsSeparation;

    /// <summary>Farthest that a joint is turned off, or a limit is overrun, radians.</summary>
    public double LargestTurn => _measures.LargestTurn;

    /// <summary>Fastest that the parts of a rigid joint move apart, length/s.</summary>
    public double ResidualJointSpeed => _measures.JointSpeed;

    /// <summary>
    /// Farthest that a contact which friction holds went along its tangent in the update, a length. It counts from the second update on in
    /// which the same point is held; a contact that slides at the bound of its friction has no such error.
    /// </summary>
    public double LargestSlip => _measures.LargestSlip;

    /// <summary>The same way, summed up since the contact began to hold: of the contact where it is largest. Part of no budget.</summary>
    public double LargestCreep => _measures.LargestCreep;

    /// <summary>
    /// Energy that impacts gave beyond their law, below 0 what they took beyond it; of the group of connected bodies where it is largest. A
    /// blow on one contact takes (1 - e²)/2·m·v², with the mass m that its bodies have there and the speed v of their approach. Of several
    /// blows on a group the law says only that they give nothing and take at most (1 - e⁴) of the energy, so with a restitution of 1
    /// nothing; friction may take more. 0 where motors, springs of joints, moving supports or joints of your own share in it.
    /// </summary>
    public double ImpactEnergyError => _measures.ImpactEnergyError;

    /// <summary>
    /// The way that this energy leads astray in an update: by how much it changes the speed of the group, times the step. A length.
    /// </summary>
    public double LargestImpactError => _measures.LargestImpactError;

    /// <summary>
    /// How far the way of a body in this update is, by estimate, from its way with ever more iterations, a length: of the centre of mass,
    /// and of its turn times its radius of gyration. Of the body where it is largest.
    /// </summary>
    /// <remarks>
    /// The estimate comes from the velocities between the iterations and from the depths of contacts; the update is not done twice. It is
    /// meant to be too large, for smooth motions by a factor of about 5, for impacts by up to 100. It sees no error that all iterations of
    /// an update share: contacts are found once, forces are those of its start. It knows this update alone: errors of many add up, and a
    /// scene that small differences decide, such as a double pendulum, makes more of them.
    /// </remarks>
    public double MotionError => _measures.MotionError;

    /// <summary>
    /// The largest of what is wrong with the state itself, a length: <see cref="LargestPenetration"/>, <see cref="LargestSeparation"/>,
    /// <see cref="LargestSlip"/>, <see cref="LargestImpactError"/>, and the way that <see cref="MomentumError"/> leads astray.
    /// </summary>
    public double ConstraintError => _measures.ConstraintError;

    /// <summary>
    /// The error that <see cref="PhysicsSimulator.ErrorBudget"/> bounds, a length: the larger of <see cref="ConstraintError"/> and
    /// <see cref="MotionError"/>. Infinite if a body was lost in the update.
    /// </summary>
    public double Error => _measures.Error;

    /// <summary>
    /// The same errors as shares of the shorter side of the smaller geom, of the joint's arms, or of the body's size (2.45 times its radius
    /// of gyration); the largest of all.
    /// </summary>
    public double ErrorShare => _measures.ErrorShare;

    /// <summary>What <see cref="Error"/> is an error of.</summary>
    public ErrorCause Cause => (ErrorCause)(int)_measures.Cause;

    /// <summary>A body of the pair, joint or group with the largest error; null if there is no error or the body is the world.</summary>
    public Body? WorstBody { get; }

    /// <summary>The other body of that pair or joint; null for an error of a single body.</summary>
    public Body? WorstPartner { get; }

    /// <summary>The joint with the largest error, if it is one of a joint.</summary>
    public Joint? WorstJoint { get; }

    /// <summary>
    /// Bodies that can move of the group, connected by contacts and joints, that the largest error is in; 0 without error.
    /// </summary>
    public int WorstIslandBodies => _measures.WorstIsland;

    /// <summary>The error divided by the budget; above 1 it was not kept. 0 without a budget.</summary>
    public double BudgetLoad { get; }

    /// <summary>
    /// True unless there is an <see cref="PhysicsSimulator.ErrorBudget"/> that the update did not keep. By how much is in
    /// <see cref="BudgetLoad"/>, of what in <see cref="Cause"/>, and where in <see cref="WorstBody"/>, <see cref="WorstPartner"/> and
    /// <see cref="WorstJoint"/>.
    /// </summary>
    public bool IsWithinBudget => BudgetLoad <= 1;

    /// <summary>Time that the step of the update took; zero unless the budget has a <see cref="ErrorBudget.TimeLimit"/>.</summary>
    public TimeSpan StepTime { get; }

    /// <summary>False if the budget has a <see cref="ErrorBudget.TimeLimit"/> and the step took longer; else true.</summary>
    public bool IsWithinTimeLimit { get; }

    /// <summary>Kinetic energy of all bodies after the update.</summary>
    public double KineticEnergy => _measures.Kinetic;

    /// <summary>Kinetic energy after the update less that before it.</summary>
    public double KineticEnergyChange => _measures.KineticChange;

    /// <summary>Work of gravity along the way of each body: minus the change of the potential energy.</summary>
    public double GravityWork => _measures.GravityWork;

    /// <summary>Work of forces and torques that were applied, controllers included.</summary>
    public double ForceWork => _measures.ForceWork;

    /// <summary>Energy that impulses and velocities set during the update gave, before anything moved.</summary>
    public double ImpulseWork => _measures.ImpulseWork;

    /// <summary>Work of drag; never positive but for rounding.</summary>
    public double DragWork => _measures.DragWork;

    /// <summary>Work of springs.</summary>
    public double SpringWork => _measures.SpringWork;

    /// <summary>Work of the motors and springs of joints.</summary>
    public double MotorWork => _measures.MotorWork;

    /// <summary>
    /// Work of rigid joints, which ought to be none, of their limits, which take energy where they stop a motion, and of contacts at bodies
    /// of jointed trees, which are solved together with the joints.
    /// </summary>
    public double JointWork => _measures.JointWork;

    /// <summary>Work of joints of the user's own.</summary>
    public double UserJointWork => _measures.UserJointWork;

    /// <summary>Work of contacts: friction and the stop of impacts, negative; moving supports may give energy.</summary>
    public double ContactWork => _measures.ContactWork;

    /// <summary>
    /// Energy that impacts with restitution gave back after their stop, which <see cref="ContactWork"/> holds; of two fast bodies that fly
    /// alone that holds both.
    /// </summary>
    public double BounceWork => _measures.BounceWork;

    /// <summary>
    /// Change of the kinetic energy that no work explains: bodies that were moved without speed (out of deep overlaps, into joints),
    /// and rounding.
    /// </summary>
    public double EnergyError => _measures.EnergyError;

    /// <summary>x of the momentum of all bodies after the update.</summary>
    public double MomentumX => _measures.MomentumX;

    /// <summary>y of the momentum of all bodies after the update.</summary>
    public double MomentumY => _measures.MomentumY;

    /// <summary>x of the impulse that contacts and joints with bodies that cannot move gave in the update.</summary>
    public double SupportImpulseX => _measures.SupportX;

    /// <summary>y of the impulse that contacts and joints with bodies that cannot move gave in the update.</summary>
    public double SupportImpulseY => _measures.SupportY;

    /// <summary>
    /// Largest sum of the impulses of contacts and joints inside a group of bodies that touches nothing fixed: 0 but for rounding, since
    /// every impulse acts both ways.
    /// </summary>
    public double MomentumError => _measures.MomentumError;

    /// <summary>Writes, or reads, the report of the last step.</summary>
    internal static StepReport Visit(StateStream s, in StepReport report)
    {
        StepMeasures measures = s.Value(report._measures);
        Body? body = s.Reference(report.WorstBody);
        Body? partner = s.Reference(report.WorstPartner);
        Joint? joint = s.Reference(report.WorstJoint);
        double load = s.Value(report.BudgetLoad);
        TimeSpan time = s.Value(report.StepTime);
        bool within = s.Value(report.IsWithinTimeLimit);
        TimeSpan limit = within ? TimeSpan.Zero : time - new TimeSpan(1);
        return s.IsReading ? new StepReport(measures, body, partner, joint, load, time, limit) : report;
    }
}
