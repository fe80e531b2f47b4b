using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>What the update of contacts reads: columns and the numbers of this step.</summary>
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

    /// <summary>By how much a longer substep exceeds the last one, as a share of that: loads, which the feed-forward tells, grow with it.</summary>
    public float LoadGrowth;
    public ContactCoefficients Coefficients;
}

/// <summary>What is to become of the pairs of a bundle after their update, a bit for each lane.</summary>
internal struct ContactFates
{
    /// <summary>The boxes came apart: the pair is forgotten.</summary>
    public byte Dropped;

    /// <summary>Has points and gives impulses: belongs into the graph.</summary>
    public byte Solid;

    /// <summary>Those of the other pairs, which do not.</summary>
    public byte Idle;
    public byte Touching;

    /// <summary>Touches now and did not before.</summary>
    public byte TouchingNow;
    public byte Heard;

    /// <summary>Gives impulses and will be struck: see <see cref="PairStage.BlowShare"/>.</summary>
    public byte Blows;

    /// <summary>Those that the kernel of hulls does, which takes several times as long as that of boxes or circles.</summary>
    public byte Hulls;

    /// <summary>Those of the idle pairs of which the impact, if there is one, must be looked for along the way.</summary>
    public byte Deferred;

    /// <summary>Those that touch and of which one moves fast past the other; both can move.</summary>
    public byte Racing;
}

/// <summary>
/// The narrow phase of the pairs of a bundle, and the rewriting of its rows. Tolerances come from the motion of a step and from
/// the pieces' own extents, never from a unit of length.
/// </summary>
internal static unsafe class ContactUpdate
{
    /// <summary>Updates the pairs of a bundle of the graph and rewrites their constraints.</summary>
    public static ContactFates UpdateRows(in ContactUpdateInput input, ContactBundle* row)
    {
        PairBits bits = PairStage.Load(input, row);
        ContactFates fates = Update(input, row, bits, isNew: false);
        ContactRowWriter.Write(input, row);
        return fates;
    }

    /// <summary>Updates pairs without rows.</summary>
    public static ContactFates UpdateIdle(in ContactUpdateInput input, ContactBundle* row)
    {
        PairBits bits = PairStage.Load(input, row);
        return Update(input, row, bits, isNew: true);
    }

    /// <summary>
    /// Looks again at pairs without rows beside a body that is struck in this step, as far as it may be thrown.
    /// </summary>
    /// <returns>Those that are to get a row, a bit for each lane.</returns>
    public static int FindStruck(in ContactUpdateInput input, ContactBundle* row)
    {
        PairBits bits = PairStage.Load(input, row);
        int lanes = bits.Solid & bits.Exists & ~bits.Fast;
        if (lanes == 0)
        {
            return 0;
        }

        PairStage.Widen(input, row);
        PairStage.Collide(input, row, bits);
        TouchBits touch = PairStage.Touch(input, row);
        lanes &= touch.Hit;
        GlancingContact.Drop(input, row, lanes, ref touch);
        return lanes & touch.Hit & ~FindRefused(row, bits, 0);
    }

    /// <summary>
    /// Writes the constraints of pairs that have just been given a place in the graph. Their manifolds are found again: to keep those of all
    /// pairs for the few that get a row was a tenth of what a body kept, and no quicker.
    /// </summary>
    public static void FillRows(in ContactUpdateInput input, ContactBundle* row)
    {
        PairBits bits = PairStage.Load(input, row);
        PairStage.Widen(input, row);
        if ((bits.Fast & bits.Exists) != 0)
        {
            FastPairs.Look(input);
        }

        PairStage.Collide(input, row, bits);
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
    /// <returns>False if it has no points, or would meet by what they say: a corner that the body passes, or the side of something in its way.</returns>
    public static bool TryFillBeside(in ContactUpdateInput input, ContactBundle* row)
    {
        PairBits bits = PairStage.Load(input, row);
        FastPairs.Look(input);
        PairStage.Collide(input, row, bits);
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
            _ => (a + b) * 0.5f,
        };
    }

    public static double MixRestitution(ShapeStore shapes, RestitutionMix mix, in ContactRecord record)
    {
        double a = shapes.ColliderAt(record.PieceA).Restitution;
        double b = shapes.ColliderAt(record.PieceB).Restitution;
        return mix == RestitutionMix.Maximum ? Math.Max(a, b) : 0.5 * (a + b);
    }

    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="row">Names the pairs and their flags.</param>
    /// <param name="bits">What the sides are.</param>
    /// <param name="isNew">The pairs have no rows.</param>
    private static ContactFates Update(in ContactUpdateInput input, ContactBundle* row, in PairBits bits, bool isNew)
    {
        ContactFates fates;
        int dropped = (bits.NewBox & bits.Exists) == 0 ? 0 : FindDropped(input, row, bits.NewBox & bits.Exists);
        fates.Dropped = (byte)dropped;
        int fast = bits.Fast & bits.Exists & ~dropped;
        SweepBits sweep = fast == 0 ? default : FastPairs.Look(input);
        PairStage.Collide(input, row, bits);
        TouchBits touch = PairStage.Touch(input, row);
        int racing = 0;
        fates.Deferred = (byte)(fast == 0 ? 0 : FastPairs.Defer(input, row, fast, sweep, ref touch, out racing));
        fates.Racing = (byte)racing;

        int fresh = bits.Solid & touch.Hit & bits.Exists & ~dropped;
        if (isNew && fresh != 0)
        {
            GlancingContact.Drop(input, row, fresh, ref touch);
        }

        int hit = touch.Hit;
        int touching = touch.Touching;
        int due = bits.Heard == 0 ? 0 : FindDue(input, row, bits, touching, hit);
        int solid = bits.Solid & hit & bits.Exists & ~dropped & ~FindRefused(row, bits, due);
        fates.Solid = (byte)solid;
        fates.Idle = (byte)(bits.Exists & ~solid & ~dropped);
        fates.Blows = (byte)(solid & touch.Blows);
        touching = ((touching & ~dropped) | (touch.Touched & dropped)) & bits.Exists;
        fates.Touching = (byte)touching;
        fates.TouchingNow = (byte)(touching & ~touch.Touched);
        fates.Heard = (byte)(bits.Heard & bits.Exists);
        fates.Hulls = (byte)(bits.Hulls & ~bits.Boxes & bits.Exists);
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
                | ((bits.Heard & bit) != 0 ? ContactFlags.Heard | ((ContactFlags)row->Flags[lane] & ContactFlags.Vetoed) : ContactFlags.None)
                | ((due & bit) != 0 ? ContactFlags.Due : ContactFlags.None);
            if ((int)flags != (row->Flags[lane] & ContactBundle.FlagBits))
            {
                ContactRowWriter.SetFlags(row, lane, flags);
                input.Contacts.Records[row->Contact[lane]].Flags = flags;
            }

            if ((bits.Heard & bit) != 0)
            {
                input.Contacts.Manifolds[row->Contact[lane]] = PairLanes.Read(input.Pairs, lane);
            }
        }

        return fates;
    }

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
            if ((struck && !wasDue) || PairStage.WillTouch(input, lane, wasDue ? input.Settings.AllowedPenetration : 0, horizon))
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

    private static int FindDropped(in ContactUpdateInput input, ContactBundle* row, int lanes)
    {
        int dropped = 0;
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitSet.LowestBit((ulong)lanes);
            dropped |= (Box.Overlap(input.Fat[row->PieceA[lane]], input.Fat[row->PieceB[lane]]) ? 0 : 1) << lane;
        }

        return dropped;
    }
}
