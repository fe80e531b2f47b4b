using System;
using System.Numerics;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.NarrowPhase;

/// <summary>Heights of a hull's vertices along a direction, in double precision.</summary>
internal static unsafe class HullHeights
{
    /// <summary>
    /// The least of x·vx + y·vy over some vertices. Two at a time, without a branch: which one is the lowest cannot be foreseen.
    /// </summary>
    /// <param name="vertices">The vertices.</param>
    /// <param name="count">How many there are, at least one.</param>
    /// <param name="x">The direction.</param>
    /// <param name="y">Likewise.</param>
    public static double Lowest(Vector2* vertices, int count, double x, double y)
    {
#if NET8_0_OR_GREATER
        if (Avx.IsSupported && count > 1)
        {
            Vector256<double> direction = Vector256.Create(x, y, x, y);
            Vector128<double> least = Two(vertices, direction);
            for (int i = 2; i < count; i += 2)
            {
                // The last one of an odd number comes with the one before it once more.
                least = Sse2.Min(Two(vertices + Math.Min(i, count - 2), direction), least);
            }

            return Sse2.MinScalar(least, Sse2.UnpackHigh(least, least)).ToScalar();
        }
#endif
        double lowest = (x * vertices[0].X) + (y * vertices[0].Y);
        for (int i = 1; i < count; i++)
        {
            double h = (x * vertices[i].X) + (y * vertices[i].Y);
            lowest = h < lowest ? h : lowest;
        }

        return lowest;
    }

#if NET8_0_OR_GREATER
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<double> Two(Vector2* vertices, Vector256<double> direction)
    {
        Vector256<double> products = Avx.ConvertToVector256Double(Vector128.Load((float*)vertices)) * direction;
        return Sse3.HorizontalAdd(products.GetLower(), products.GetUpper());
    }
#endif
}
