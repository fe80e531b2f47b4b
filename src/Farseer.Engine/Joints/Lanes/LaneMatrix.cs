using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// <see cref="SmallMatrix"/> for lanes, to the last bit. What always has two rows is written out where it is needed.
/// </summary>
internal static unsafe class LaneMatrix
{
    /// <summary>From an element to the next, and from a row of three to the next.</summary>
    public const int Step = DoubleLanes.BundleLanes;
    public const int Row = 3 * DoubleLanes.BundleLanes;

    /// <summary>s·y of a row.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Multiply(double* s, double* y, out WideDouble r0, out WideDouble r1, out WideDouble r2)
    {
        WideDouble a = WideDouble.Load(s);
        WideDouble b = WideDouble.Load(s + 4);
        WideDouble c = WideDouble.Load(s + 8);
        r0 = (a * WideDouble.Load(y)) + (b * WideDouble.Load(y + 12)) + (c * WideDouble.Load(y + 24));
        r1 = (a * WideDouble.Load(y + 4)) + (b * WideDouble.Load(y + 16)) + (c * WideDouble.Load(y + 28));
        r2 = (a * WideDouble.Load(y + 8)) + (b * WideDouble.Load(y + 20)) + (c * WideDouble.Load(y + 32));
    }

    /// <summary>r = s·y of n rows.</summary>
    public static void Multiply(double* s, int n, double* y, double* r)
    {
        for (int i = 0; i < n * Row; i += Row)
        {
            Multiply(s + i, y, out WideDouble r0, out WideDouble r1, out WideDouble r2);
            r0.Store(r + i);
            r1.Store(r + i + 4);
            r2.Store(r + i + 8);
        }
    }

    /// <summary>r = p·qᵀ with p and q of n×3; r has rows of length n.</summary>
    public static void MultiplyTransposed(double* p, double* q, int n, double* r)
    {
        for (int i = 0; i < n; i++)
        {
            WideDouble x = WideDouble.Load(p + (i * Row));
            WideDouble y = WideDouble.Load(p + (i * Row) + 4);
            WideDouble w = WideDouble.Load(p + (i * Row) + 8);
            for (int j = 0; j < n; j++)
            {
                Dot(x, y, w, q + (j * Row)).Store(r + (((i * n) + j) * Step));
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDouble Dot(WideDouble x, WideDouble y, WideDouble w, double* s) =>
        (x * WideDouble.Load(s)) + (y * WideDouble.Load(s + 4)) + (w * WideDouble.Load(s + 8));

    /// <summary>r = h·p with h of n×n and p of n×3.</summary>
    public static void MultiplySquare(double* h, int n, double* p, double* r)
    {
        for (int i = 0; i < n; i++)
        {
            for (int c = 0; c < Row; c += Step)
            {
                // Zero first, as a sum starts: of a product that is -0 it makes 0.
                WideDouble sum = WideDouble.Zero;
                for (int k = 0; k < n; k++)
                {
                    sum += WideDouble.Load(h + (((i * n) + k) * Step)) * WideDouble.Load(p + (k * Row) + c);
                }

                sum.Store(r + (i * Row) + c);
            }
        }
    }

    /// <summary>y -= pᵀ·w with p and w of n×3.</summary>
    public static void SubtractOuter(double* y, double* p, double* w, int n)
    {
        for (int i = 0; i < 3; i++)
        {
            for (int c = 0; c < 3; c++)
            {
                double* at = y + (((i * 3) + c) * Step);
                WideDouble rest = WideDouble.Load(at);
                for (int k = 0; k < n; k++)
                {
                    rest -= WideDouble.Load(p + (k * Row) + (i * Step)) * WideDouble.Load(w + (k * Row) + (c * Step));
                }

                rest.Store(at);
            }
        }
    }

    /// <summary>Of n×n.</summary>
    public static WideDouble Determinant(double* m, int n)
    {
        if (n == 1)
        {
            return At(m, 0);
        }

        if (n == 2)
        {
            return (At(m, 0) * At(m, 3)) - (At(m, 1) * At(m, 2));
        }

        return (At(m, 0) * ((At(m, 4) * At(m, 8)) - (At(m, 5) * At(m, 7)))) + (At(m, 1) * ((At(m, 5) * At(m, 6)) - (At(m, 3) * At(m, 8))))
            + (At(m, 2) * ((At(m, 3) * At(m, 7)) - (At(m, 4) * At(m, 6))));
    }

    /// <summary>The inverse of a symmetric positive matrix of n×n; 0 where it has none.</summary>
    public static void Invert(double* m, int n, double* r)
    {
        if (n == 1)
        {
            Inverse(At(m, 0)).Store(r);
            return;
        }

        if (n == 2)
        {
            InvertTwo(At(m, 0), At(m, 1), At(m, 2), At(m, 3), out WideDouble r00, out WideDouble r01, out WideDouble r11);
            r00.Store(r);
            r01.Store(r + 4);
            r01.Store(r + 8);
            r11.Store(r + 12);
            return;
        }

        WideDouble a = (At(m, 4) * At(m, 8)) - (At(m, 5) * At(m, 7));
        WideDouble b = (At(m, 5) * At(m, 6)) - (At(m, 3) * At(m, 8));
        WideDouble c = (At(m, 3) * At(m, 7)) - (At(m, 4) * At(m, 6));
        WideDouble det = (At(m, 0) * a) + (At(m, 1) * b) + (At(m, 2) * c);
        WideDoubleMask lost = ~(det > WideDouble.Splat(SmallMatrix.Lost) * (At(m, 0) * At(m, 4) * At(m, 8)));
        WideDouble f = Inverse(det);
        WideDouble r4 = f * ((At(m, 0) * At(m, 8)) - (At(m, 2) * At(m, 6)));
        WideDouble r5 = f * ((At(m, 2) * At(m, 3)) - (At(m, 0) * At(m, 5)));
        WideDouble r8 = f * ((At(m, 0) * At(m, 4)) - (At(m, 1) * At(m, 3)));
        (f * a).Store(r);
        (f * b).Store(r + 4);
        (f * c).Store(r + 8);
        (f * b).Store(r + 12);
        r4.Store(r + 16);
        r5.Store(r + 20);
        (f * c).Store(r + 24);
        r5.Store(r + 28);
        r8.Store(r + 32);
        if (DoubleLanes.Bits(lost) != 0)
        {
            InvertByPivots(m, r, lost);
        }
    }

    /// <summary>See <see cref="SmallMatrix.InvertTwo"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void InvertTwo(
        WideDouble m00, WideDouble m01, WideDouble m10, WideDouble m11, out WideDouble r00, out WideDouble r01, out WideDouble r11)
    {
        WideDouble det = (m00 * m11) - (m01 * m10);
        WideDouble f = Inverse(det);
        r00 = f * m11;
        r01 = WideDouble.Negate(f) * m01;
        r11 = f * m00;
        WideDoubleMask dead = ~(det > WideDouble.Zero);
        if (DoubleLanes.Bits(dead) != 0)
        {
            WideDouble i0 = Inverse(m00);
            WideDouble l = m01 * i0;
            WideDouble i1 = Inverse(m11 - (l * m01));
            r00 = WideDouble.Select(dead, i0 + (l * l * i1), r00);
            r01 = WideDouble.Select(dead, WideDouble.Negate(l * i1), r01);
            r11 = WideDouble.Select(dead, i1, r11);
        }
    }

    private static void InvertByPivots(double* m, double* r, WideDoubleMask lost)
    {
        WideDouble i0 = Inverse(At(m, 0));
        WideDouble l10 = At(m, 3) * i0;
        WideDouble l20 = At(m, 6) * i0;
        WideDouble i1 = Inverse(At(m, 4) - (l10 * At(m, 3)));
        WideDouble rest = At(m, 7) - (l20 * At(m, 3));
        WideDouble l21 = rest * i1;
        WideDouble i2 = Inverse(At(m, 8) - (l20 * At(m, 6)) - (l21 * rest));
        WideDouble p = (l10 * l21) - l20;
        Put(r, 0, lost, i0 + (l10 * l10 * i1) + (p * p * i2));
        WideDouble off = WideDouble.Negate((l10 * i1) + (p * l21 * i2));
        Put(r, 1, lost, off);
        Put(r, 3, lost, off);
        Put(r, 2, lost, p * i2);
        Put(r, 6, lost, p * i2);
        Put(r, 4, lost, i1 + (l21 * l21 * i2));
        off = WideDouble.Negate(l21 * i2);
        Put(r, 5, lost, off);
        Put(r, 7, lost, off);
        Put(r, 8, lost, i2);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Put(double* r, int element, WideDoubleMask where, WideDouble value)
    {
        double* at = r + (element * Step);
        WideDouble.Select(where, value, WideDouble.Load(at)).Store(at);
    }

    /// <summary>One over a determinant; 0 where it is not positive.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDouble Inverse(WideDouble determinant) =>
        WideDouble.Select(determinant > WideDouble.Zero, WideDouble.Splat(1) / determinant, WideDouble.Zero);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble At(double* m, int element) => WideDouble.Load(m + (element * Step));
}
