using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>What the update of contacts reads: columns and the numbers of this step.</summary>
[NotState(Why.OfOneStep)]
internal unsafe struct ContactUpdateInput
{
    public ShapeStore Shapes;
    public BodyStore Bodies;
    public ContactStore Contacts;
    public Box* Fat;
    public ProxyInfo* Proxies;

    /// <summary>The sides of all pieces, by piece.</summary>
    public ContactSide* Sides;

    /// <summary>Where the corners of all pieces are, by piece.</summary>
    public int* Hulls;

    /// <summary>Where the pairs of one bundle pass through.</summary>
    public PairLanes* Pairs;

    /// <summary>1 for a body that the solver may move.</summary>
    public byte* Moves;
    public WorldSettings Settings;

    /// <summary>What is taken of it is given back at the end of the narrow phase.</summary>
    public Scratch Scratch;
    public float Dt;

    /// <summary>How far the blows of this step may throw each body; null while that is not known.</summary>
    public float* Throws;

    /// <summary>Ratio of this step's substep to the last one's, at most 1: of an impulse nothing says how much was a blow.</summary>
    public float ImpulseScale;

    /// <summary>
    /// By how much a longer substep exceeds the last one, as a share of that: loads, which the feed-forward tells, grow with it.
    /// </summary>
    public float LoadGrowth;
    public ContactCoefficients Coefficients;

    /// <summary>Lets go of the world: whoever keeps this longer than a step would keep that.</summary>
    public void Forget()
    {
        Shapes = null!;
        Bodies = null!;
        Contacts = null!;
        Settings = null!;
        Scratch = null!;
    }
}

/// <summary>What is to become of the pairs of a bundle, or of two side by side, after their update, a bit for each lane.</summary>
internal struct ContactFates
{
    /// <summary>The boxes came apart: the pair is forgotten.</summary>
    public ushort Dropped;

    /// <summary>Has points and gives impulses: belongs into the graph.</summary>
    public ushort Solid;

    /// <summary>Those of the other pairs, which do not.</summary>
    public ushort Idle;
    public ushort Touching;

    /// <summary>Touches now and did not before.</summary>
    public ushort TouchingNow;
    public ushort Heard;

    /// <summary>Gives impulses and will be struck: see <see cref="PairStage.BlowShare"/>.</summary>
    public ushort Blows;

    /// <summary>Those that the kernel of hulls does, which takes several times as long as that of boxes or circles.</summary>
    public ushort Hulls;

    /// <summary>Those of the idle pairs of which the impact, if there is one, must be looked for along the way.</summary>
    public ushort Deferred;

    /// <summary>Those that touch and of which one moves fast past the other; both can move.</summary>
    public ushort Racing;

    /// <summary>Gives impulses, is still apart and may meet in the step; no body is fast.</summary>
    public ushort Ahead;

    /// <summary>Those that have rows of which something follows.</summary>
    public readonly int Follows => Idle | Dropped | Deferred | Racing | Blows | Ahead;

    /// <summary>Of the pairs of two bundles side by side those of one of them.</summary>
    public readonly ContactFates OfBundle(int bundle) => new ContactFates
    {
        Dropped = (ushort)PairBits.Of(Dropped, bundle),
        Solid = (ushort)PairBits.Of(Solid, bundle),
        Idle = (ushort)PairBits.Of(Idle, bundle),
        Touching = (ushort)PairBits.Of(Touching, bundle),
        TouchingNow = (ushort)PairBits.Of(TouchingNow, bundle),
        Heard = (ushort)PairBits.Of(Heard, bundle),
        Blows = (ushort)PairBits.Of(Blows, bundle),
        Hulls = (ushort)PairBits.Of(Hulls, bundle),
        Deferred = (ushort)PairBits.Of(Deferred, bundle),
        Racing = (ushort)PairBits.Of(Racing, bundle),
        Ahead = (ushort)PairBits.Of(Ahead, bundle),
    };
}

/// <summary>
/// The narrow phase of the pairs of a bundle, and the rewriting of its rows. Tolerances come from the motion of a step and from
/// the pieces' own extents, never from a unit of length.
/// </summary>
internal static unsafe class ContactUpdate
{
    /// <summary>Updates the pairs of a bundle of the graph and rewrites their constraints.</summary>
    public static void UpdateRows(in ContactUpdateInput input, ContactBundle* row, out ContactFates fates)
    {
        Update(input, row, isNew: false, out fates);
        ContactRowWriter.Write(input, row);
    }

#if NET8_0_OR_GREATER
    /// <summary>Updates the pairs of both bundles of a record, sixteen lanes at a time but for where fast ones go.</summary>
    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="row">The first of the bundles.</param>
    /// <param name="fates">What is to become of the pairs of both, those of the second in the upper bits.</param>
    public static void UpdateRecord(in ContactUpdateInput input, ContactBundle* row, out ContactFates fates)
    {
        var record = (Sixteen.ContactBundle*)row;
        PairBits bits = Sixteen.PairStage.Load(input, record);
        int dropped = FindDropped(input, row, bits);
        int fast = FindFast(bits, dropped);
        SweepBits sweep = fast == 0 ? default : LookBoth(input, fast);
        int left = bits.Exists;
        if ((bits.Boxes & left) != 0)
        {
            left &= ~bits.Boxes | NarrowPhase.Sixteen.WideBoxBox.Collide(input.Pairs);
        }

        if (left != 0)
        {
            Sixteen.OtherManifolds.Collide(input, record, bits, left);
        }

        TouchBits touch = Sixteen.PairStage.Touch(input, record);
        Decide(input, row, bits, dropped, sweep, ref touch, isNew: false, out fates);
        Sixteen.ContactRowWriter.Write(input, record);
    }
#endif

    /// <summary>Updates pairs without rows.</summary>
    public static void UpdateIdle(in ContactUpdateInput input, ContactBundle* row, out ContactFates fates) =>
        Update(input, row, isNew: true, out fates);

    /// <summary>
    /// Looks again at pairs without rows beside a body that is struck in this step, as far as it may be thrown.
    /// </summary>
    /// <returns>Those that are to get a row, a bit for each lane.</returns>
    public static int FindStruck(in ContactUpdateInput input, ContactBundle* row)
    {
        PairBits bits = PairStage.Load(input, row);
        int lanes = bits.Solid & bits.Exists & ~FindFastAtWalls(input, bits);
        if (lanes == 0)
        {
            return 0;
        }

        // Of pairs with a fast body only those that would not meet without the blow: what they would meet was looked for along their ways.
        PairManifolds.Widen(input, row);
        PairManifolds.Collide(input, row, bits);
        TouchBits touch = PairStage.Touch(input, row);
        lanes &= touch.Hit & ~(bits.Fast & touch.Touching);
        GlancingContact.Drop(input, row, lanes, ref touch);
        return lanes & touch.Hit & ~FindRefused(row, bits, 0);
    }

    /// <summary>
    /// Pairs of a fast body with what cannot move: the sweep looks after these along the way that the body takes in the end.
    /// </summary>
    private static int FindFastAtWalls(in ContactUpdateInput input, in PairBits bits)
    {
        int atWalls = 0;
        for (int lane = 0, fast = bits.Fast & bits.Exists; fast != 0; lane++, fast >>= 1)
        {
            int both = input.Pairs->A.Flags[lane] & input.Pairs->B.Flags[lane];
            atWalls |= (fast & 1) != 0 && (both & (int)SideFlags.Moves) == 0 ? 1 << lane : 0;
        }

        return atWalls;
    }

    /// <summary>
    /// Writes the constraints of pairs that have just been given a place in the graph. Their manifolds are found again: to keep those of
    /// all pairs for the few that get a row was a tenth of what a body kept, and no quicker.
    /// </summary>
    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="row">Names the pairs.</param>
    /// <param name="beside">They lie beside a blow: from where they are, wherever their own ways go.</param>
    public static void FillRows(in ContactUpdateInput input, ContactBundle* row, bool beside)
    {
        PairBits bits = PairStage.Load(input, row);
        PairManifolds.Widen(input, row);
        if ((bits.Fast & bits.Exists) != 0 && !beside)
        {
            FastPairs.Look(input);
        }

        PairManifolds.Collide(input, row, bits);
        PairStage.Touch(input, row);
        ContactRowWriter.Write(input, row);
    }

    /// <summary>Writes the constraint of one pair that is to meet at an impact of this step; it is lane 0 of the bundle.</summary>
    public static void FillImpact(in ContactUpdateInput input, ContactBundle* row, in ForeseenImpact impact)
    {
        PairStage.Load(input, row);
        PairLanes.Write(input.Pairs, 0, impact.Manifold);
        PairStage.Touch(input, row);
        impact.WriteArms(input.Pairs, 0);
        ContactRowWriter.Write(input, row);
    }

    /// <summary>
    /// Writes the constraint of a pair that will not meet by its velocities, from where it is; it is lane 0 of the bundle.
    /// </summary>
    /// <returns>False if it has no points, or would meet by what they say: a corner that the body passes, or the side of something in its
    /// way.</returns>
    public static bool TryFillBeside(in ContactUpdateInput input, ContactBundle* row)
    {
        PairBits bits = PairStage.Load(input, row);
        FastPairs.Look(input);
        PairManifolds.Collide(input, row, bits);
        TouchBits touch = PairStage.Touch(input, row);
        if ((touch.Hit & ~touch.Touching & 1) == 0)
        {
            return false;
        }

        ContactRowWriter.Write(input, row);
        return true;
    }

    public static float MixFriction(ShapeStore shapes, FrictionMix mix, in ContactRecord record)
    {
        float a = shapes.ColliderAt(record.PieceA).Friction;
        float b = shapes.ColliderAt(record.PieceB).Friction;
        return mix switch
        {
            FrictionMix.Minimum => Math.Min(a, b),
            FrictionMix.GeometricMean => (float)Math.Sqrt(a * b),
            FrictionMix.Maximum => Math.Max(a, b),
            FrictionMix.Product => a * b,
            _ => (a + b) * 0.5f,
        };
    }

    public static double MixRestitution(ShapeStore shapes, RestitutionMix mix, in ContactRecord record)
    {
        double a = shapes.ColliderAt(record.PieceA).Restitution;
        double b = shapes.ColliderAt(record.PieceB).Restitution;
        return mix switch
        {
            RestitutionMix.Maximum => Math.Max(a, b),
            RestitutionMix.Minimum => Math.Min(a, b),
            RestitutionMix.Product => a * b,
            _ => 0.5 * (a + b),
        };
    }

    /// <summary>The narrow phase of the pairs of a bundle.</summary>
    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="row">Names the pairs and their flags.</param>
    /// <param name="isNew">The pairs have no rows.</param>
    /// <param name="fates">What is to become of them.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Update(in ContactUpdateInput input, ContactBundle* row, bool isNew, out ContactFates fates)
    {
        PairBits bits = PairStage.Load(input, row);
        int dropped = FindDropped(input, row, bits);
        int fast = FindFast(bits, dropped);
        SweepBits sweep = fast == 0 ? default : FastPairs.Look(input);
        PairManifolds.Collide(input, row, bits);
        TouchBits touch = PairStage.Touch(input, row);
        Decide(input, row, bits, dropped, sweep, ref touch, isNew, out fates);
    }

    /// <summary>
    /// What is to become of the pairs of a bundle, or of two side by side. Bits of many fields are never handed over by value: a copy,
    /// which reads several of them at once, waits for those just written one by one.
    /// </summary>
    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="row">Names the pairs and their flags.</param>
    /// <param name="bits">What the sides are.</param>
    /// <param name="dropped">Pairs whose boxes came apart.</param>
    /// <param name="sweep">Where those go of which a body is fast.</param>
    /// <param name="touch">What the manifolds say.</param>
    /// <param name="isNew">The pairs have no rows.</param>
    /// <param name="fates">The fates.</param>
    private static void Decide(
        in ContactUpdateInput input,
        ContactBundle* row,
        in PairBits bits,
        int dropped,
        in SweepBits sweep,
        ref TouchBits touch,
        bool isNew,
        out ContactFates fates)
    {
        int fast = FindFast(bits, dropped);
        fates.Dropped = (ushort)dropped;
        int racing = 0;
        fates.Deferred = (ushort)(fast == 0 ? 0 : FastPairs.Defer(input, row, fast, sweep, ref touch, out racing));
        fates.Racing = (ushort)racing;

        int fresh = bits.Solid & touch.Hit & bits.Exists & ~dropped;
        if (isNew && fresh != 0)
        {
            GlancingContact.Drop(input, row, fresh, ref touch);
        }

        int hit = touch.Hit;
        int touching = touch.Touching;
        int due = bits.Heard == 0 ? 0 : FindDue(input, row, bits, touching, hit);
        int solid = bits.Solid & hit & bits.Exists & ~dropped & ~FindRefused(row, bits, due);
        fates.Solid = (ushort)solid;
        fates.Idle = (ushort)(bits.Exists & ~solid & ~dropped);
        fates.Blows = (ushort)(solid & touch.Blows);
        fates.Ahead = (ushort)(solid & touch.Ahead & ~fast);
        touching = ((touching & ~dropped) | (touch.Touched & dropped)) & bits.Exists;
        fates.Touching = (ushort)touching;
        fates.TouchingNow = (ushort)(touching & ~touch.Touched);
        fates.Heard = (ushort)(bits.Heard & bits.Exists);
        fates.Hulls = (ushort)(bits.Hulls & ~bits.Boxes & bits.Exists);
        // Flags hardly ever change, and each record is a cache line of its own: they are visited only if something is new.
        int news = bits.Exists & ~dropped & (~touch.Same | bits.Heard);
        for (int lane = 0; news != 0; lane++, news >>= 1)
        {
            if ((news & 1) == 0)
            {
                continue;
            }

            int bit = 1 << lane;
            ContactFlags flags = ((touching & bit) != 0 ? ContactFlags.Touching : ContactFlags.None)
                | ((bits.Solid & bit) != 0 ? ContactFlags.Solid : ContactFlags.None)
                | ((bits.Heard & bit) != 0
                    ? ContactFlags.Heard | ((ContactFlags)row->Flags[lane] & ContactFlags.Vetoed)
                    : ContactFlags.None)
                | ((due & bit) != 0 ? ContactFlags.Due : ContactFlags.None);
            if ((int)flags != (row->Flags[lane] & ContactBundle.FlagBits))
            {
                ContactLanes.SetFlags(row, lane, flags);
                input.Contacts.Records[row->Contact[lane]].Flags = flags;
            }

            if ((bits.Heard & bit) != 0)
            {
                input.Contacts.Manifolds[row->Contact[lane]] = PairLanes.Read(input.Pairs, lane);
            }
        }
    }

    /// <summary>The pairs of which a body is fast, but for those whose boxes came apart.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int FindFast(in PairBits bits, int dropped) => bits.Fast & bits.Exists & ~dropped;

    /// <summary>The pairs whose listeners are to be told: see <see cref="ContactFlags.Due"/>.</summary>
    private static int FindDue(in ContactUpdateInput input, ContactBundle* row, in PairBits bits, int touching, int hit)
    {
        float horizon = input.Dt + input.Coefficients.Substep;
        int due = touching & bits.Heard;
        int open = bits.Heard & bits.Solid & hit & ~touching;
        for (int lane = 0; open != 0; lane++, open >>= 1)
        {
            if ((open & 1) == 0)
            {
                continue;
            }

            // An impulse of the last step that its listeners were told of then is no news.
            bool wasDue = ((ContactFlags)row->Flags[lane] & ContactFlags.Due) != 0;
            bool struck = row->Struck[lane] > 0 || row->Point0.Normal[lane] > 0 || row->Point1.Normal[lane] > 0;
            if ((struck && !wasDue) || PairManifolds.WillTouch(input, lane, wasDue, horizon))
            {
                due |= 1 << lane;
            }
        }

        return due;
    }

    /// <summary>The pairs that a handler refused when last asked and that are not to be asked now.</summary>
    private static int FindRefused(ContactBundle* row, in PairBits bits, int due)
    {
        int refused = 0;
        int open = bits.Heard & ~due;
        for (int lane = 0; open != 0; lane++, open >>= 1)
        {
            if ((open & 1) != 0 && ((ContactFlags)row->Flags[lane] & ContactFlags.Vetoed) != 0)
            {
                refused |= 1 << lane;
            }
        }

        return refused;
    }

    /// <summary>The pairs whose fat boxes are new and have parted.</summary>
    private static int FindDropped(in ContactUpdateInput input, ContactBundle* row, in PairBits bits)
    {
        int dropped = 0;
        int lanes = bits.NewBox & bits.Exists;
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitSet.LowestBit((ulong)lanes);
            dropped |= (Box.Overlap(input.Fat[row->PieceA[lane]], input.Fat[row->PieceB[lane]]) ? 0 : 1) << lane;
        }

        return dropped;
    }

#if NET8_0_OR_GREATER
    /// <summary>Looks where the pairs of both bundles of a record go, of each only if one of its own is fast.</summary>
    private static SweepBits LookBoth(in ContactUpdateInput input, int fast)
    {
        SweepBits sweep = (fast & PairBits.OneBundle) != 0 ? FastPairs.Look(input) : default;
        if (PairBits.Of(fast, 1) != 0)
        {
            sweep.AddBeside(FastPairs.Look(Beside(input)), ContactBundle.Lanes);
        }

        return sweep;
    }

    /// <summary>The same input for the pairs of the second bundle of a record.</summary>
    private static ContactUpdateInput Beside(in ContactUpdateInput input)
    {
        ContactUpdateInput beside = input;
        beside.Pairs = PairLanes.Beside(input.Pairs);
        return beside;
    }
#endif
}
