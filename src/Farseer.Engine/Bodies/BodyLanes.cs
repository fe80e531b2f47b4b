using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Bodies;

/// <summary>
/// Moves 16-byte halves of <see cref="BodyState"/> between memory and lanes. Eight loads and eight in-lane shuffles; hardware
/// gathers were measured 1.7 times slower. Scatter writes the velocity half only.
/// </summary>
internal static unsafe partial class BodyLanes
{
    private const int LineFloats = Prefetch.LineBytes / sizeof(float);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherVelocity(BodyState* bodies, int* index, out WideVelocity v)
    {
        Gather((float*)bodies, index, out v.X, out v.Y, out v.W, out _);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherDelta(BodyState* bodies, int* index, out WideDelta d)
    {
        Gather((float*)bodies + 4, index, out d.X, out d.Y, out d.Sin, out d.Cos);
    }

    /// <summary>The velocities of two bundles' bodies.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherVelocities(BodyState* bodies, int* indexA, int* indexB, out WideVelocity a, out WideVelocity b)
    {
        Gather((float*)bodies, indexA, (float*)bodies, indexB, out FourColumns ofA, out FourColumns ofB);
        a = AsVelocity(ofA);
        b = AsVelocity(ofB);
    }

    /// <summary>What two bundles' bodies have moved.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherDeltas(BodyState* bodies, int* indexA, int* indexB, out WideDelta a, out WideDelta b)
    {
        Gather((float*)bodies + 4, indexA, (float*)bodies + 4, indexB, out FourColumns ofA, out FourColumns ofB);
        a = AsDelta(ofA);
        b = AsDelta(ofB);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVelocity AsVelocity(in FourColumns half)
    {
        WideVelocity v;
        v.X = half.A;
        v.Y = half.B;
        v.W = half.C;
        return v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDelta AsDelta(in FourColumns half)
    {
        WideDelta d;
        d.X = half.A;
        d.Y = half.B;
        d.Sin = half.C;
        d.Cos = half.D;
        return d;
    }

    /// <summary>
    /// Both halves at once: half as many loads, and each record's place is worked out once. Only for passes that have registers to spare.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherState(BodyState* bodies, int* index, out WideVelocity v, out WideDelta d)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            Halves(bodies, index[0], index[4], out Vector256<float> v0, out Vector256<float> d0);
            Halves(bodies, index[1], index[5], out Vector256<float> v1, out Vector256<float> d1);
            Halves(bodies, index[2], index[6], out Vector256<float> v2, out Vector256<float> d2);
            Halves(bodies, index[3], index[7], out Vector256<float> v3, out Vector256<float> d3);
            WideLanes.Transpose(ref v0, ref v1, ref v2, ref v3);
            WideLanes.Transpose(ref d0, ref d1, ref d2, ref d3);
            v.X = v0.AsVector();
            v.Y = v1.AsVector();
            v.W = v2.AsVector();
            d.X = d0.AsVector();
            d.Y = d1.AsVector();
            d.Sin = d2.AsVector();
            d.Cos = d3.AsVector();
            return;
        }
#endif
        GatherVelocity(bodies, index, out v);
        GatherDelta(bodies, index, out d);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ScatterVelocity(BodyState* bodies, int* index, in WideVelocity v)
    {
        Scatter((float*)bodies, index, v.X, v.Y, v.W, Wide.Zero);
    }

    /// <summary>As <see cref="ScatterVelocity"/>, but leaves out the lanes whose inverse mass and inertia are both 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ScatterMoving(BodyState* bodies, int* index, in WideVelocity v, float* mass, float* inertia)
    {
        // The side of the ground, often of all lanes, costs no call.
        int moving = WideLanes.Bits((Wide.Load(mass) > Wide.Zero) | (Wide.Load(inertia) > Wide.Zero));
        if (moving != 0)
        {
            ScatterLanes(bodies, index, v, moving);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ScatterDelta(BodyState* bodies, int* index, in WideDelta d)
    {
        Scatter((float*)bodies + 4, index, d.X, d.Y, d.Sin, d.Cos);
    }

    /// <summary>Reads four floats of each record of 32 bytes and turns them into four lane vectors.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Gather(float* records, int* index, out Wide a, out Wide b, out Wide c, out Wide d)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            Vector256<float> r0 = Pair(records, index[0], index[4]);
            Vector256<float> r1 = Pair(records, index[1], index[5]);
            Vector256<float> r2 = Pair(records, index[2], index[6]);
            Vector256<float> r3 = Pair(records, index[3], index[7]);
            WideLanes.Transpose(ref r0, ref r1, ref r2, ref r3);
            a = r0.AsVector();
            b = r1.AsVector();
            c = r2.AsVector();
            d = r3.AsVector();
            return;
        }
#endif
        GatherByElement(records, index, 8, out a, out b, out c, out d);
    }

    /// <summary>Four floats of each of two lists of records: turned by way of memory, which is waited for once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Gather(float* first, int* indexFirst, float* second, int* indexSecond, out FourColumns a, out FourColumns b)
    {
        if (Wide.Count <= MatrixTurn.MostLanes)
        {
            FourColumns turnedA;
            FourColumns turnedB;
            Turn(first, indexFirst, &turnedA);
            Turn(second, indexSecond, &turnedB);
            a = turnedA;
            b = turnedB;
            return;
        }

        Gather(first, indexFirst, out a.A, out a.B, out a.C, out a.D);
        Gather(second, indexSecond, out b.A, out b.B, out b.C, out b.D);
    }

    /// <summary>
    /// Reads whole records of 16 floats, and writes lane vectors a line apart. The places of the
    /// records are worked out once for all four quarters.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherRecords(float* records, int* index, float* target)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            float* p0 = records + (index[0] * 16);
            float* p1 = records + (index[1] * 16);
            float* p2 = records + (index[2] * 16);
            float* p3 = records + (index[3] * 16);
            float* p4 = records + (index[4] * 16);
            float* p5 = records + (index[5] * 16);
            float* p6 = records + (index[6] * 16);
            float* p7 = records + (index[7] * 16);
            for (int i = 0; i < 16; i += 4)
            {
                Vector256<float> r0 = Vector256.Create(Vector128.Load(p0 + i), Vector128.Load(p4 + i));
                Vector256<float> r1 = Vector256.Create(Vector128.Load(p1 + i), Vector128.Load(p5 + i));
                Vector256<float> r2 = Vector256.Create(Vector128.Load(p2 + i), Vector128.Load(p6 + i));
                Vector256<float> r3 = Vector256.Create(Vector128.Load(p3 + i), Vector128.Load(p7 + i));
                WideLanes.Transpose(ref r0, ref r1, ref r2, ref r3);
                r0.Store(target);
                r1.Store(target + LineFloats);
                r2.Store(target + (2 * LineFloats));
                r3.Store(target + (3 * LineFloats));
                target += 4 * LineFloats;
            }

            return;
        }
#endif
        for (int i = 0; i < 16; i += 4)
        {
            TurnRecords(records + i, index, 16, target + (i * LineFloats), LineFloats);
        }
    }

    /// <summary>Centres of the bodies B less those of the bodies A, subtracted in double and rounded once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherOffset(BodyPose* poses, int* a, int* b, out Wide x, out Wide y)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            Vector128<float> d01 = Offsets(poses, a, b);
            Vector128<float> d23 = Offsets(poses, a + 2, b + 2);
            Vector128<float> d45 = Offsets(poses, a + 4, b + 4);
            Vector128<float> d67 = Offsets(poses, a + 6, b + 6);
            x = Vector256.Create(Sse.Shuffle(d01, d23, 0x88), Sse.Shuffle(d45, d67, 0x88)).AsVector();
            y = Vector256.Create(Sse.Shuffle(d01, d23, 0xDD), Sse.Shuffle(d45, d67, 0xDD)).AsVector();
            return;
        }
#endif
        GatherOffsetByElement(poses, a, b, out x, out y);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Scatter(float* records, int* index, Wide a, Wide b, Wide c, Wide d)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            Vector256<float> r0 = a.AsVector256();
            Vector256<float> r1 = b.AsVector256();
            Vector256<float> r2 = c.AsVector256();
            Vector256<float> r3 = d.AsVector256();
            WideLanes.Transpose(ref r0, ref r1, ref r2, ref r3);

            // An index is never negative; unsigned it needs no widening, which would be an instruction for each record and pass.
            var states = (BodyState*)records;
            *(Vector128<float>*)(states + (uint)index[0]) = r0.GetLower();
            *(Vector128<float>*)(states + (uint)index[1]) = r1.GetLower();
            *(Vector128<float>*)(states + (uint)index[2]) = r2.GetLower();
            *(Vector128<float>*)(states + (uint)index[3]) = r3.GetLower();
            *(Vector128<float>*)(states + (uint)index[4]) = r0.GetUpper();
            *(Vector128<float>*)(states + (uint)index[5]) = r1.GetUpper();
            *(Vector128<float>*)(states + (uint)index[6]) = r2.GetUpper();
            *(Vector128<float>*)(states + (uint)index[7]) = r3.GetUpper();
            return;
        }
#endif
        ScatterByElement(records, index, a, b, c, d);
    }

    private static void GatherByElement(float* records, int* index, int stride, out Wide a, out Wide b, out Wide c, out Wide d)
    {
        FourColumns turned;
        TurnRecords(records, index, stride, (float*)&turned, Wide.Count);
        a = turned.A;
        b = turned.B;
        c = turned.C;
        d = turned.D;
    }

    private static void GatherOffsetByElement(BodyPose* poses, int* a, int* b, out Wide x, out Wide y)
    {
        FourColumns turned;
        BodyTurning.StoreOffsets(poses, a, b, (float*)&turned.A, (float*)&turned.B);
        x = turned.A;
        y = turned.B;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ScatterLanes(BodyState* bodies, int* index, in WideVelocity v, int lanes)
    {
        if (lanes == (1 << Wide.Count) - 1)
        {
            ScatterVelocity(bodies, index, v);
        }
        else
        {
            ScatterSome(bodies, index, v, lanes);
        }
    }

    // In stores of 16 bytes, as all others: what reads a record at once waits long for three stores that it spans.
    private static void ScatterSome(BodyState* bodies, int* index, in WideVelocity v, int lanes)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            Vector256<float> r0 = v.X.AsVector256();
            Vector256<float> r1 = v.Y.AsVector256();
            Vector256<float> r2 = v.W.AsVector256();
            Vector256<float> r3 = Vector256<float>.Zero;
            WideLanes.Transpose(ref r0, ref r1, ref r2, ref r3);
            StoreSome(bodies, index, lanes, r0.GetLower(), r1.GetLower(), r2.GetLower(), r3.GetLower());
            StoreSome(bodies, index + 4, lanes >> 4, r0.GetUpper(), r1.GetUpper(), r2.GetUpper(), r3.GetUpper());
            return;
        }
#endif
        float* t = stackalloc float[3 * WideLanes.BundleLanes];
        v.X.Store(t);
        v.Y.Store(t + 8);
        v.W.Store(t + 16);
        for (int i = 0; lanes != 0; i++, lanes >>= 1)
        {
            if ((lanes & 1) != 0)
            {
                float* r = (float*)(bodies + index[i]);
                r[0] = t[i];
                r[1] = t[i + 8];
                r[2] = t[i + 16];
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void ScatterByElement(float* records, int* index, Wide a, Wide b, Wide c, Wide d)
    {
        FourColumns turned;
        turned.A = a;
        turned.B = b;
        turned.C = c;
        turned.D = d;
        var t = (float*)&turned;
        for (int i = 0; i < Wide.Count; i += MatrixTurn.Records)
        {
            MatrixTurn.ToRecords(
                *(Vector4*)(t + i),
                *(Vector4*)(t + i + Wide.Count),
                *(Vector4*)(t + i + (2 * Wide.Count)),
                *(Vector4*)(t + i + (3 * Wide.Count)),
                (float*)((BodyState*)records + index[i]),
                (float*)((BodyState*)records + index[i + 1]),
                (float*)((BodyState*)records + index[i + 2]),
                (float*)((BodyState*)records + index[i + 3]));
        }
    }

#if NET8_0_OR_GREATER
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Pair(float* records, int low, int high) =>
        Vector256.Create(*(Vector128<float>*)((BodyState*)records + (uint)low), *(Vector128<float>*)((BodyState*)records + (uint)high));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Halves(BodyState* bodies, int low, int high, out Vector256<float> first, out Vector256<float> second)
    {
        Vector256<float> a = *(Vector256<float>*)(bodies + (uint)low);
        Vector256<float> b = *(Vector256<float>*)(bodies + (uint)high);
        first = Avx.Permute2x128(a, b, 0x20);
        second = Avx.Permute2x128(a, b, 0x31);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreSome(
        BodyState* bodies, int* index, int lanes, Vector128<float> r0, Vector128<float> r1, Vector128<float> r2, Vector128<float> r3)
    {
        if ((lanes & 1) != 0)
        {
            *(Vector128<float>*)(bodies + (uint)index[0]) = r0;
        }

        if ((lanes & 2) != 0)
        {
            *(Vector128<float>*)(bodies + (uint)index[1]) = r1;
        }

        if ((lanes & 4) != 0)
        {
            *(Vector128<float>*)(bodies + (uint)index[2]) = r2;
        }

        if ((lanes & 8) != 0)
        {
            *(Vector128<float>*)(bodies + (uint)index[3]) = r3;
        }
    }

    // Two bodies' (x, y) side by side. A pose begins with x and y.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<float> Offsets(BodyPose* poses, int* a, int* b)
    {
        Vector256<double> from = Vector256.Create(Vector128.Load((double*)(poses + a[0])), Vector128.Load((double*)(poses + a[1])));
        Vector256<double> to = Vector256.Create(Vector128.Load((double*)(poses + b[0])), Vector128.Load((double*)(poses + b[1])));
        return Avx.ConvertToVector128Single(to - from);
    }
#endif
}
