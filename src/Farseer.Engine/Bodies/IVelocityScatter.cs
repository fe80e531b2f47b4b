using System.Runtime.CompilerServices;

namespace Farseer.Engine.Bodies;

/// <summary>
/// How a pass gives the bodies their velocities. A type and not a flag: with both ways in one loop the passes took 4 to 9 % longer, for the
/// registers that a call spares.
/// </summary>
internal unsafe interface IVelocityScatter
{
    void Scatter(BodyState* bodies, int* index, in WideVelocity v, float* mass, float* inertia);
}

/// <summary>All bodies are written.</summary>
internal readonly unsafe struct ScatterAll : IVelocityScatter
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Scatter(BodyState* bodies, int* index, in WideVelocity v, float* mass, float* inertia) =>
        BodyLanes.ScatterVelocity(bodies, index, v);
}

/// <summary>
/// For the colours of the ground: what does not move is not written, because several rows of a colour share it, and other workers read it
/// meanwhile.
/// </summary>
internal readonly unsafe struct ScatterMoving : IVelocityScatter
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Scatter(BodyState* bodies, int* index, in WideVelocity v, float* mass, float* inertia) =>
        BodyLanes.ScatterMoving(bodies, index, v, mass, inertia);
}
