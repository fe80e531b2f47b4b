using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Chains;

/// <summary>Velocities by forces, displacements and poses of a chain's bodies, and arms and errors of its joints there.</summary>
internal static unsafe class ChainPoses
{
    /// <summary>v ← v·keep + drive, and a share of the drive more; what it was is noted.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Drive(in ChainView chain, double share)
    {
        int s = chain.Stride;
        double* velocity = chain[ChainColumn.Velocity];
        double* start = chain[ChainColumn.StartVelocity];
        double* drive = chain[ChainColumn.Drive];
        double* linear = chain[ChainColumn.LinearKeep];
        double* angular = chain[ChainColumn.AngularKeep];
        WideDouble more = WideDouble.Splat(share);
        for (int i = 0; i < chain.Bodies; i += WideDouble.Count)
        {
            WideDouble keep = WideDouble.Load(linear + i);
            Drive(velocity + i, start + i, drive + i, keep, more);
            Drive(velocity + s + i, start + s + i, drive + s + i, keep, more);
            Drive(velocity + (2 * s) + i, start + (2 * s) + i, drive + (2 * s) + i, WideDouble.Load(angular + i), more);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Drive(double* velocity, double* start, double* drive, WideDouble keep, WideDouble share)
    {
        WideDouble v = WideDouble.Load(velocity);
        WideDouble change = WideDouble.Load(drive);
        v.Store(start);
        ((v * keep) + change + (share * change)).Store(velocity);
    }

    /// <summary>A share of the drive.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Kick(in ChainView chain, double share)
    {
        int s = chain.Stride;
        double* velocity = chain[ChainColumn.Velocity];
        double* drive = chain[ChainColumn.Drive];
        WideDouble more = WideDouble.Splat(share);
        for (int i = 0; i < chain.Bodies; i += WideDouble.Count)
        {
            for (int k = i; k < i + (3 * s); k += s)
            {
                (WideDouble.Load(velocity + k) + (more * WideDouble.Load(drive + k))).Store(velocity + k);
            }
        }
    }

    /// <summary>The way of a substep by h·v.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Move(in ChainView chain, double h)
    {
        int s = chain.Stride;
        double* velocity = chain[ChainColumn.Velocity];
        double* move = chain[ChainColumn.Move];
        double* start = chain[ChainColumn.StartMove];
        WideDouble time = WideDouble.Splat(h);
        for (int i = 0; i < chain.Bodies; i += WideDouble.Count)
        {
            for (int k = i; k < i + (3 * s); k += s)
            {
                WideDouble before = WideDouble.Load(move + k);
                before.Store(start + k);
                (before + (time * WideDouble.Load(velocity + k))).Store(move + k);
            }
        }
    }

    /// <summary>Sines and cosines of the turns, also of what cannot move: it does not turn.</summary>
    public static void Turn(in ChainView chain)
    {
        double* turn = chain[ChainColumn.Move] + (2 * chain.Stride);
        double* sin = chain[ChainColumn.TurnSin];
        double* cos = chain[ChainColumn.TurnCos];
        for (int i = 0; i <= chain.Joints; i += StableMath.Lanes)
        {
            StableMath.SinCos(turn + i, sin + i, cos + i);
        }
    }

    /// <summary>Where the bodies are, and arms and errors of the joints there.</summary>
    /// <returns>The largest error in terms of its joint's size.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static double Place(in ChainView chain)
    {
        int s = chain.Stride;
        double* move = chain[ChainColumn.Move];
        double* place = chain[ChainColumn.Place];
        double* middle = chain[ChainColumn.MiddleSin];
        double* turn = chain[ChainColumn.TurnSin];
        double* pose = chain[ChainColumn.X];
        for (int i = 0; i <= chain.Bodies; i += WideDouble.Count)
        {
            WideDouble middleSin = WideDouble.Load(middle + i);
            WideDouble middleCos = WideDouble.Load(middle + s + i);
            WideDouble turnSin = WideDouble.Load(turn + i);
            WideDouble turnCos = WideDouble.Load(turn + s + i);
            (WideDouble.Load(place + i) + WideDouble.Load(move + i)).Store(pose + i);
            (WideDouble.Load(place + s + i) + WideDouble.Load(move + s + i)).Store(pose + s + i);
            ((middleSin * turnCos) + (middleCos * turnSin)).Store(pose + (2 * s) + i);
            ((middleCos * turnCos) - (middleSin * turnSin)).Store(pose + (3 * s) + i);
        }

        double* anchor = chain[ChainColumn.LowAnchor];
        double* arm = chain[chain.NewArms];
        double* error = chain[ChainColumn.Error];
        double* exists = chain[ChainColumn.Exists];
        double* perSize = chain[ChainColumn.PerSize];
        WideDouble worst = WideDouble.Zero;
        for (int i = 0; i < chain.Joints; i += WideDouble.Count)
        {
            Arm(anchor + i, pose + i, arm + i, s, out WideDouble ax, out WideDouble ay);
            Arm(anchor + (2 * s) + i, pose + i + 1, arm + (2 * s) + i, s, out WideDouble bx, out WideDouble by);
            WideDouble there = WideDouble.Load(exists + i);
            WideDouble x = there & ((WideDouble.Load(pose + i + 1) - WideDouble.Load(pose + i)) + (bx - ax));
            WideDouble y = there & ((WideDouble.Load(pose + s + i + 1) - WideDouble.Load(pose + s + i)) + (by - ay));
            x.Store(error + i);
            y.Store(error + s + i);
            WideDouble share = WideDouble.Load(perSize + i);
            worst = Larger(worst, share * WideDouble.Abs(x));
            worst = Larger(worst, share * WideDouble.Abs(y));
        }

        return Largest(worst);
    }

    /// <summary>What is no number stays.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDouble Larger(WideDouble one, WideDouble other) =>
        WideDouble.Select(WideDouble.IsNotNumber(one) | (other <= one), one, other);

    /// <summary>The largest of the lanes, or what is no number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Largest(WideDouble lanes)
    {
        double* each = stackalloc double[WideDouble.Count];
        lanes.Store(each);
        double largest = each[0];
        for (int i = 1; i < WideDouble.Count; i++)
        {
            largest = double.IsNaN(largest) || each[i] <= largest ? largest : each[i];
        }

        return largest;
    }

    /// <summary>An anchor in world axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Arm(double* anchor, double* pose, double* arm, int s, out WideDouble x, out WideDouble y)
    {
        WideDouble ox = WideDouble.Load(anchor);
        WideDouble oy = WideDouble.Load(anchor + s);
        WideDouble sin = WideDouble.Load(pose + (2 * s));
        WideDouble cos = WideDouble.Load(pose + (3 * s));
        x = (cos * ox) - (sin * oy);
        y = (sin * ox) + (cos * oy);
        x.Store(arm);
        y.Store(arm + s);
    }
}
