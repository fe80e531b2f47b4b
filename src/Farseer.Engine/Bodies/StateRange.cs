using System;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Bodies;

/// <summary>
/// What a body's state may be: everything whose squares and their sums are finite floats. Beyond that a kernel would make
/// infinities of finite numbers, and of those, by the next difference, numbers that are none and spread over the contacts.
/// </summary>
internal static class StateRange
{
    /// <summary>2⁶³; NaN fails every comparison with it.</summary>
    public const float Limit = 9.223372e18f;

    /// <summary>2⁻⁶³: the least size of a shape; the squares of smaller lengths lose their digits.</summary>
    public const float Least = 1.0842022e-19f;

    /// <summary>The velocity; what is spare beside it may be anything.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Holds(in BodyState state)
    {
#if NET8_0_OR_GREATER
        Vector128<float> sizes =
            Vector128.LoadUnsafe(in state.LinearVelocity.X) & Vector128.Create(int.MaxValue, int.MaxValue, int.MaxValue, 0).AsSingle();
        return Vector128.LessThanOrEqualAll(sizes, Vector128.Create(Limit));
#else
        return Math.Abs(state.LinearVelocity.X) <= Limit & Math.Abs(state.LinearVelocity.Y) <= Limit
            & Math.Abs(state.AngularVelocity) <= Limit;
#endif
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Holds(double x, double y, double angle) =>
        Math.Abs(x) <= Limit & Math.Abs(y) <= Limit & Math.Abs(angle) <= Limit;

#if NET8_0_OR_GREATER
    /// <summary>A place, and an angle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Holds(Vector128<double> place, double angle) =>
        Vector128.LessThanOrEqualAll(Vector128.Abs(place), Vector128.Create((double)Limit)) & Math.Abs(angle) <= Limit;
#endif

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Holds(in BodyState state, in BodyPose pose)
    {
#if NET8_0_OR_GREATER
        return Holds(state) & Holds(Vector128.LoadUnsafe(in pose.X), pose.Angle);
#else
        return Holds(state) & Holds(pose.X, pose.Y, pose.Angle);
#endif
    }
}
