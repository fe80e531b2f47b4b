using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// The bundles that a pass walks over, one by one: the rows of a colour lie in a dozen places of the arena, and a pass begun anew in each
/// of them left its stages half empty.
/// </summary>
internal readonly unsafe struct BundleList
{
    /// <summary>
    /// Places behind the last bundle that are read as well, to ask for what they tell: the bundles of the next colour, or the last one
    /// again.
    /// </summary>
    public const int PlacesBehind = Ahead * ContactBundle.Beside;

    /// <summary>Records ahead for which memory is asked.</summary>
    private const int Ahead = 4;

    /// <summary>Records ahead whose bodies' states are asked for: their numbers have come by then.</summary>
    private const int StatesAhead = 2;

    /// <summary>
    /// Passes on sixteen lanes ask for nothing: each record is a stream of 44 lines, which such processors foresee by themselves (measured:
    /// a Xeon with 2 MB of second-level cache), and asking for 34 of them kept busy what fetches lines. Since they do not, large_pyramid
    /// and many_pyramids take 0.97 of the time, 20,000 to 100,000 boxes 0.93 to 0.98. On eight lanes and processors with 512 KB,
    /// large_pyramid took 0.96 to 0.98 with asking.
    /// </summary>
    private static bool Asks => Prefetch.IsUseful && ContactBundle.Beside > 1;

    /// <summary>
    /// Up to so many bundles a colour are of a world whose rows all stay near: ten boxes at rest would notice the asking.
    /// </summary>
    private const int Few = 64 / ContactBundle.Lanes;

    /// <summary>Where they are, and <see cref="PlacesBehind"/> more.</summary>
    public readonly ContactBundle** Bundles;

    /// <summary>
    /// For each of them a bit for each lane whose contact does not push before this substep, which the warm start writes: to ask the rows
    /// for it took two more lines of each in the passes that follow.
    /// </summary>
    public readonly ushort* Fresh;
    public readonly int Count;

    /// <summary>The rows come from memory: those ahead are to be asked for.</summary>
    public readonly bool IsFar;

    /// <summary>Bundles that a pass may take through its stages together: one if bundles may share bodies.</summary>
    public readonly int Stride;

    public BundleList(ContactBundle** bundles, ushort* fresh, int count, bool isFar, bool isSequential = false)
    {
        Bundles = bundles;
        Fresh = fresh;
        Count = count;
        IsFar = isFar;
        Stride = isSequential ? 1 : ContactWork.MostBundles;
    }

    /// <summary>
    /// What the warm start reads of a record: 34 lines of 44, 24 where contacts have one point. It reads the most for the least work, so it
    /// waits for what the second-level cache does not hold also where rows are near; no line that it does not read, and no loop. Bytes are
    /// counted from the columns of this record, for to take the address of a field of another one reads that record, and waits.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AskForStart(ContactBundle** at, BodyState* bodies, bool two)
    {
        ContactBundle* row = *at;
        if (!Asks || !ContactBundle.IsFirst(row))
        {
            return;
        }

        if (IsFar)
        {
            long ahead = DistanceAhead(at);
            AskForMasses(row, ahead);
            Ask(row->RadiusA, ahead);
            AskForPoint(&row->Point0, ahead);
            Ask(row->Point0.PreviousNormal, ahead);
            if (two)
            {
                AskForPoint(&row->Point1, ahead);
                Ask(row->Point1.PreviousNormal, ahead);
            }

            Ask(row->K11, ahead);
            Ask(row->Friction, ahead);
            AskForStates(at, bodies);
        }
        else if (Count > Few)
        {
            long behind = (byte*)at[ContactBundle.Beside] - (byte*)row;
            EightLines((byte*)row->BodyA + behind);
            TwoLines((byte*)row->RadiusA + behind);
            EightLines((byte*)row->Point0.NormalArmA + behind);
            TwoLines((byte*)row->Point0.PreviousNormal + behind);
            if (two)
            {
                EightLines((byte*)row->Point1.NormalArmA + behind);
                TwoLines((byte*)row->Point1.PreviousNormal + behind);
            }

            TwoLines((byte*)row->K11 + behind);
            TwoLines((byte*)row->Friction + behind);
        }
    }

    /// <summary>Asks for what the biased pass reads ahead: 28 lines.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AskForBiased(ContactBundle** at, BodyState* bodies, bool two)
    {
        if (Asks && IsFar && ContactBundle.IsFirst(*at))
        {
            ContactBundle* row = *at;
            long ahead = DistanceAhead(at);
            AskForBlock(row, ahead, two);
            AskForStates(at, bodies);
        }
    }

    /// <summary>Asks for what the relax pass reads ahead: 32 lines.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AskForRelaxed(ContactBundle** at, BodyState* bodies, bool two)
    {
        if (Asks && IsFar && ContactBundle.IsFirst(*at))
        {
            ContactBundle* row = *at;
            long ahead = DistanceAhead(at);
            AskForBlock(row, ahead, two);
            Ask(row->RadiusA, ahead);
            Ask(row->FeedRate, ahead);
            AskForStates(at, bodies);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void TwoLines(byte* first)
    {
        Prefetch.Line(first);
        Prefetch.Line(first + Prefetch.LineBytes);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void EightLines(byte* first)
    {
        TwoLines(first);
        TwoLines(first + (2 * Prefetch.LineBytes));
        TwoLines(first + (4 * Prefetch.LineBytes));
        TwoLines(first + (6 * Prefetch.LineBytes));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AskForBlock(ContactBundle* row, long ahead, bool two)
    {
        AskForMasses(row, ahead);
        AskForPoint(&row->Point0, ahead);
        if (two)
        {
            AskForPoint(&row->Point1, ahead);
        }

        Ask(row->K11, ahead);
        Ask(row->Friction, ahead);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AskForMasses(ContactBundle* row, long ahead)
    {
        Ask(row->BodyA, ahead);
        Ask(row->NormalX, ahead);
        Ask(row->MassA, ahead);
        Ask(row->InertiaA, ahead);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AskForPoint(ContactPointLanes* point, long ahead)
    {
        Ask(point->NormalArmA, ahead);
        Ask(point->NormalArmB, ahead);
        Ask(point->Base, ahead);
        Ask(point->Tangent, ahead);
    }

    /// <summary>Asks for the same column of another record and for the one behind it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Ask(void* column, long ahead)
    {
        Prefetch.LineInBulk((byte*)column + ahead);
        Prefetch.LineInBulk((byte*)column + ahead + Prefetch.LineBytes);
    }

    /// <summary>Bytes to the record that is to be asked for.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static long DistanceAhead(ContactBundle** at) => (byte*)at[PlacesBehind] - (byte*)*at;

    /// <summary>The states of as many bodies are more than a second-level cache, and reached by their numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AskForStates(ContactBundle** at, BodyState* bodies)
    {
        ContactBundle* ahead = at[StatesAhead * ContactBundle.Beside];
        for (int lane = 0; lane < ContactBundle.LineLanes; lane++)
        {
            Prefetch.Line(bodies + ahead->BodyA[lane]);
            Prefetch.Line(bodies + ahead->BodyB[lane]);
        }
    }
}
