using System;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Mathematics;

/// <summary>Functions of angles, vectors and curves.</summary>
/// <remarks>
/// Angles are in radians; a positive angle turns the x axis towards the y axis. The functions of angles give the same bits on
/// every machine.
/// </remarks>
public static partial class Calculator
{
    /// <summary>Degrees in a radian, 180 / pi: multiply RADIANS by it to get degrees, whatever the name says.</summary>
    public const float DegreesToRadiansRatio = 57.29578f;

    /// <summary>Radians in a degree, pi / 180: multiply DEGREES by it to get radians, whatever the name says.</summary>
    public const float RadiansToDegreesRatio = 0.017453292f;

    /// <summary>The sine.</summary>
    /// <param name="angle">The angle, in radians.</param>
    /// <returns>-1 to 1; not a number unless the angle is finite.</returns>
    public static float Sin(float angle) => Require.IsFinite(angle) ? (float)StableTrigonometry.Sin(angle) : float.NaN;

    /// <summary>The cosine.</summary>
    /// <param name="angle">The angle, in radians.</param>
    /// <returns>-1 to 1; not a number unless the angle is finite.</returns>
    public static float Cos(float angle) => Require.IsFinite(angle) ? (float)StableTrigonometry.Cos(angle) : float.NaN;
}
