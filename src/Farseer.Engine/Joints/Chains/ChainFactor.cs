using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Chains;

/// <summary>
/// Elimination along a chain. The responses K of its joints to each other's impulses make a matrix of 2×2 blocks, A of a joint to itself
/// and B to the one before it, which is positive, since what hangs at one anchor at most can always give way. It is eliminated from both
/// ends at once, D' = A' - B D⁻¹ Bᵀ, towards the joint in the middle: two sequences of operations of which each waits for the one before,
/// side by side.
/// </summary>
internal static unsafe class ChainFactor
{
    /// <summary>Writes the responses at the arms of the rows, for all joints side by side, and factors them.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Run(in ChainView chain)
    {
        Respond(chain);
        Eliminate(chain);
    }

    [MethodImpl(KernelMethod.Optimized)]
    private static void Respond(in ChainView chain)
    {
        int s = chain.Stride;
        double* mass = chain[ChainColumn.InverseMass];
        double* inertia = chain[ChainColumn.InverseInertia];
        double* low = chain[chain.Arms];
        double* high = low + (2 * s);
        double* size = chain[ChainColumn.Size];
        double* own = chain[ChainColumn.Own];
        double* cross = chain[ChainColumn.Cross];
        for (int i = 0; i < chain.Joints; i += WideDouble.Count)
        {
            WideDouble im = WideDouble.Load(mass + i);
            WideDouble ii = WideDouble.Load(inertia + i);
            WideDouble highInertia = WideDouble.Load(inertia + i + 1);
            WideDouble ax = WideDouble.Load(low + i);
            WideDouble ay = WideDouble.Load(low + s + i);
            WideDouble bx = WideDouble.Load(high + i);
            WideDouble by = WideDouble.Load(high + s + i);
            WideDouble length = WideDouble.Sqrt((ax * ax) + (ay * ay)) + WideDouble.Sqrt((bx * bx) + (by * by));
            length.Store(size + i);
            WideDouble.Select(length > WideDouble.Zero, WideDouble.Splat(1) / length, WideDouble.Zero).Store(size + s + i);

            WideDouble both = im + WideDouble.Load(mass + i + 1);
            WideDouble tx = ii * ax;
            WideDouble ty = ii * ay;
            WideDouble ux = highInertia * bx;
            WideDouble uy = highInertia * by;
            (both + (ty * ay) + (uy * by)).Store(own + i);
            WideDouble.Negate((tx * ay) + (ux * by)).Store(own + s + i);
            (both + (tx * ax) + (ux * bx)).Store(own + (2 * s) + i);

            WideDouble cx = WideDouble.Load(high + i - 1);
            WideDouble cy = WideDouble.Load(high + s + i - 1);
            WideDouble.Negate(im + (ty * cy)).Store(cross + i);
            (ty * cx).Store(cross + s + i);
            (tx * cy).Store(cross + (2 * s) + i);
            WideDouble.Negate(im + (tx * cx)).Store(cross + (3 * s) + i);
        }
    }

    [MethodImpl(KernelMethod.Optimized)]
    private static void Eliminate(in ChainView chain)
    {
        nint s = chain.Stride;
        nint s2 = 2 * s;
        int middle = chain.Middle;
        int i = 0;
        int k = chain.Joints - 1;
        double* own = chain[ChainColumn.Own];
        double* cross = chain[ChainColumn.Cross];
        double* inverse = chain[ChainColumn.Inverse];
        double* gain = chain[ChainColumn.Gain];
        Symmetric up = Symmetric.Load(own, s, s2);
        Symmetric down = Symmetric.Load(own + k, s, s2);
        bool meets = k > middle;
        for (; k > middle && i < middle; i++, k--)
        {
            up = Symmetric.Load(own + i + 1, s, s2) - Next(up, Square.Load(cross + i + 1, s, s2), inverse + i, gain + i + 1, s, s2);
            down = Symmetric.Load(own + k - 1, s, s2) - Next(down, Square.LoadTransposed(cross + k, s, s2), inverse + k, gain + k, s, s2);
        }

        for (; i < middle; i++)
        {
            up = Symmetric.Load(own + i + 1, s, s2) - Next(up, Square.Load(cross + i + 1, s, s2), inverse + i, gain + i + 1, s, s2);
        }

        for (; k > middle; k--)
        {
            down = Symmetric.Load(own + k - 1, s, s2) - Next(down, Square.LoadTransposed(cross + k, s, s2), inverse + k, gain + k, s, s2);
        }

        if (meets)
        {
            // Both began with the middle's own response.
            up = up - (Symmetric.Load(own + middle, s, s2) - down);
        }

        double f = Inverse((up.XX * up.YY) - (up.XY * up.XY));
        inverse[middle] = f * up.YY;
        inverse[middle + s] = -f * up.XY;
        inverse[middle + s2] = f * up.XX;
    }

    /// <summary>
    /// No block is singular by itself: with an anchor at both ends the last of a taut chain is, since there the far end has nothing left to
    /// give. The general passes make such blocks regular.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool IsRegular(in ChainView chain)
    {
        int s = chain.Stride;
        double* own = chain[ChainColumn.Own];
        double* inverse = chain[ChainColumn.Inverse];
        long* exists = (long*)chain[ChainColumn.Exists];
        WideDouble singular = WideDouble.Splat(TreeFactor.Singular);
        WideDoubleMask bad = ~(WideDouble.Zero <= WideDouble.Zero);
        for (int i = 0; i < chain.Joints; i += WideDouble.Count)
        {
            WideDouble xy = WideDouble.Load(inverse + s + i);
            WideDouble determinant = (WideDouble.Load(inverse + i) * WideDouble.Load(inverse + (2 * s) + i)) - (xy * xy);
            WideDouble share = singular * (WideDouble.Load(own + i) * WideDouble.Load(own + (2 * s) + i) * determinant);
            bad |= WideDouble.LoadMask(exists + i) & ~((share < WideDouble.Splat(1)) & (determinant > WideDouble.Zero));
        }

        return DoubleLanes.Bits(bad) == 0;
    }

    /// <summary>
    /// D⁻¹ and B·D⁻¹ to their columns; what B·D⁻¹·Bᵀ takes from the next block. Only the quotient waits for the determinant.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Symmetric Next(Symmetric d, Square b, double* inverse, double* gain, nint s, nint s2)
    {
        double f = Inverse((d.XX * d.YY) - (d.XY * d.XY));
        double xx = (b.XX * d.YY) - (b.XY * d.XY);
        double xy = (b.XY * d.XX) - (b.XX * d.XY);
        double yx = (b.YX * d.YY) - (b.YY * d.XY);
        double yy = (b.YY * d.XX) - (b.YX * d.XY);
        Symmetric taken;
        taken.XX = f * ((xx * b.XX) + (xy * b.XY));
        taken.XY = f * ((xx * b.YX) + (xy * b.YY));
        taken.YY = f * ((yx * b.YX) + (yy * b.YY));
        inverse[0] = f * d.YY;
        inverse[s] = -f * d.XY;
        inverse[s2] = f * d.XX;
        gain[0] = f * xx;
        gain[s] = f * xy;
        gain[s2] = f * yx;
        gain[s2 + s] = f * yy;
        return taken;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Inverse(double determinant) => determinant > 0 ? 1 / determinant : 0;

    private struct Symmetric
    {
        public double XX;
        public double XY;
        public double YY;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Symmetric Load(double* from, nint s, nint s2)
        {
            Symmetric result;
            result.XX = from[0];
            result.XY = from[s];
            result.YY = from[s2];
            return result;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Symmetric operator -(Symmetric a, Symmetric b)
        {
            a.XX -= b.XX;
            a.XY -= b.XY;
            a.YY -= b.YY;
            return a;
        }
    }

    private struct Square
    {
        public double XX;
        public double XY;
        public double YX;
        public double YY;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Square Load(double* from, nint s, nint s2)
        {
            Square result;
            result.XX = from[0];
            result.XY = from[s];
            result.YX = from[s2];
            result.YY = from[s2 + s];
            return result;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Square LoadTransposed(double* from, nint s, nint s2)
        {
            Square result = Load(from, s, s2);
            (result.XY, result.YX) = (result.YX, result.XY);
            return result;
        }
    }
}
