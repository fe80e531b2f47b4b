using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>Bundles that lie behind each other, for a pass.</summary>
internal readonly unsafe struct BundleRun
{
    /// <summary>Bundles ahead for which memory is asked.</summary>
    private const int Ahead = 3;

    /// <summary>The same for rows that are near.</summary>
    private const int Near = 2;

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
            byte* end = (byte*)ahead->Contact;
            for (byte* line = (byte*)ahead; line < end; line += Prefetch.LineBytes)
            {
                Prefetch.Line(line);
            }
        }
    }

    /// <summary>
    /// What the warm start reads of a bundle. It reads the most for the least work, so it waits for what the second-level cache does not hold also where
    /// rows are near; no line that it does not read, and no loop.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AskForStart(ContactBundle* row, bool two)
    {
        AskAhead(row);
        if (Prefetch.IsUseful && !IsFar)
        {
            row += Near;
            FourLines(row->BodyA);
            Prefetch.Line(row->RadiusA);
            FourLines(row->Point0.NormalArmA);
            Prefetch.Line(row->Point0.PreviousNormal);
            if (two)
            {
                FourLines(row->Point1.NormalArmA);
                Prefetch.Line(row->Point1.PreviousNormal);
            }

            Prefetch.Line(row->InverseK11);
            Prefetch.Line(row->Friction);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void FourLines(void* first)
    {
        var line = (byte*)first;
        Prefetch.Line(line);
        Prefetch.Line(line + Prefetch.LineBytes);
        Prefetch.Line(line + (2 * Prefetch.LineBytes));
        Prefetch.Line(line + (3 * Prefetch.LineBytes));
    }
}
