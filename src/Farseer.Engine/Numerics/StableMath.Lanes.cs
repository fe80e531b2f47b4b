using System.Numerics;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Numerics;

internal static unsafe partial class StableMath
{
    /// <summary>Angles that <see cref="SinCos(double*, float*, float*)"/> takes at once.</summary>
    public const int Lanes = 4;

    /// <summary>Angles up to this are less than half a quadrant.</summary>
    private const double NoQuadrant = 0.785;

    /// <summary>
    /// Sines and cosines of four angles, rounded to float: to the last bit those of <see cref="SinCos(double, out double, out double)"/>,
    /// whose operations are repeated in its order, at a third of the time. The angles must be finite.
    /// </summary>
    public static void SinCos(double* angles, float* sin, float* cos)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            // One by one: a load of all four would wait until each has been stored.
            WideDouble angle = Vector256.Create(angles[0], angles[1], angles[2], angles[3]).AsVector();
            if (SinCosDirect(angle, out WideDouble s, out WideDouble c))
            {
                Avx.ConvertToVector128Single(s.AsVector256()).Store(sin);
                Avx.ConvertToVector128Single(c.AsVector256()).Store(cos);
                return;
            }
        }
#endif
        double* exact = stackalloc double[2 * Lanes];
        SinCos(angles[0], angles[1], angles[2], angles[3], exact, exact + Lanes);
        for (int i = 0; i < Lanes; i++)
        {
            sin[i] = (float)exact[i];
            cos[i] = (float)exact[i + Lanes];
        }
    }

    /// <summary>The same, not rounded; the angles may be any.</summary>
    public static void SinCos(double* angles, double* sin, double* cos)
    {
        int i = 0;
        for (; i < Lanes; i += WideDouble.Count)
        {
            if (!SinCosDirect(WideDouble.Load(angles + i), out WideDouble s, out WideDouble c))
            {
                break;
            }

            s.Store(sin + i);
            c.Store(cos + i);
        }

        for (; i < Lanes; i++)
        {
            SinCos(angles[i], out sin[i], out cos[i]);
        }
    }

    /// <summary>The same of four angles that are not in memory yet: a load of all of them would wait until each has been stored.</summary>
    public static void SinCos(double angle0, double angle1, double angle2, double angle3, double* sin, double* cos)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            if (SinCosDirect(Vector256.Create(angle0, angle1, angle2, angle3).AsVector(), out WideDouble s, out WideDouble c))
            {
                s.Store(sin);
                c.Store(cos);
                return;
            }
        }
        else
        {
            bool areDirect = SinCosDirect(Vector128.Create(angle0, angle1).AsVector(), out WideDouble s, out WideDouble c);
            s.Store(sin);
            c.Store(cos);
            areDirect &= SinCosDirect(Vector128.Create(angle2, angle3).AsVector(), out s, out c);
            s.Store(sin + 2);
            c.Store(cos + 2);
            if (areDirect)
            {
                return;
            }
        }
#endif
        SinCos(angle0, out sin[0], out cos[0]);
        SinCos(angle1, out sin[1], out cos[1]);
        SinCos(angle2, out sin[2], out cos[2]);
        SinCos(angle3, out sin[3], out cos[3]);
    }

    /// <returns>False if one of the angles is too large.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool SinCosDirect(WideDouble angle, out WideDouble sin, out WideDouble cos)
    {
        WideDouble size = WideDouble.Abs(angle);
        if (AreWithin(size, NoQuadrant))
        {
            SinCosNearZero(angle, out sin, out cos);
            return true;
        }

        SinCos(angle, out sin, out cos);
        return AreWithin(size, DirectLimit);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SinCos(WideDouble angle, out WideDouble sin, out WideDouble cos)
    {
        WideDouble rounding = WideDouble.Splat(RoundToWhole);
        WideDouble shifted = (angle * WideDouble.Splat(InverseHalfPi)) + rounding;
        WideDouble quadrants = shifted - rounding;
        WideDouble r = (angle - (quadrants * WideDouble.Splat(HalfPi1))) - (quadrants * WideDouble.Splat(HalfPi2));
        WideDouble small = quadrants * WideDouble.Splat(HalfPi3);
        WideDouble r3 = r - small;
        WideDouble lost = (r - r3) - small;
        WideDouble last = (quadrants * WideDouble.Splat(HalfPi4)) - lost;
        WideDouble x = r3 - last;
        WideDouble t = (r3 - x) - last;
        WideDouble one = WideDouble.One;
        WideDouble z = x * x;
        WideDouble half = WideDouble.Splat(0.5) * z;

        WideDouble p = Next(Next(Next(Next(Next(Next(WideDouble.Splat(S17), z, S15), z, S13), z, S11), z, S9), z, S7), z, S5);
        WideDouble s = x + ((z * x * (WideDouble.Splat(S3) + (z * p))) + (t * (one - half)));

        p = Next(Next(Next(Next(Next(Next(WideDouble.Splat(C16), z, C14), z, C12), z, C10), z, C8), z, C6), z, C4);
        WideDouble w = one - half;
        WideDouble c = w + (((one - w) - half) + ((z * z * p) - (t * x)));

        // Odd quadrants swap the two; the sign bits are those of the quadrant and of the next one.
        Quadrants(shifted, out WideDoubleMask odd, out WideDouble sinSign, out WideDouble cosSign);
        sin = WideDouble.Select(odd, c, s) ^ sinSign;
        cos = WideDouble.Select(odd, s, c) ^ cosSign;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AreWithin(WideDouble size, double limit) => Vector.LessThanOrEqualAll(size, new WideDouble(limit));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Quadrants(WideDouble shifted, out WideDoubleMask odd, out WideDouble sinSign, out WideDouble cosSign)
    {
        Vector<long> quadrant = Vector.AsVectorInt64(shifted);
        var two = new Vector<long>(2);
        var sign = new Vector<long>(long.MinValue);
        odd = Vector.Equals(quadrant & Vector<long>.One, Vector<long>.One);
        sinSign = Vector.AsVectorDouble(Vector.Equals(quadrant & two, two) & sign);
        cosSign = Vector.AsVectorDouble(Vector.Equals((quadrant + Vector<long>.One) & two, two) & sign);
    }

    /// <summary>The same bits for angles of the first quadrant, of which nothing is to be taken away and nothing left over.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SinCosNearZero(WideDouble x, out WideDouble sin, out WideDouble cos)
    {
        WideDouble one = WideDouble.One;
        WideDouble z = x * x;
        WideDouble half = WideDouble.Splat(0.5) * z;
        WideDouble p = Next(Next(Next(Next(Next(Next(WideDouble.Splat(S17), z, S15), z, S13), z, S11), z, S9), z, S7), z, S5);
        sin = x + (z * x * (WideDouble.Splat(S3) + (z * p)));
        p = Next(Next(Next(Next(Next(Next(WideDouble.Splat(C16), z, C14), z, C12), z, C10), z, C8), z, C6), z, C4);
        WideDouble w = one - half;
        cos = w + (((one - w) - half) + (z * z * p));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Next(WideDouble p, WideDouble z, double coefficient) => WideDouble.Splat(coefficient) + (z * p);
}
