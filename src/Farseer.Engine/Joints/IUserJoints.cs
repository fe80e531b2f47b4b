namespace Farseer.Engine.Joints;

/// <summary>
/// What the solver calls for joints that a user has written. While it does, the poses of the store are those of the present
/// substep. Every call comes on the thread that called <c>Step</c>, never inside a parallel phase.
/// </summary>
internal interface IUserJoints
{
    /// <summary>There are such joints: all bodies then take part in the solver, since any may be theirs.</summary>
    bool Any { get; }

    /// <summary>Once a substep, before the impulses.</summary>
    void Prepare(float inverseSubstep);

    /// <summary>Once a sweep.</summary>
    void Solve();

    /// <summary>A joint broke: it is switched off already.</summary>
    void Broke(int joint);
}
