using System;
using System.Runtime.CompilerServices;

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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Holds(in BodyState state) =>
        Math.Abs(state.LinearVelocity.X) <= Limit & Math.Abs(state.LinearVelocity.Y) <= Limit & Math.Abs(state.AngularVelocity) <= Limit;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Holds(double x, double y, double angle) =>
        Math.Abs(x) <= Limit & Math.Abs(y) <= Limit & Math.Abs(angle) <= Limit;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Holds(in BodyState state, in BodyPose pose) => Holds(state) & Holds(pose.X, pose.Y, pose.Angle);
}
