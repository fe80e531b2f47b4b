using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.Continuous;

/// <summary>Hears of the impacts that the sweep finds.</summary>
internal interface IImpactListener
{
    /// <summary>A pair meets. The bodies are where they are at the impact.</summary>
    /// <param name="contact">The pair.</param>
    /// <param name="manifold">Points from the centre of its body A.</param>
    /// <returns>False if a handler cancelled the response.</returns>
    bool OnImpact(int contact, in Manifold manifold);

    /// <summary>
    /// A body is to be followed along a way that may lead beyond its boxes: what it may meet there is added to its sweep.
    /// </summary>
    void OnWay(FastBodySweep sweep, int body, in BodyPath way);

    /// <summary>There is nothing on a way of a body that <see cref="OnWay"/> would add. Workers ask.</summary>
    bool AddsNothing(int body, in BodyPath way);
}

/// <summary>What the sweep of a step works on.</summary>
internal ref struct SweepInput
{
    public BodyStore Bodies;
    public ShapeStore Shapes;
    public ContactStore Contacts;
    public JointStore Joints;
    public WorldSettings Settings;
    public IImpactListener Listener;

    /// <summary>Sums what contacts give, if somebody reads it.</summary>
    public ContactImpulses? Impulses;
    public DrivenBound Driven;
    public float Dt;
    public float Substep;
}

/// <summary>A pair that a fast body may meet on its way.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct SweepCandidate
{
    public double Target;
    public int Contact;
    public SweepMode Mode;

    /// <summary>The body that it may meet can move: the sweep stops there and leaves the impact to the next step.</summary>
    public byte Moves;
}

internal enum SweepMode : byte
{
    /// <summary>Not met yet: an overlap that stays shallow is no impact.</summary>
    Ahead,

    /// <summary>Met or touched already: looked after when it gets deeper than its target.</summary>
    Met,

    /// <summary>A handler refused it, or it has no contact to give.</summary>
    Passed,
}
