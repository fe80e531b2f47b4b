#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Farseer.Engine.Bodies.Sixteen;

using Farseer.Engine.Numerics.Sixteen;
using Wide = System.Runtime.Intrinsics.Vector512<float>;

/// <summary>
/// Moves states of sixteen bodies between memory and lanes: see <see cref="Farseer.Engine.Bodies.BodyLanes"/>. Each 128 bits of a vector hold what
/// four bodies have, so all but the first step is that of eight lanes.
/// </summary>
internal static unsafe class BodyLanes
{
    /// <summary>The velocities of two bundles' bodies.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherVelocities(BodyState* bodies, int* indexA, int* indexB, out WideVelocity a, out WideVelocity b)
    {
        GatherVelocity(bodies, indexA, out a);
        GatherVelocity(bodies, indexB, out b);
    }

    /// <summary>What two bundles' bodies have moved.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherDeltas(BodyState* bodies, int* indexA, int* indexB, out WideDelta a, out WideDelta b)
    {
        GatherState(bodies, indexA, out _, out a);
        GatherState(bodies, indexB, out _, out b);
    }

    /// <summary>Both halves of the states at once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherState(BodyState* bodies, int* index, out WideVelocity v, out WideDelta d)
    {
        Halves(bodies, index, out Wide v0, out Wide d0);
        Halves(bodies, index + 1, out Wide v1, out Wide d1);
        Halves(bodies, index + 2, out Wide v2, out Wide d2);
        Halves(bodies, index + 3, out Wide v3, out Wide d3);
        WideLanes.Transpose(ref v0, ref v1, ref v2, ref v3);
        WideLanes.Transpose(ref d0, ref d1, ref d2, ref d3);
        v.X = v0;
        v.Y = v1;
        v.W = v2;
        d.X = d0;
        d.Y = d1;
        d.Sin = d2;
        d.Cos = d3;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ScatterVelocity(BodyState* bodies, int* index, in WideVelocity v)
    {
        Turn(v, out Wide r0, out Wide r1, out Wide r2, out Wide r3);
        Store(bodies, index, r0);
        Store(bodies, index + 1, r1);
        Store(bodies, index + 2, r2);
        Store(bodies, index + 3, r3);
    }

    /// <summary>As <see cref="ScatterVelocity"/>, but leaves out the lanes whose inverse mass and inertia are both 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ScatterMoving(BodyState* bodies, int* index, in WideVelocity v, float* mass, float* inertia)
    {
        int moving = WideLanes.Bits((Wide.Load(mass) > Wide.Zero) | (Wide.Load(inertia) > Wide.Zero));
        if (moving != 0)
        {
            ScatterLanes(bodies, index, v, moving);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ScatterLanes(BodyState* bodies, int* index, in WideVelocity v, int lanes)
    {
        if (lanes == (1 << Wide.Count) - 1)
        {
            ScatterVelocity(bodies, index, v);
            return;
        }

        Turn(v, out Wide r0, out Wide r1, out Wide r2, out Wide r3);
        StoreSome(bodies, index, r0, lanes);
        StoreSome(bodies, index + 1, r1, lanes >> 1);
        StoreSome(bodies, index + 2, r2, lanes >> 2);
        StoreSome(bodies, index + 3, r3, lanes >> 3);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GatherVelocity(BodyState* bodies, int* index, out WideVelocity v)
    {
        Wide r0 = Velocities(bodies, index);
        Wide r1 = Velocities(bodies, index + 1);
        Wide r2 = Velocities(bodies, index + 2);
        Wide r3 = Velocities(bodies, index + 3);
        WideLanes.Transpose(ref r0, ref r1, ref r2, ref r3);
        v.X = r0;
        v.Y = r1;
        v.W = r2;
    }

    /// <summary>The velocities of every fourth body. In loads of 16 bytes: what was just stored so is read at once, and what is read in one go with more waits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Velocities(BodyState* bodies, int* index)
    {
        Wide r = Vector128.Load(Record(bodies, index[0])).ToVector256Unsafe().ToVector512Unsafe();
        r = Avx512F.InsertVector128(r, Vector128.Load(Record(bodies, index[4])), 1);
        r = Avx512F.InsertVector128(r, Vector128.Load(Record(bodies, index[8])), 2);
        return Avx512F.InsertVector128(r, Vector128.Load(Record(bodies, index[12])), 3);
    }

    /// <summary>Both halves of every fourth body's state.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Halves(BodyState* bodies, int* index, out Wide first, out Wide second)
    {
        Wide low = Pair(bodies, index[0], index[4]);
        Wide high = Pair(bodies, index[8], index[12]);
        first = Avx512F.Shuffle4x128(low, high, 0x88);
        second = Avx512F.Shuffle4x128(low, high, 0xDD);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Pair(BodyState* bodies, int low, int high) => Avx512F.InsertVector256(
        Vector256.Load(Record(bodies, low)).ToVector512Unsafe(), Vector256.Load(Record(bodies, high)), 1);

    /// <summary>Velocities as they lie in memory, those of every fourth body side by side.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Turn(in WideVelocity v, out Wide r0, out Wide r1, out Wide r2, out Wide r3)
    {
        r0 = v.X;
        r1 = v.Y;
        r2 = v.W;
        r3 = Wide.Zero;
        WideLanes.Transpose(ref r0, ref r1, ref r2, ref r3);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(BodyState* bodies, int* index, Wide r)
    {
        r.GetLower().GetLower().Store(Record(bodies, index[0]));
        Avx512F.ExtractVector128(r, 1).Store(Record(bodies, index[4]));
        Avx512F.ExtractVector128(r, 2).Store(Record(bodies, index[8]));
        Avx512F.ExtractVector128(r, 3).Store(Record(bodies, index[12]));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreSome(BodyState* bodies, int* index, Wide r, int lanes)
    {
        if ((lanes & 0x1) != 0)
        {
            r.GetLower().GetLower().Store(Record(bodies, index[0]));
        }

        if ((lanes & 0x10) != 0)
        {
            Avx512F.ExtractVector128(r, 1).Store(Record(bodies, index[4]));
        }

        if ((lanes & 0x100) != 0)
        {
            Avx512F.ExtractVector128(r, 2).Store(Record(bodies, index[8]));
        }

        if ((lanes & 0x1000) != 0)
        {
            Avx512F.ExtractVector128(r, 3).Store(Record(bodies, index[12]));
        }
    }

    // An index is never negative; unsigned it needs no widening.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float* Record(BodyState* bodies, int index) => (float*)((byte*)bodies + ((ulong)(uint)index << 5));
}
#endif
