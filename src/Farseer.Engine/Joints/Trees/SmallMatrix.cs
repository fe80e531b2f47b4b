using System.Runtime.CompilerServices;

namespace Farseer.Engine.Joints.Trees;

/// <summary>Arithmetic on matrices of at most 3×3 doubles, row by row, in a fixed order of operations.</summary>
internal static unsafe class SmallMatrix
{
    /// <summary>Share of the product of the diagonal up to which too little of a determinant is left after its terms cancel.</summary>
    public const double Lost = 1e-10;

    /// <summary>r = s·y with s of n×3 and y of 3×3.</summary>
    public static void Multiply(double* s, int n, double* y, double* r)
    {
        double y0 = y[0];
        double y1 = y[1];
        double y2 = y[2];
        double y3 = y[3];
        double y4 = y[4];
        double y5 = y[5];
        double y6 = y[6];
        double y7 = y[7];
        double y8 = y[8];
        for (double* end = s + (n * 3); s < end; s += 3, r += 3)
        {
            double a = s[0];
            double b = s[1];
            double c = s[2];
            r[0] = (a * y0) + (b * y3) + (c * y6);
            r[1] = (a * y1) + (b * y4) + (c * y7);
            r[2] = (a * y2) + (b * y5) + (c * y8);
        }
    }

    /// <summary>r = p·qᵀ with p and q of n×3; r has rows of length n.</summary>
    public static void MultiplyTransposed(double* p, double* q, int n, double* r)
    {
        for (int i = 0; i < n; i++, p += 3)
        {
            double a = p[0];
            double b = p[1];
            double c = p[2];
            double* to = q;
            for (double* end = q + (n * 3); to < end; to += 3)
            {
                *r++ = (a * to[0]) + (b * to[1]) + (c * to[2]);
            }
        }
    }

    /// <summary>r = hᵗ·p with h of n×n, symmetric, and p of n×3.</summary>
    public static void MultiplySquare(double* h, int n, double* p, double* r)
    {
        for (int i = 0; i < n; i++, r += 3)
        {
            double a = 0;
            double b = 0;
            double c = 0;
            double* from = p;
            for (double* end = h + n; h < end; h++, from += 3)
            {
                double f = *h;
                a += f * from[0];
                b += f * from[1];
                c += f * from[2];
            }

            r[0] = a;
            r[1] = b;
            r[2] = c;
        }
    }

    /// <summary>y -= pᵀ·w with p and w of n×3.</summary>
    public static void SubtractOuter(double* y, double* p, double* w, int n)
    {
        for (double* last = y + 9; y < last; y += 3, p++)
        {
            double a = y[0];
            double b = y[1];
            double c = y[2];
            double* from = w;
            double* share = p;
            for (double* end = w + (n * 3); from < end; from += 3, share += 3)
            {
                double f = *share;
                a -= f * from[0];
                b -= f * from[1];
                c -= f * from[2];
            }

            y[0] = a;
            y[1] = b;
            y[2] = c;
        }
    }

    /// <summary>Of n×n.</summary>
    public static double Determinant(double* m, int n)
    {
        if (n == 3)
        {
            return (m[0] * ((m[4] * m[8]) - (m[5] * m[7]))) + (m[1] * ((m[5] * m[6]) - (m[3] * m[8])))
                + (m[2] * ((m[3] * m[7]) - (m[4] * m[6])));
        }

        return n == 2 ? (m[0] * m[3]) - (m[1] * m[2]) : n == 1 ? m[0] : 1;
    }

    /// <summary>The inverse of a symmetric positive matrix of n×n; 0 where it has none.</summary>
    public static void Invert(double* m, int n, double* r)
    {
        if (n == 1)
        {
            r[0] = m[0] > 0 ? 1 / m[0] : 0;
        }
        else if (n == 2)
        {
            InvertTwo(m[0], m[1], m[2], m[3], r);
        }
        else
        {
            double a = (m[4] * m[8]) - (m[5] * m[7]);
            double b = (m[5] * m[6]) - (m[3] * m[8]);
            double c = (m[3] * m[7]) - (m[4] * m[6]);
            double det = (m[0] * a) + (m[1] * b) + (m[2] * c);
            if (!(det > Lost * (m[0] * m[4] * m[8])))
            {
                InvertByPivots(m, r);
                return;
            }

            double f = det > 0 ? 1 / det : 0;
            r[0] = f * a;
            r[1] = f * b;
            r[2] = f * c;
            r[3] = r[1];
            r[4] = f * ((m[0] * m[8]) - (m[2] * m[6]));
            r[5] = f * ((m[2] * m[3]) - (m[0] * m[5]));
            r[6] = r[2];
            r[7] = r[5];
            r[8] = f * ((m[0] * m[4]) - (m[1] * m[3]));
        }
    }

    /// <summary>
    /// The inverse of a symmetric positive matrix of 2×2. Where a row has no response at all, as of an angle between two bodies that cannot
    /// turn, it gets no impulse, and the other row keeps what it answers alone.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void InvertTwo(double m00, double m01, double m10, double m11, double* r)
    {
        double det = (m00 * m11) - (m01 * m10);
        if (det > 0)
        {
            double f = 1 / det;
            r[0] = f * m11;
            r[1] = -f * m01;
            r[3] = f * m00;
        }
        else
        {
            double i0 = m00 > 0 ? 1 / m00 : 0;
            double l = m01 * i0;
            double d1 = m11 - (l * m01);
            double i1 = d1 > 0 ? 1 / d1 : 0;
            r[0] = i0 + (l * l * i1);
            r[1] = -(l * i1);
            r[3] = i1;
        }

        r[2] = r[1];
    }

    /// <summary>
    /// The inverse of 3×3 as L⁻ᵀ D⁻¹ L⁻¹. Of a block of which two directions have no more than 10⁻⁹ of a response the determinant is 10⁻¹⁸,
    /// less than the rounding of its own terms, but each pivot is known to a ten-millionth.
    /// </summary>
    private static void InvertByPivots(double* m, double* r)
    {
        double i0 = m[0] > 0 ? 1 / m[0] : 0;
        double l10 = m[3] * i0;
        double l20 = m[6] * i0;
        double d1 = m[4] - (l10 * m[3]);
        double i1 = d1 > 0 ? 1 / d1 : 0;
        double rest = m[7] - (l20 * m[3]);
        double l21 = rest * i1;
        double d2 = m[8] - (l20 * m[6]) - (l21 * rest);
        double i2 = d2 > 0 ? 1 / d2 : 0;
        double p = (l10 * l21) - l20;
        r[0] = i0 + (l10 * l10 * i1) + (p * p * i2);
        r[1] = -((l10 * i1) + (p * l21 * i2));
        r[2] = p * i2;
        r[3] = r[1];
        r[4] = i1 + (l21 * l21 * i2);
        r[5] = -(l21 * i2);
        r[6] = r[2];
        r[7] = r[5];
        r[8] = i2;
    }

    /// <summary>r = m·v with m of 3×3.</summary>
    public static void Apply(double* m, double x, double y, double w, double* r)
    {
        r[0] = (m[0] * x) + (m[1] * y) + (m[2] * w);
        r[1] = (m[3] * x) + (m[4] * y) + (m[5] * w);
        r[2] = (m[6] * x) + (m[7] * y) + (m[8] * w);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Dot(double* a, double* b) => (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);
}
