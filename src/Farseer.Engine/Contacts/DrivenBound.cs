using System;
using Farseer.Engine.Bodies;

namespace Farseer.Engine.Contacts;

/// <summary>
/// How far restitutions above 1 drive bodies on. They make energy at each bounce, without end: sooner or later a body gets further in a
/// step than its impacts can be followed, and leaves its room. So a rebound is faster than its approach only up to a speed; beyond it
/// nothing is lost and nothing gained.
/// </summary>
internal readonly unsafe struct DrivenBound
{
    /// <summary>
    /// Way in a step, and in a substep, in extents of the body, each half of its shorter side. Rooms of up to twelve bodies with thin walls
    /// lose no more at this than with a restitution of 1; with twice as much in a substep, and one substep, one of fifty loses some.
    /// </summary>
    private const double MostExtents = 4;
    private const double MostOfSubstep = 0.5;

    private readonly double _perExtent;
    private readonly double _most;
    private readonly double _mostSpin;

    /// <param name="dt">The step, seconds.</param>
    /// <param name="substeps">Its substeps.</param>
    /// <param name="most">Greatest speed in any case, a speed of the scene.</param>
    /// <param name="mostSpin">Greatest spin in any case, rad/s.</param>
    public DrivenBound(double dt, int substeps, double most, double mostSpin)
    {
        _perExtent = Math.Min(MostExtents, MostOfSubstep * substeps) / dt;
        _most = most;
        _mostSpin = mostSpin;
    }

    /// <summary>Speed up to which a body is driven.</summary>
    public double SpeedOf(BodyStore bodies, int body) => Math.Min(_perExtent * bodies.Size[body].Extent, _most);

    /// <summary>Spin up to which it is driven, rad/s: none of its points is faster than it may be.</summary>
    public double SpinOf(BodyStore bodies, int body)
    {
        BodySize size = bodies.Size[body];
        return size.Reach > 0 ? Math.Min(_perExtent * size.Extent / size.Reach, _mostSpin) : _mostSpin;
    }

    /// <summary>Speed up to which an impact drives two bodies apart: that of the slower one of those that move.</summary>
    public double SpeedOf(BodyStore bodies, int bodyA, int bodyB) =>
        Math.Min(
            bodies.Mass[bodyA].InverseMass > 0 ? SpeedOf(bodies, bodyA) : _most,
            bodies.Mass[bodyB].InverseMass > 0 ? SpeedOf(bodies, bodyB) : _most);

    /// <summary>Notes how far the contacts of a bundle drive.</summary>
    public void Note(BounceLanes* bounce, BodyStore bodies)
    {
        ContactBundle* row = bounce->Row;
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            bool drives = ((bounce->Can >> lane) & 1) != 0 && row->Restitution[lane] > 1;
            bounce->Most[lane] = drives ? (float)SpeedOf(bodies, row->BodyA[lane], row->BodyB[lane]) : float.PositiveInfinity;
        }
    }
}
