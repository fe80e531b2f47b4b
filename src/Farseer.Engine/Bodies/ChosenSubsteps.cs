namespace Farseer.Engine.Bodies;

/// <summary>
/// The user's choice of how many times the step's substeps the island of a body takes: 0, left to the engine, or a power of two. Kept in
/// three bits of the body's flags, as the number of doublings plus 1.
/// </summary>
internal static class ChosenSubsteps
{
    /// <summary>The largest factor.</summary>
    public const int Most = 1 << MostDoublings;

    private const int MostDoublings = 4;
    private const int FirstBit = 16384;

    /// <summary>It can be chosen.</summary>
    public static bool IsChoice(int factor) => factor >= 0 && factor <= Most && (factor & (factor - 1)) == 0;

    public static BodyFlags Write(BodyFlags flags, int factor)
    {
        uint bits = 0;
        for (int left = factor; left > 0; left /= 2)
        {
            bits++;
        }

        return (flags & ~BodyFlags.Substeps) | (BodyFlags)(bits * FirstBit);
    }

    public static int Read(BodyFlags flags)
    {
        int bits = Bits(flags);
        return bits == 0 ? 0 : 1 << (bits - 1);
    }

    /// <summary>0: not chosen; else the doublings plus 1.</summary>
    public static int Bits(BodyFlags flags) => (int)((uint)(flags & BodyFlags.Substeps) / FirstBit);
}
