using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;

namespace Farseer.Engine.Joints.Trees;

/// <summary>A velocity in double, of which the store holds the rounding: the double stands as long as it does.</summary>
internal static unsafe class HeldVelocity
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Refresh(double held, float stored) => (float)held == stored ? held : stored;

    /// <summary>J·v at a body before the drive of the substep.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double StartSpeed(BodyStore bodies, int body, bool moves, double* held, int heldStride, double* j, int stride)
    {
        if (moves)
        {
            BodyMotion* motion = bodies.Motion.Pointer + body;
            return (j[0] * Refresh(held[0], motion->StartX))
                + (j[stride] * Refresh(held[heldStride], motion->StartY))
                + (j[2 * stride] * Refresh(held[2 * heldStride], motion->StartW));
        }

        BodyState* state = bodies.State.Pointer + body;
        return (j[0] * state->LinearVelocity.X) + (j[stride] * state->LinearVelocity.Y) + (j[2 * stride] * state->AngularVelocity);
    }

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
