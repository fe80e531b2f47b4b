using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>Bundles that lie behind each other, for a pass.</summary>
internal readonly unsafe struct BundleRun
{
    /// <summary>Bundles ahead for which memory is asked.</summary>
    private const int Ahead = 3;

    /// <summary>Bytes from what is read of a row that is near to what is asked for: the bundle after next.</summary>
    private const int Near = 2 * ContactBundle.Bytes;

    /// <summary>Up to so many bundles a colour is of a world whose rows all stay near: ten boxes at rest would notice the asking.</summary>
    private const int Few = 8;

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

    /// <summary>
    /// Rows of a large world come from memory, and their lines are not read in order, which the processor's own foresight needs. Rows that
    /// are near lose by it (a pyramid of 100: a fifth of the solver's time).
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AskAhead(ContactBundle* row)
    {
        if (Prefetch.IsUseful && IsFar)
        {
            ContactBundle* ahead = row + Ahead;
            long past = ahead - (Bundles + Count);
            ahead = past < 0 ? ahead : Following + past;
            for (int line = 0; line < ContactBundle.SolvedBytes; line += Prefetch.LineBytes)
            {
                Prefetch.Line((byte*)ahead + line);
            }
        }
    }

    /// <summary>
    /// What the warm start reads of a bundle. It reads the most for the least work, so it waits for what the second-level cache does not hold also where
    /// rows are near; no line that it does not read, and no loop. Behind the last bundle there may be nothing, so bytes are counted from the columns of this one.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AskForStart(ContactBundle* row, bool two)
    {
        AskAhead(row);
        if (Prefetch.IsUseful && !IsFar && Count > Few)
        {
            FourLines((byte*)row->BodyA + Near);
            Prefetch.Line((byte*)row->RadiusA + Near);
            FourLines((byte*)row->Point0.NormalArmA + Near);
            Prefetch.Line((byte*)row->Point0.PreviousNormal + Near);
            if (two)
            {
                FourLines((byte*)row->Point1.NormalArmA + Near);
                Prefetch.Line((byte*)row->Point1.PreviousNormal + Near);
            }

            Prefetch.Line((byte*)row->InverseK11 + Near);
            Prefetch.Line((byte*)row->Friction + Near);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void FourLines(byte* first)
    {
        Prefetch.Line(first);
        Prefetch.Line(first + Prefetch.LineBytes);
        Prefetch.Line(first + (2 * Prefetch.LineBytes));
        Prefetch.Line(first + (3 * Prefetch.LineBytes));
    }
}
