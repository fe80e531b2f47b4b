namespace Farseer.Engine.Solver;

/// <summary>What changes the velocities of bodies within a substep.</summary>
internal enum SolverPart
{
    /// <summary>Gravity, forces, torques and drag.</summary>
    Drive,
    Springs,

    /// <summary>Contacts without their bounce: supports, friction, the stop of an impact.</summary>
    Contacts,
    Joints,
    UserJoints,

    /// <summary>The bounce of impacts.</summary>
    Impacts,
    Count,
}

/// <summary>Books the velocity changes of a step by their cause. The solver has none unless somebody wants a report.</summary>
internal interface ISolverAudit
{
    void BeginSubstep();

    /// <summary>What changed since the last call is due to <paramref name="part"/>.</summary>
    void Book(SolverPart part);

    void EndSubstep();
}
