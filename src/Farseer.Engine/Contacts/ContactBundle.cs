using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// Eight contacts of one colour, a lane each: pair, ids, impulses and constraint together, so that the narrow phase rewrites
/// the row in place and nothing is copied. Symbols are those of docs/Notation.md: n the normal from A to B, t = (ny, -nx) the
/// tangent; for an anchor r, an = r·n and at = r×n, with which
/// <code>
/// vn = n·(vB - vA) + wB·atB - wA·atA        vt = t·(vB - vA) - wB·anB + wA·anA
/// s  = base + n·(dB - dA) + (cB·anB + sB·atB) - (cA·anA + sA·atA)
/// </code>
/// where d, c, s are the displacement and turn since the start of the step. A lane without a contact, and the second point of
/// a contact that has one, carry a base separation so large that no impulse ever arises.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct ContactBundle
{
    public const int Lanes = WideLanes.BundleLanes;

    /// <summary>The lanes of a column as it lies in memory: a cache line, of which a bundle is a part.</summary>
    public const int LineLanes = Prefetch.LineBytes / sizeof(float);

    /// <summary>The size of a record, which is that of all the bundles side by side in it.</summary>
    public const int Bytes = 44 * Prefetch.LineBytes;

    /// <summary>Bundles side by side in a record.</summary>
    public const int Beside = LineLanes / Lanes;

    private const int BytesBeside = Lanes * sizeof(float);

    /// <summary>Records from one that is read to the one asked for.</summary>
    private const int Ahead = 3;

    /// <summary>The bits of <see cref="ContactFlags"/>.</summary>
    public const int FlagBits = 0xFF;

    /// <summary>
    /// A contact with one point, whose feed-forward follows its own impulse, or an empty lane. What these have of a second point
    /// is 0: see <see cref="OnePoint"/>.
    /// </summary>
    public const int SingleMark = 0x100;

    /// <summary>A contact of a deep island.</summary>
    public const int DeepMark = 0x200;

    /// <summary>Its two points are far enough apart to be solved together, else row by row.</summary>
    public const int BlockMark = 0x400;

    /// <summary>A surface lies far from its body: see <see cref="FarSurfaces"/>.</summary>
    public const int FarMark = 0x800;

    /// <summary>
    /// The upper half of the flags is that of a number: how deep in each other the surfaces rest, see
    /// <see cref="Settings.WorldSettings.AllowedPenetrationShare"/>.
    /// </summary>
    private const int RestBits = unchecked((int)0xFFFF0000);

    /// <summary>Separation of a point that does not exist. Finite also after the division by the substep.</summary>
    public const float NoPoint = 1e30f;

    // The order is that of use: every line of the first part is read in every substep, and the passes over a large world wait for memory
    // more than for anything else.
    public fixed int BodyA[LineLanes];
    public fixed int BodyB[LineLanes];
    public fixed float NormalX[LineLanes];
    public fixed float NormalY[LineLanes];
    public fixed float MassA[LineLanes];
    public fixed float MassB[LineLanes];
    public fixed float InertiaA[LineLanes];
    public fixed float InertiaB[LineLanes];

    /// <summary>Rounding radii of the pieces: what the normal arms of the surfaces have beyond those of the turning cores.</summary>
    public fixed float RadiusA[LineLanes];
    public fixed float RadiusB[LineLanes];

    public ContactPointLanes Point0;
    public ContactPointLanes Point1;

    /// <summary>
    /// Normal responses kii = mA + mB + iA·atAi² + iB·atBi². What else follows from masses and arms is found where it is needed.
    /// </summary>
    public fixed float K11[LineLanes];
    public fixed float K22[LineLanes];
    public fixed float Friction[LineLanes];

    /// <summary>
    /// <see cref="ContactFlags"/> of the record, so that it is only touched when they change, and above them <see cref="SingleMark"/>,
    /// <see cref="DeepMark"/>, <see cref="BlockMark"/> and the depth at which surfaces rest.
    /// </summary>
    public fixed int Flags[LineLanes];

    /// <summary>h/τ of the feed-forward: how fast it follows the impulse.</summary>
    public fixed float FeedRate[LineLanes];

    /// <summary>η: the share of the load that the feed-forward carries.</summary>
    public fixed float FeedShare[LineLanes];

    /// <summary>Combined restitution.</summary>
    public fixed float Restitution[LineLanes];

    /// <summary>Impulses of the impacts of the pair in this step, else 0: by the step's end nothing else tells of them.</summary>
    public fixed float Struck[LineLanes];

    /// <summary>Index of the contact record; -1 in an empty lane.</summary>
    public fixed int Contact[LineLanes];

    public fixed int PieceA[LineLanes];
    public fixed int PieceB[LineLanes];

    /// <summary>Names of the points, which follow them from step to step.</summary>
    public fixed uint Id0[LineLanes];
    public fixed uint Id1[LineLanes];

    /// <summary>Slot of its island and level: see <c>IslandStore</c>.</summary>
    public fixed int Slot[LineLanes];

    /// <summary>Lanes with a mark.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask Has(ContactBundle* row, int lane, int mark) => WideLanes.Has(Wide.Load((float*)row->Flags + lane), mark);

    /// <summary>Gives the lanes of the mask a mark, and takes it from the others.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Mark(ContactBundle* row, int lane, WideMask marked, int mark)
    {
        Wide flags = Wide.Load((float*)row->Flags + lane);
        ((flags & Wide.FromBits(~mark)) | Wide.Keep(marked, Wide.FromBits(mark))).Store((float*)row->Flags + lane);
    }

    /// <summary>The depth at which the surfaces of a lane rest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide RestDepth(ContactBundle* row, int lane) => Wide.Load((float*)row->Flags + lane) & Wide.FromBits(RestBits);

    /// <summary>The same of one lane.</summary>
    public static float RestDepthOf(ContactBundle* row, int lane)
    {
        int bits = row->Flags[lane] & RestBits;
        return *(float*)&bits;
    }

    /// <returns>The depth as it is kept: to a hundredth.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide SetRestDepth(ContactBundle* row, int lane, Wide depth)
    {
        Wide kept = depth & Wide.FromBits(RestBits);
        Wide flags = Wide.Load((float*)row->Flags + lane);
        ((flags & Wide.FromBits(~RestBits)) | kept).Store((float*)row->Flags + lane);
        return kept;
    }

    /// <summary>A bit for each lane with a mark.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int LanesWith(ContactBundle* row, int mark)
    {
        int bits = 0;
        for (int lane = 0; lane < Lanes; lane += Wide.Count)
        {
            bits |= WideLanes.Bits(Has(row, lane, mark)) << lane;
        }

        return bits;
    }

    /// <summary>The bundle that comes so many behind one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ContactBundle* At(ContactBundle* bundle, int steps)
    {
        nint place = PlaceOf(bundle) + steps;
        nint toRecord = ((nint)bundle & -Prefetch.LineBytes) + ((place / Beside) * Bytes);
        return (ContactBundle*)(toRecord + ((place % Beside) * BytesBeside));
    }

    /// <summary>The bundle behind one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ContactBundle* Next(ContactBundle* bundle) =>
        Beside == 1 || PlaceOf(bundle) == Beside - 1
            ? (ContactBundle*)((byte*)bundle + (Bytes - ((Beside - 1) * BytesBeside)))
            : (ContactBundle*)((byte*)bundle + BytesBeside);

    /// <summary>It is the first of its record.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsFirst(ContactBundle* bundle) => Beside == 1 || PlaceOf(bundle) == 0;

    /// <summary>Asks for all of the record of a bundle.</summary>
    public static void AskFor(ContactBundle* bundle)
    {
        for (int line = 0; line < Bytes; line += Prefetch.LineBytes)
        {
            Prefetch.Line((byte*)bundle + line);
        }
    }

    /// <summary>
    /// For walks that read a few columns of each bundle: asks for the same column some bundles on. They lie some thirty lines apart, which
    /// no processor foresees, and to wait for each was most of such a walk.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void AskAhead(void* column) => Prefetch.Line((ContactBundle*)column + Ahead);

    /// <summary>The place of a bundle in its record, which begins at a line.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static nint PlaceOf(ContactBundle* bundle) => (nint)(((nuint)bundle & (Prefetch.LineBytes - 1)) / BytesBeside);
}

/// <summary>One point of each contact of a bundle.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct ContactPointLanes
{
    private const int LineLanes = ContactBundle.LineLanes;

    public fixed float NormalArmA[LineLanes];
    public fixed float TangentArmA[LineLanes];
    public fixed float NormalArmB[LineLanes];
    public fixed float TangentArmB[LineLanes];

    /// <summary>Separation plus the depth of rest, less the arms: s' = s + rest by the formula of s.</summary>
    public fixed float Base[LineLanes];

    /// <summary>Impulses of the present substep (λn, λt) and of the one before, for the extrapolated warm start.</summary>
    public fixed float Normal[LineLanes];
    public fixed float Tangent[LineLanes];

    /// <summary>Feed-forward impulse φ.</summary>
    public fixed float Feed[LineLanes];

    public fixed float PreviousNormal[LineLanes];
    public fixed float PreviousTangent[LineLanes];
}
