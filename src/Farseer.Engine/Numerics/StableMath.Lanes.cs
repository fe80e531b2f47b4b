#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Numerics;

internal static unsafe partial class StableMath
{
    /// <summary>Angles that <see cref="SinCos(double*, float*, float*)"/> takes at once.</summary>
    public const int Lanes = 4;

#if NET8_0_OR_GREATER
    /// <summary>Angles up to this are less than half a quadrant.</summary>
    private const double NoQuadrant = 0.785;
#endif

    /// <summary>
    /// Sines and cosines of four angles, rounded to float: to the last bit those of <see cref="SinCos(double, out double, out double)"/>,
    /// whose operations are repeated in its order, at a third of the time. The angles must be finite.
    /// </summary>
    public static void SinCos(double* angles, float* sin, float* cos)
    {
#if NET8_0_OR_GREATER
        if (Avx.IsSupported)
        {
            // One by one: a load of all four would wait until each has been stored.
            Vector256<double> angle = Vector256.Create(angles[0], angles[1], angles[2], angles[3]);
            if (SinCosDirect(angle, out Vector256<double> s, out Vector256<double> c))
            {
                Avx.ConvertToVector128Single(s).Store(sin);
                Avx.ConvertToVector128Single(c).Store(cos);
                return;
            }
        }
#endif
        for (int i = 0; i < Lanes; i++)
        {
            SinCos(angles[i], out double s, out double c);
            sin[i] = (float)s;
            cos[i] = (float)c;
        }
    }

    /// <summary>The same, not rounded; the angles may be any.</summary>
    public static void SinCos(double* angles, double* sin, double* cos)
    {
#if NET8_0_OR_GREATER
        if (Avx.IsSupported)
        {
            Vector256<double> angle = Vector256.Load(angles);
            if (SinCosDirect(angle, out Vector256<double> s, out Vector256<double> c))
            {
                s.Store(sin);
                c.Store(cos);
                return;
            }
        }
#endif
        for (int i = 0; i < Lanes; i++)
        {
            SinCos(angles[i], out sin[i], out cos[i]);
        }
    }

#if NET8_0_OR_GREATER
    /// <returns>False if one of the angles is too large.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool SinCosDirect(Vector256<double> angle, out Vector256<double> sin, out Vector256<double> cos)
    {
        Vector256<double> size = Vector256.Abs(angle);
        if (Vector256.LessThanOrEqualAll(size, Vector256.Create(NoQuadrant)))
        {
            SinCosNearZero(angle, out sin, out cos);
            return true;
        }

        SinCos(angle, out sin, out cos);
        return Vector256.LessThanOrEqualAll(size, Vector256.Create(DirectLimit));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SinCos(Vector256<double> angle, out Vector256<double> sin, out Vector256<double> cos)
    {
        Vector256<double> rounding = Vector256.Create(RoundToWhole);
        Vector256<double> shifted = (angle * Vector256.Create(InverseHalfPi)) + rounding;
        Vector256<double> quadrants = shifted - rounding;
        Vector256<double> r = (angle - (quadrants * Vector256.Create(HalfPi1))) - (quadrants * Vector256.Create(HalfPi2));
        Vector256<double> small = quadrants * Vector256.Create(HalfPi3);
        Vector256<double> r3 = r - small;
        Vector256<double> lost = (r - r3) - small;
        Vector256<double> last = (quadrants * Vector256.Create(HalfPi4)) - lost;
        Vector256<double> x = r3 - last;
        Vector256<double> t = (r3 - x) - last;
        Vector256<double> one = Vector256<double>.One;
        Vector256<double> z = x * x;
        Vector256<double> half = Vector256.Create(0.5) * z;

        Vector256<double> p = Next(Next(Next(Next(Next(Next(Vector256.Create(S17), z, S15), z, S13), z, S11), z, S9), z, S7), z, S5);
        Vector256<double> s = x + ((z * x * (Vector256.Create(S3) + (z * p))) + (t * (one - half)));

        p = Next(Next(Next(Next(Next(Next(Vector256.Create(C16), z, C14), z, C12), z, C10), z, C8), z, C6), z, C4);
        Vector256<double> w = one - half;
        Vector256<double> c = w + (((one - w) - half) + ((z * z * p) - (t * x)));

        // Odd quadrants swap the two; the sign bits are those of the quadrant and of the next one.
        Vector256<long> quadrant = shifted.AsInt64();
        Vector256<double> odd = (Vector256<long>.Zero - (quadrant & Vector256<long>.One)).AsDouble();
        Vector256<double> sinSign = ((quadrant & Vector256.Create(2L)) << 62).AsDouble();
        Vector256<double> cosSign = (((quadrant + Vector256<long>.One) & Vector256.Create(2L)) << 62).AsDouble();
        sin = Vector256.ConditionalSelect(odd, c, s) ^ sinSign;
        cos = Vector256.ConditionalSelect(odd, s, c) ^ cosSign;
    }

    /// <summary>The same bits for angles of the first quadrant, of which nothing is to be taken away and nothing left over.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SinCosNearZero(Vector256<double> x, out Vector256<double> sin, out Vector256<double> cos)
    {
        Vector256<double> one = Vector256<double>.One;
        Vector256<double> z = x * x;
        Vector256<double> half = Vector256.Create(0.5) * z;
        Vector256<double> p = Next(Next(Next(Next(Next(Next(Vector256.Create(S17), z, S15), z, S13), z, S11), z, S9), z, S7), z, S5);
        sin = x + (z * x * (Vector256.Create(S3) + (z * p)));
        p = Next(Next(Next(Next(Next(Next(Vector256.Create(C16), z, C14), z, C12), z, C10), z, C8), z, C6), z, C4);
        Vector256<double> w = one - half;
        cos = w + (((one - w) - half) + (z * z * p));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Next(Vector256<double> p, Vector256<double> z, double coefficient) => Vector256.Create(coefficient) + (z * p);
#endif
}
