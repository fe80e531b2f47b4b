using System.Runtime.CompilerServices;

namespace Farseer.Engine.Joints.Trees;

/// <summary>A velocity in double, of which the store holds the rounding: the double stands as long as it does.</summary>
internal static class HeldVelocity
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Refresh(double held, float stored) => (float)held == stored ? held : stored;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Kick(ref double held, ref float stored, double change)
    {
        held = Refresh(held, stored) + change;
        stored = (float)held;
    }

    /// <summary>
    /// Gravity and forces once more, on the double: rounded in each of many substeps, always to the same side, they would part bodies
    /// that fall together by as much as 1e-5 of their speed. What springs added since stays added.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Drive(ref double held, ref float stored, float before, float factor, float change)
    {
        if ((float)held == before)
        {
            float kept = before * factor;
            float rounded = kept + change;
            held = (held * factor) + change + ((double)stored - rounded);
            stored = (float)held;
        }
    }
}
