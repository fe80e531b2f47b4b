using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Chains;

/// <summary>The impulses with which a chain's joints meet what their rows lack, and what these do to its bodies.</summary>
internal static unsafe class ChainSolve
{
    /// <summary>What the rows lack at the present velocities: to take the errors away within the substep.</summary>
    /// <returns>True if an error was put there from outside.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool LackBiased(in ChainView chain, double perSubstep)
    {
        int s = chain.Stride;
        double* error = chain[ChainColumn.Error];
        double* residual = chain[ChainColumn.Residual];
        double* size = chain[ChainColumn.Size];
        WideDouble rate = WideDouble.Splat(perSubstep);
        WideDoubleMask large = ~(WideDouble.Zero <= WideDouble.Zero);
        for (int i = 0; i < chain.Joints; i += WideDouble.Count)
        {
            WideDouble x = WideDouble.Load(error + i);
            WideDouble y = WideDouble.Load(error + s + i);
            WideDouble most = WideDouble.Splat(TreeRows.Small) * WideDouble.Load(size + i);
            large |= ~(WideDouble.Abs(x) <= most) | ~(WideDouble.Abs(y) <= most);
            Speed(chain, i, out WideDouble vx, out WideDouble vy);
            (WideDouble.Negate(x * rate) - vx).Store(residual + i);
            (WideDouble.Negate(y * rate) - vy).Store(residual + s + i);
        }

        return DoubleLanes.Bits(large) != 0;
    }

    /// <summary>What the rows lack at the present velocities: to stand still.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void LackRelaxed(in ChainView chain)
    {
        int s = chain.Stride;
        double* residual = chain[ChainColumn.Residual];
        for (int i = 0; i < chain.Joints; i += WideDouble.Count)
        {
            Speed(chain, i, out WideDouble vx, out WideDouble vy);
            WideDouble.Negate(vx).Store(residual + i);
            WideDouble.Negate(vy).Store(residual + s + i);
        }
    }

    /// <summary>What is foreseen to be left by the bend of the ways.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void LackBends(in ChainView chain, double h)
    {
        int s = chain.Stride;
        double* foreseen = chain[ChainColumn.Foreseen];
        double* residual = chain[ChainColumn.Residual];
        WideDouble time = WideDouble.Splat(h);
        for (int i = 0; i < chain.Joints; i += WideDouble.Count)
        {
            (WideDouble.Load(residual + i) - (time * WideDouble.Load(foreseen + i))).Store(residual + i);
            (WideDouble.Load(residual + s + i) - (time * WideDouble.Load(foreseen + s + i))).Store(residual + s + i);
        }
    }

    /// <summary>Notes the bends and foresees the next: see <see cref="JointSolver"/>.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Foresee(in ChainView chain, double h)
    {
        int s = chain.Stride;
        double* error = chain[ChainColumn.Error];
        double* last = chain[ChainColumn.Bend];
        double* next = chain[ChainColumn.Foreseen];
        WideDouble perSquare = WideDouble.Splat(1 / (h * h));
        WideDouble alike = WideDouble.Splat(TreePositions.AlikeInChains);
        for (int i = 0; i < chain.Joints; i += WideDouble.Count)
        {
            WideDouble x = (WideDouble.Load(error + i) * perSquare) + WideDouble.Load(next + i);
            WideDouble y = (WideDouble.Load(error + s + i) * perSquare) + WideDouble.Load(next + s + i);
            WideDouble changeX = x - WideDouble.Load(last + i);
            WideDouble changeY = y - WideDouble.Load(last + s + i);
            x.Store(last + i);
            y.Store(last + s + i);
            WideDouble most = ChainPoses.Larger(WideDouble.Abs(x), WideDouble.Abs(y));
            WideDoubleMask carries = ChainPoses.Larger(WideDouble.Abs(changeX), WideDouble.Abs(changeY)) <= alike * most;
            WideDouble.Select(carries, x + changeX, WideDouble.Zero).Store(next + i);
            WideDouble.Select(carries, y + changeY, WideDouble.Zero).Store(next + s + i);
        }
    }

    /// <summary>The velocity changes that take the errors away within the substep.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void LackErrors(in ChainView chain, double perSubstep)
    {
        int s = chain.Stride;
        double* error = chain[ChainColumn.Error];
        double* residual = chain[ChainColumn.Residual];
        WideDouble rate = WideDouble.Splat(-perSubstep);
        for (int i = 0; i < chain.Joints; i += WideDouble.Count)
        {
            (rate * WideDouble.Load(error + i)).Store(residual + i);
            (rate * WideDouble.Load(error + s + i)).Store(residual + s + i);
        }
    }

    /// <summary>Finds the impulses: see <see cref="ChainFactor"/>.</summary>
    public static void Run(in ChainView chain)
    {
        ChainEnds none = default;
        RunWithin(chain, 0, chain.Joints - 1, none);
    }

    /// <summary>The same of the joints from one to another, with what the ends beyond them have come to.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void RunWithin(in ChainView chain, int first, int last, in ChainEnds ends)
    {
        nint s = chain.Stride;
        nint s2 = 2 * s;
        nint s3 = 3 * s;
        int middle = chain.Middle;
        double* residual = chain[ChainColumn.Residual];
        double* half = chain[ChainColumn.Half];
        double* inverse = chain[ChainColumn.Inverse];
        double* gain = chain[ChainColumn.Gain];
        double* lambda = chain[ChainColumn.Lambda];
        double ux = ends.LowX;
        double uy = ends.LowY;
        double dx = ends.HighX;
        double dy = ends.HighY;
        int i = first;
        for (int k = last; i < middle || k > middle; i++, k--)
        {
            if (i < middle)
            {
                Reduce(residual + i, gain + i, half + i, inverse + i, s, s2, s3, ref ux, ref uy);
            }

            if (k > middle)
            {
                Reduce(residual + k, gain + k + 1, half + k, inverse + k, s, s2, s3, ref dx, ref dy);
            }
        }

        double* g = gain + middle + 1;
        double* e = inverse + middle;
        double x = residual[middle] - ((g[0] * dx) + (g[s] * dy));
        double y = residual[middle + s] - ((g[s2] * dx) + (g[s3] * dy));
        g--;
        x -= (g[0] * ux) + (g[s] * uy);
        y -= (g[s2] * ux) + (g[s3] * uy);
        ux = (e[0] * x) + (e[s] * y);
        uy = (e[s] * x) + (e[s2] * y);
        lambda[middle] = ux;
        lambda[middle + s] = uy;
        dx = ux;
        dy = uy;
        i = middle - 1;
        for (int k = middle + 1; i >= first || k <= last; i--, k++)
        {
            if (i >= first)
            {
                Resolve(lambda + i, gain + i + 1, half + i, s, s2, s3, ref ux, ref uy);
            }

            if (k <= last)
            {
                Resolve(lambda + k, gain + k, half + k, s, s2, s3, ref dx, ref dy);
            }
        }
    }

    /// <summary>Goes from both ends up to the joints that <see cref="ChainView.FirstWithin"/> and its like name.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Gather(in ChainView chain, out ChainEnds ends)
    {
        nint s = chain.Stride;
        nint s2 = 2 * s;
        nint s3 = 3 * s;
        int first = chain.FirstWithin;
        int last = chain.LastWithin;
        double* residual = chain[ChainColumn.Residual];
        double* half = chain[ChainColumn.Half];
        double* inverse = chain[ChainColumn.Inverse];
        double* gain = chain[ChainColumn.Gain];
        ends = default;
        int i = 0;
        for (int k = chain.Joints - 1; i < first || k > last; i++, k--)
        {
            if (i < first)
            {
                Reduce(residual + i, gain + i, half + i, inverse + i, s, s2, s3, ref ends.LowX, ref ends.LowY);
            }

            if (k > last)
            {
                Reduce(residual + k, gain + k + 1, half + k, inverse + k, s, s2, s3, ref ends.HighX, ref ends.HighY);
            }
        }
    }

    /// <summary>The impulses of the joints beyond those.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Spread(in ChainView chain)
    {
        nint s = chain.Stride;
        nint s2 = 2 * s;
        nint s3 = 3 * s;
        int i = chain.FirstWithin;
        int k = chain.LastWithin;
        int last = chain.Joints - 1;
        double* half = chain[ChainColumn.Half];
        double* gain = chain[ChainColumn.Gain];
        double* lambda = chain[ChainColumn.Lambda];
        double ux = lambda[i];
        double uy = lambda[i + s];
        double dx = lambda[k];
        double dy = lambda[k + s];
        for (i--, k++; i >= 0 || k <= last; i--, k++)
        {
            if (i >= 0)
            {
                Resolve(lambda + i, gain + i + 1, half + i, s, s2, s3, ref ux, ref uy);
            }

            if (k <= last)
            {
                Resolve(lambda + k, gain + k, half + k, s, s2, s3, ref dx, ref dy);
            }
        }
    }

    /// <summary>y = r - B·D⁻¹·y of the joint before, and D⁻¹·y.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Reduce(double* r, double* g, double* half, double* e, nint s, nint s2, nint s3, ref double x, ref double y)
    {
        double rx = r[0] - ((g[0] * x) + (g[s] * y));
        double ry = r[s] - ((g[s2] * x) + (g[s3] * y));
        half[0] = (e[0] * rx) + (e[s] * ry);
        half[s] = (e[s] * rx) + (e[s2] * ry);
        x = rx;
        y = ry;
    }

    /// <summary>λ = D⁻¹·y - (B·D⁻¹)ᵀ·λ of the joint behind.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Resolve(double* lambda, double* g, double* half, nint s, nint s2, nint s3, ref double x, ref double y)
    {
        double lx = half[0] - ((g[0] * x) + (g[s2] * y));
        double ly = half[s] - ((g[s] * x) + (g[s3] * y));
        lambda[0] = lx;
        lambda[s] = ly;
        x = lx;
        y = ly;
    }

    /// <summary>Gives the impulses to the bodies. What is left of a velocity that its changes cancel is rounding, and none.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Give(in ChainView chain)
    {
        int s = chain.Stride;
        double* velocity = chain[ChainColumn.Velocity];
        WideDouble rounding = WideDouble.Splat(TreeSolve.Rounding);
        for (int i = 0; i <= chain.Joints; i += WideDouble.Count)
        {
            Impulses(chain, i, out WideDouble x, out WideDouble y, out WideDouble w);
            Add(velocity + i, x, rounding);
            Add(velocity + s + i, y, rounding);
            Add(velocity + (2 * s) + i, w, rounding);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Add(double* velocity, WideDouble change, WideDouble rounding)
    {
        WideDouble before = WideDouble.Load(velocity);
        WideDouble sum = before + change;
        WideDoubleMask still = WideDouble.Abs(sum) <= rounding * WideDouble.Abs(before);
        WideDouble.Select(still, WideDouble.Zero, sum).Store(velocity);
    }

    /// <summary>
    /// Gives the impulses of a correction to the bodies: positions and velocities go on by them. The angles by which they turned are added
    /// up.
    /// </summary>
    /// <returns>The largest of these.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static double Correct(in ChainView chain, double h)
    {
        int s = chain.Stride;
        double* velocity = chain[ChainColumn.Velocity];
        double* move = chain[ChainColumn.Move];
        double* bent = chain[ChainColumn.Bent];
        WideDouble time = WideDouble.Splat(h);
        WideDouble largest = WideDouble.Zero;
        for (int i = 0; i <= chain.Joints; i += WideDouble.Count)
        {
            Impulses(chain, i, out WideDouble x, out WideDouble y, out WideDouble w);
            (WideDouble.Load(velocity + i) + x).Store(velocity + i);
            (WideDouble.Load(velocity + s + i) + y).Store(velocity + s + i);
            (WideDouble.Load(velocity + (2 * s) + i) + w).Store(velocity + (2 * s) + i);
            w = time * w;
            (WideDouble.Load(move + i) + (time * x)).Store(move + i);
            (WideDouble.Load(move + s + i) + (time * y)).Store(move + s + i);
            (WideDouble.Load(move + (2 * s) + i) + w).Store(move + (2 * s) + i);
            WideDouble turn = WideDouble.Load(bent + i) + WideDouble.Abs(w);
            turn.Store(bent + i);
            largest = ChainPoses.Larger(largest, turn);
        }

        return ChainPoses.Largest(largest);
    }

    /// <summary>How fast the high anchor moves away from the low one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Speed(in ChainView chain, int i, out WideDouble x, out WideDouble y)
    {
        int s = chain.Stride;
        double* low = chain[chain.Arms] + i;
        double* high = low + (2 * s);
        double* v = chain[ChainColumn.Velocity] + i;
        WideDouble w = WideDouble.Load(v + (2 * s));
        WideDouble u = WideDouble.Load(v + (2 * s) + 1);
        x = (WideDouble.Load(v + 1) - WideDouble.Load(v)) + ((w * WideDouble.Load(low + s)) - (u * WideDouble.Load(high + s)));
        y = (WideDouble.Load(v + s + 1) - WideDouble.Load(v + s)) + ((u * WideDouble.Load(high)) - (w * WideDouble.Load(low)));
    }

    /// <summary>
    /// The velocity changes of bodies by the impulses of their joints, which are added to what these gave in the step. There is one body
    /// more than joints, and be it the one that cannot move.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Impulses(in ChainView chain, int i, out WideDouble x, out WideDouble y, out WideDouble w)
    {
        int s = chain.Stride;
        double* low = chain[chain.Arms] + i;
        double* high = low + (2 * s) - 1;
        double* lambda = chain[ChainColumn.Lambda] + i;
        double* given = chain[ChainColumn.Given] + i;
        WideDouble lx = WideDouble.Load(lambda);
        WideDouble ly = WideDouble.Load(lambda + s);
        WideDouble hx = WideDouble.Load(lambda - 1);
        WideDouble hy = WideDouble.Load(lambda + s - 1);
        WideDouble momentLow = (WideDouble.Load(low) * ly) - (WideDouble.Load(low + s) * lx);
        WideDouble momentHigh = (WideDouble.Load(high) * hy) - (WideDouble.Load(high + s) * hx);
        (WideDouble.Load(given) + lx).Store(given);
        (WideDouble.Load(given + s) + ly).Store(given + s);
        (WideDouble.Load(given + (2 * s)) + momentLow).Store(given + (2 * s));

        // Of the joint before, so that it stands one place further on.
        (WideDouble.Load(given + (3 * s)) + momentHigh).Store(given + (3 * s));
        WideDouble mass = WideDouble.Load(chain[ChainColumn.InverseMass] + i);
        x = hx - lx;
        y = hy - ly;
        w = momentHigh - momentLow;
        if (chain.IsPressed)
        {
            double* push = chain[ChainColumn.Push] + i;
            x += WideDouble.Load(push);
            y += WideDouble.Load(push + s);
            w += WideDouble.Load(push + (2 * s));
        }

        x = mass * x;
        y = mass * y;
        w = WideDouble.Load(chain[ChainColumn.InverseInertia] + i) * w;
    }

    /// <summary>Velocities, displacements and impulses before corrections.</summary>
    public static void NotePlain(in ChainView view)
    {
        Copy(view[ChainColumn.Velocity], view[ChainColumn.PlainVelocity], 3 * view.Stride);
        Copy(view[ChainColumn.Move], view[ChainColumn.PlainMove], 3 * view.Stride);
        Copy(view[ChainColumn.Given], view[ChainColumn.PlainGiven], 4 * view.Stride);
        double* bent = view[ChainColumn.Bent];
        for (int i = 0; i < view.Stride; i += WideDouble.Count)
        {
            WideDouble.Zero.Store(bent + i);
        }
    }

    private static void Copy(double* from, double* to, int count)
    {
        for (int i = 0; i < count; i += WideDouble.Count)
        {
            WideDouble.Load(from + i).Store(to + i);
        }
    }
}

/// <summary>What the eliminations from both ends of a chain have come to, before the joints at the bodies that contacts press on.</summary>
internal struct ChainEnds
{
    public double LowX;
    public double LowY;
    public double HighX;
    public double HighY;
}
