using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>Bundles that lie behind each other, for a pass.</summary>
internal readonly unsafe struct BundleRun
{
    /// <summary>Records ahead for which memory is asked.</summary>
    private const int Ahead = 4;

    /// <summary>Records ahead whose bodies' states are asked for: their numbers have come by then.</summary>
    private const int StatesAhead = 2;

    /// <summary>Bytes from what is read of a row that is near to what is asked for: the record behind.</summary>
    private const int Near = ContactBundle.Bytes;

    /// <summary>Up to so many bundles a colour is of a world whose rows all stay near: ten boxes at rest would notice the asking.</summary>
    private const int Few = 64 / ContactBundle.Lanes;

    public readonly ContactBundle* Bundles;
    public readonly int Count;

    /// <summary>The run that comes next; of the last one itself.</summary>
    public readonly ContactBundle* Following;

    /// <summary>The rows come from memory: those ahead are to be asked for.</summary>
    public readonly bool IsFar;

    /// <summary>Bundles that a pass may take through its stages together: one if bundles may share bodies.</summary>
    public readonly int Stride;

    public BundleRun(ContactBundle* bundles, int count, ContactBundle* following, bool isFar, bool isSequential = false)
    {
        Bundles = bundles;
        Count = count;
        Following = following;
        IsFar = isFar;
        Stride = isSequential ? 1 : ContactWork.MostBundles;
    }

    /// <summary>Some of the bundles.</summary>
    public BundleRun Part(int first, int count) => new BundleRun(ContactBundle.At(Bundles, first), count, Following, IsFar, Stride == 1);

    /// <summary>
    /// What the warm start reads of a record: 34 lines of 44, 24 where contacts have one point. It reads the most for the least work, so it waits for what the
    /// second-level cache does not hold also where rows are near; no line that it does not read, and no loop. Behind the last bundle there may be nothing, so
    /// bytes are counted from the columns of this one.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AskForStart(ContactBundle* row, BodyState* bodies, bool two)
    {
        if (!Prefetch.IsUseful || !ContactBundle.IsFirst(row))
        {
            return;
        }

        if (IsFar)
        {
            long ahead = DistanceAhead(row);
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
            AskForStates(row, bodies);
        }
        else if (Count > Few)
        {
            EightLines((byte*)row->BodyA + Near);
            TwoLines((byte*)row->RadiusA + Near);
            EightLines((byte*)row->Point0.NormalArmA + Near);
            TwoLines((byte*)row->Point0.PreviousNormal + Near);
            if (two)
            {
                EightLines((byte*)row->Point1.NormalArmA + Near);
                TwoLines((byte*)row->Point1.PreviousNormal + Near);
            }

            TwoLines((byte*)row->K11 + Near);
            TwoLines((byte*)row->Friction + Near);
        }
    }

    /// <summary>Asks for what the biased pass reads ahead: 28 lines.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AskForBiased(ContactBundle* row, BodyState* bodies, bool two)
    {
        if (Prefetch.IsUseful && IsFar && ContactBundle.IsFirst(row))
        {
            long ahead = DistanceAhead(row);
            AskForBlock(row, ahead, two);
            AskForStates(row, bodies);
        }
    }

    /// <summary>Asks for what the relax pass reads ahead: 32 lines.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AskForRelaxed(ContactBundle* row, BodyState* bodies, bool two)
    {
        if (Prefetch.IsUseful && IsFar && ContactBundle.IsFirst(row))
        {
            long ahead = DistanceAhead(row);
            AskForBlock(row, ahead, two);
            Ask(row->RadiusA, ahead);
            Ask(row->FeedRate, ahead);
            AskForStates(row, bodies);
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

    /// <summary>Asks for the same column of another record and for the one behind it, by bytes: the address of a field would be that of a record which may not be there.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Ask(void* column, long ahead)
    {
        Prefetch.LineInBulk((byte*)column + ahead);
        Prefetch.LineInBulk((byte*)column + ahead + Prefetch.LineBytes);
    }

    /// <summary>Bytes to the bundle that is to be asked for.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private long DistanceAhead(ContactBundle* row)
    {
        ContactBundle* ahead = row + Ahead;
        long past = ahead - ContactBundle.At(Bundles, Count);
        ahead = past < 0 ? ahead : Following + past;
        return (byte*)ahead - (byte*)row;
    }

    /// <summary>The states of as many bodies are more than a second-level cache, and reached by their numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void AskForStates(ContactBundle* row, BodyState* bodies)
    {
        ContactBundle* ahead = row + StatesAhead;
        if (ahead < ContactBundle.At(Bundles, Count))
        {
            for (int lane = 0; lane < ContactBundle.LineLanes; lane++)
            {
                Prefetch.Line(bodies + ahead->BodyA[lane]);
                Prefetch.Line(bodies + ahead->BodyB[lane]);
            }
        }
    }
}
