namespace Farseer.Fidelity.Fine;

/// <summary>A force that depends on places and velocities.</summary>
internal interface IFinePull
{
    /// <summary>Before the first small step of a step of the scene.</summary>
    void BeginStep();

    void Pull(double step);
}
