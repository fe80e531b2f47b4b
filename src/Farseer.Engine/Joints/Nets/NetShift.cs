using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// Which part of an error of a net's joint is no motion: it was there when the joint came or its body was put elsewhere, or a longer
/// substep left it. Such errors contradict each other. As speeds, which one sweep does not take back, they gave a net of 30 bodies
/// 60 times its energy in one step, and made bodies that collide whirl until they were thrown off. They go by displacements.
/// </summary>
internal static class NetShift
{
    /// <summary>What is left of a displaced error, in terms of the joint's size, that counts as motion again: rounding.</summary>
    private const float Rest = 1e-6f;

    /// <summary>A substep shorter than this share of the last one makes errors of the last ones from outside.</summary>
    private const double Shorter = 0.5;

    /// <summary>
    /// Share of the errors of a step that are those of the next, whose substep is <paramref name="ratio"/> times as long: what loads make a
    /// soft row sag goes by the square. At its full size it would be closed at a speed larger by the inverse of the ratio.
    /// </summary>
    public static float Keep(double ratio) => ratio > 0 && ratio < Shorter ? (float)(ratio * ratio) : 1;

    /// <summary>By how much what came from outside has grown when a step begins.</summary>
    /// <param name="last">Error of motion at the end of the last step; 0 in a new row.</param>
    /// <param name="now">The error now, less what was known to come from outside.</param>
    /// <param name="outside">That.</param>
    /// <param name="size">Size of the joint.</param>
    /// <param name="keep">See <see cref="Keep"/>.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Of(Wide last, Wide now, Wide outside, Wide size, float keep)
    {
        Wide jump = now - last;
        jump = Wide.Select(Wide.Abs(jump) > Wide.Splat((float)TreeRows.Small) * size, jump, Wide.Zero);
        Wide shift = jump + (Wide.Splat(1 - keep) * (now - jump));
        return Wide.Select(Wide.Abs(outside + shift) > Wide.Splat(Rest) * size, shift, Wide.Zero - outside);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsDisturbed(Wide outside) => WideLanes.Any(Wide.Abs(outside) > Wide.Zero);
}
