using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>Finds the manifolds of the pairs of a bundle, each by the kernel that its pieces need.</summary>
internal static unsafe class PairManifolds
{
    /// <summary>Keeps points as far apart as the blows of this step may throw the bodies of each pair.</summary>
    public static void Widen(in ContactUpdateInput input, ContactBundle* row)
    {
        if (input.Throws == null)
        {
            return;
        }

        for (int lane = 0; lane < PairLanes.Lanes; lane++)
        {
            if (row->Contact[lane] >= 0)
            {
                input.Pairs->Margin[lane] += input.Throws[row->BodyA[lane]] + input.Throws[row->BodyB[lane]];
            }
        }
    }

    /// <summary>Finds the manifolds of all lanes.</summary>
    public static void Collide(in ContactUpdateInput input, ContactBundle* row, in PairBits bits)
    {
        int left = bits.Exists;
        if ((bits.Boxes & left) != 0)
        {
            int corners = WideBoxBox.Collide(input.Pairs);
            left &= ~bits.Boxes | corners;
        }

        OtherManifolds.Collide(input, row, bits, left);
    }

    /// <summary>
    /// Whether a pair with points, whose arms <see cref="PairStage.Touch"/> has found, overlaps or will within <paramref name="time"/>, or,
    /// if it touched, is hardly apart.
    /// </summary>
    public static bool WillTouch(in ContactUpdateInput input, int lane, bool touched, float time)
    {
        PairLanes* pairs = input.Pairs;
        bool movesA = (pairs->A.Flags[lane] & (int)SideFlags.Moves) != 0;
        bool movesB = (pairs->B.Flags[lane] & (int)SideFlags.Moves) != 0;
        float reach = touched ? FastPairs.TouchShare * FastPairs.Extent(pairs->A.Extent[lane], pairs->B.Extent[lane], movesA, movesB) : 0;
        Vector2 n = new Vector2(pairs->NormalX[lane], pairs->NormalY[lane]);
        Vector2 pull = Vector2.Zero;
        pull += (pairs->B.Flags[lane] & (int)SideFlags.Pulled) != 0 ? input.Settings.Gravity : Vector2.Zero;
        pull -= (pairs->A.Flags[lane] & (int)SideFlags.Pulled) != 0 ? input.Settings.Gravity : Vector2.Zero;
        float speed = ((pairs->B.VelocityX[lane] - pairs->A.VelocityX[lane]) * n.X)
            + ((pairs->B.VelocityY[lane] - pairs->A.VelocityY[lane]) * n.Y)
            + (System.Math.Min(0, (pull.X * n.X) + (pull.Y * n.Y)) * time);
        return WillTouch(pairs, &pairs->Point0, lane, speed, reach, time)
            || (pairs->Count[lane] > 1 && WillTouch(pairs, &pairs->Point1, lane, speed, reach, time));
    }

    private static bool WillTouch(PairLanes* pairs, PointLanes* point, int lane, float speed, float reach, float time)
    {
        float closing = speed + (pairs->B.AngularVelocity[lane] * point->TangentArmB[lane])
            - (pairs->A.AngularVelocity[lane] * point->TangentArmA[lane]);
        return point->Separation[lane] <= reach || point->Separation[lane] + (closing * time) <= 0;
    }
}
