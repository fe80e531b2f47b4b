using System.Runtime.InteropServices;

namespace Farseer.Engine.Contacts;

/// <summary>What the impacts of a substep need beside a bundle whose contacts can bounce, a lane each.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct BounceLanes
{
    public const int Lanes = ContactBundle.Lanes;

    public ContactBundle* Row;

    /// <summary>Bits of the lanes that can have impacts, and of those among them whose impacts concern nobody else.</summary>
    public int Can;
    public int Free;

    /// <summary>Bits of the lanes of small islands, whose impacts are solved directly.</summary>
    public int Direct;

    /// <summary>Bits of those of which a point may strike while the other is pressed.</summary>
    public int PointByPoint;

    /// <summary>A bit for each lane whose impact is being solved, and for each that meets later in the substep.</summary>
    public int Hits;
    public int Later;

    /// <summary>Bits of the lanes that had an impact in this substep, and of those with a point that is held back.</summary>
    public int Struck;
    public int Held;

    /// <summary>Bits of the lanes with an impact on a body that is too heavy for others to wait for it.</summary>
    public int Heavy;

    /// <summary>Bits of the lanes whose surfaces have met in this substep, those among them that others preceded.</summary>
    public int Met;

    public fixed float Slow[Lanes];

    /// <summary>Speed up to which a restitution above 1 makes a rebound faster than its approach.</summary>
    public fixed float Most[Lanes];

    /// <summary>How long ago the surfaces met, seconds before the end of the substep.</summary>
    public fixed float Time[Lanes];

    public BouncePointLanes Point0;
    public BouncePointLanes Point1;
}

/// <summary>One point of each contact of <see cref="BounceLanes"/>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct BouncePointLanes
{
    public const int Lanes = ContactBundle.Lanes;

    /// <summary>
    /// Base separation of a point that is held back from the passes of the substep, else <see cref="ContactBundle.NoPoint"/>.
    /// </summary>
    public fixed float Base[Lanes];

    /// <summary>Impulses of its impacts so far, while it is held back.</summary>
    public fixed float Normal[Lanes];
    public fixed float Tangent[Lanes];

    /// <summary>Overlap at the start of the substep, as a gap of at most 0: surfaces meet when they come to it.</summary>
    public fixed float Level[Lanes];

    /// <summary>Speed at which the surfaces are to part; negative: no impact.</summary>
    public fixed float Target[Lanes];

    /// <summary>Impulses of the impact that is being solved.</summary>
    public fixed float Push[Lanes];
    public fixed float Rub[Lanes];

    /// <summary>Impulses of all impacts of the substep.</summary>
    public fixed float Pushed[Lanes];
    public fixed float Rubbed[Lanes];
}
