using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>Bundles that lie behind each other, for a pass.</summary>
internal readonly unsafe struct BundleRun
{
    /// <summary>Bundles ahead for which memory is asked.</summary>
    private const int Ahead = 3;

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
}
