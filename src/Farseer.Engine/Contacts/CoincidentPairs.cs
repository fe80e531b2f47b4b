using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// Bodies at one and the same place have no side on which they are of each other. All pairs of a hundred such bodies then pushed along
/// one line, which a hundred bodies long takes minutes to become. Their pairs are seen as if each body stood a hair from
/// there towards a place of its own, as the seeds of a sunflower lie: so they part to all sides, and any three agree about it.
/// </summary>
internal static unsafe class CoincidentPairs
{
    /// <summary>The golden section of a turn: no two of the first n seeds lie in one direction, for any n.</summary>
    private const double Turn = 0.61803398874989485;

    /// <summary>The hair, in extents of the smaller piece: more than the rounding of a pair's offset, less than shows.</summary>
    private const float Share = 1e-4f;

    /// <summary>Gives the lanes whose bodies have the same centre an offset.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Part(PairLanes* pairs, int* bodyA, int* bodyB, int first, int lanes)
    {
        for (int lane = first; lanes != 0; lane++, lanes >>= 1)
        {
            if ((lanes & 1) == 0 || bodyA[lane] == bodyB[lane])
            {
                continue;
            }

            Seed(bodyA[lane], out double ax, out double ay);
            Seed(bodyB[lane], out double bx, out double by);
            double x = bx - ax;
            double y = by - ay;
            double hair = Share * Math.Min(pairs->A.Extent[lane], pairs->B.Extent[lane]) / Math.Sqrt((x * x) + (y * y));
            pairs->OffsetX[lane] = (float)(hair * x);
            pairs->OffsetY[lane] = (float)(hair * y);
        }
    }

    private static void Seed(int body, out double x, out double y)
    {
        double turns = body * Turn;
        StableMath.SinCos(2 * Math.PI * (turns - Math.Floor(turns)), out double sin, out double cos);
        double distance = Math.Sqrt(body);
        x = distance * cos;
        y = distance * sin;
    }
}
