#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Farseer.Engine.Bodies.Sixteen;

using Farseer.Engine.Numerics.Sixteen;
using Wide = System.Runtime.Intrinsics.Vector512<float>;

/// <summary>
/// Moves states of sixteen bodies between memory and lanes: see <see cref="Farseer.Engine.Bodies.BodyLanes"/>. Each 128 bits of a vector
/// hold what four bodies have, so all but the first step is that of eight lanes.
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

    /// <summary>Reads whole records of 16 floats, a line each, and writes lane vectors.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherRecords(float* records, int* index, float* target)
    {
        Quarters(records, index, out Wide a0, out Wide a1, out Wide a2, out Wide a3);
        Quarters(records, index + 1, out Wide b0, out Wide b1, out Wide b2, out Wide b3);
        Quarters(records, index + 2, out Wide c0, out Wide c1, out Wide c2, out Wide c3);
        Quarters(records, index + 3, out Wide d0, out Wide d1, out Wide d2, out Wide d3);
        StoreColumns(a0, b0, c0, d0, target);
        StoreColumns(a1, b1, c1, d1, target + (4 * Wide.Count));
        StoreColumns(a2, b2, c2, d2, target + (8 * Wide.Count));
        StoreColumns(a3, b3, c3, d3, target + (12 * Wide.Count));
    }

    /// <summary>Centres of the bodies B less those of the bodies A, subtracted in double and rounded once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherOffset(BodyPose* poses, int* a, int* b, out Wide x, out Wide y)
    {
        Wide even = Offsets(poses, a, b);
        Wide odd = Offsets(poses, a + 2, b + 2);
        x = Avx512F.Shuffle(even, odd, 0x88);
        y = Avx512F.Shuffle(even, odd, 0xDD);
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

    /// <summary>
    /// The velocities of every fourth body. In loads of 16 bytes: what was just stored so is read at once, and what is read in one go with
    /// more waits.
    /// </summary>
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

    /// <summary>Of every fourth record, a line each, the four quarters side by side.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Quarters(float* records, int* index, out Wide q0, out Wide q1, out Wide q2, out Wide q3)
    {
        q0 = Wide.Load(records + ((nint)index[0] * Wide.Count));
        q1 = Wide.Load(records + ((nint)index[4] * Wide.Count));
        q2 = Wide.Load(records + ((nint)index[8] * Wide.Count));
        q3 = Wide.Load(records + ((nint)index[12] * Wide.Count));
        WideLanes.TransposeQuarters(ref q0, ref q1, ref q2, ref q3);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreColumns(Wide r0, Wide r1, Wide r2, Wide r3, float* target)
    {
        WideLanes.Transpose(ref r0, ref r1, ref r2, ref r3);
        r0.Store(target);
        r1.Store(target + Wide.Count);
        r2.Store(target + (2 * Wide.Count));
        r3.Store(target + (3 * Wide.Count));
    }

    /// <summary>x and y of two pairs in each quarter.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Offsets(BodyPose* poses, int* a, int* b)
    {
        Vector512<double> low = Centres(poses, b[0], b[1], b[4], b[5]) - Centres(poses, a[0], a[1], a[4], a[5]);
        Vector512<double> high = Centres(poses, b[8], b[9], b[12], b[13]) - Centres(poses, a[8], a[9], a[12], a[13]);
        return Avx512F.InsertVector256(
            Avx512F.ConvertToVector256Single(low).ToVector512Unsafe(), Avx512F.ConvertToVector256Single(high), 1);
    }

    // A pose begins with x and y.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Centres(BodyPose* poses, int first, int second, int third, int fourth)
    {
        Vector512<double> r = Vector128.Load((double*)(poses + first)).ToVector256Unsafe().ToVector512Unsafe();
        r = Avx512F.InsertVector128(r.AsSingle(), Vector128.Load((float*)(poses + second)), 1).AsDouble();
        r = Avx512F.InsertVector128(r.AsSingle(), Vector128.Load((float*)(poses + third)), 2).AsDouble();
        return Avx512F.InsertVector128(r.AsSingle(), Vector128.Load((float*)(poses + fourth)), 3).AsDouble();
    }

    // An index is never negative; unsigned it needs no widening.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float* Record(BodyState* bodies, int index) => (float*)((byte*)bodies + ((ulong)(uint)index << 5));
}
#endif
