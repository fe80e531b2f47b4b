using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Settings;

namespace Farseer.Engine.Contacts;

/// <summary>The turn of both bodies from the step's start to its middle, and what of their arms does not turn.</summary>
internal struct ArmTurn
{
    public Wide SinA;
    public Wide CosA;
    public Wide SinB;
    public Wide CosB;
    public Wide LeadA;
    public Wide LeadB;
    public Wide NormalSin;
    public Wide NormalCos;
    public Wide SpinA;
    public Wide SpinB;
    public Wide Slide;
    public Wide MostSlide;
    public Wide HalfStep;
    public Wide RadiusA;
    public Wide RadiusB;
}

/// <summary>
/// Turns manifolds into the lanes of a bundle: arms in the contact frame, responses, and the impulses of matching points.
/// </summary>
internal static unsafe class ContactRowWriter
{
    /// <summary>Below this share of k11·k22 the determinant is noise and the points are solved row by row.</summary>
    private const float DeterminantShare = 1e-3f;

    /// <summary>A corner is not foreseen to slide further than this share of the smaller piece: it may come to an end.</summary>
    private const float SlideShare = 0.25f;

    /// <summary>
    /// The least number with all its digits: bodies of 10¹⁹ kg have determinants below it, and are solved row by row as well.
    /// </summary>
    private const float LeastDeterminant = 1.17549435e-38f;

    /// <summary>
    /// An island is deep if a point is deeper than this share of the smaller piece beyond three static sags.
    /// </summary>
    private const float DeepShare = 0.02f;
    private const float DeepSags = 3f;

    /// <summary>
    /// What is deep stays so down to this share of what made it so. What is pushed apart is not corrected softly: down to a half, heaps
    /// that were jammed by one or two hundredths of their bodies stayed so, and awake, for good.
    /// </summary>
    private const float DeepEnd = 0.75f;

    /// <summary>
    /// Share of the smaller piece up to which the sags count: what a load presses in further than that is deep, whatever the load.
    /// </summary>
    private const float MostSag = 0.1f;

    /// <summary>
    /// Writes the constraints of a bundle from its manifolds. Lanes without a contact, and points that do not exist, become
    /// inert. Stored impulses are those of one substep and are scaled to this step's.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Write(in ContactUpdateInput input, ContactBundle* row)
    {
        PairLanes* pairs = input.Pairs;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            Wide count = Wide.Load(pairs->Count + lane);
            WideMask one = (count > Wide.Zero) & WideLanes.Has(
                Wide.Load((float*)pairs->A.Flags + lane) & Wide.Load((float*)pairs->B.Flags + lane), (int)SideFlags.Exists);
            WideMask two = one & (count > Wide.One);
            Wide.Zero.Store(row->Struck + lane);
            WideMask empty = Wide.SameBits(Wide.Load((float*)row->Contact + lane), Wide.FromBits(-1));
            ContactBundle.Mark(row, lane, (one & ~two) | empty, ContactBundle.SingleMark);
            WritePoints(input, row, lane, one, two);
            WriteMasses(pairs, row, lane);
            WriteResponses(row, lane, one, two);
            WriteMaterial(input, row, lane);
            WriteStiffness(input, row, lane, one, two);
        }

        if (input.Settings.FreezePairFriction)
        {
            FreezeFriction(input, row);
        }

        if (input.Contacts.Surfaces.IsOn)
        {
            TakeSurfaces(input.Contacts.Surfaces, row);
        }
    }

    /// <summary>What the bodies answer, anew: their masses in the row have changed.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void WriteResponses(ContactBundle* row)
    {
        Wide none = Wide.Splat(ContactBundle.NoPoint);
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            WriteResponses(row, lane, Wide.Load(row->Point0.Base + lane) < none, Wide.Load(row->Point1.Base + lane) < none);
        }
    }

    /// <summary>
    /// Takes the masses of bodies that no longer move out of the rows. (One that moves from now on has to wait for the next update of its
    /// rows: it may be in several lanes of a bundle.)
    /// </summary>
    /// <param name="row">The bundle.</param>
    /// <param name="moves">1 for a body that can move.</param>
    public static void HoldStill(ContactBundle* row, byte* moves)
    {
        bool any = false;
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            any |= HoldStill(moves[row->BodyA[lane]], ref row->MassA[lane], ref row->InertiaA[lane])
                | HoldStill(moves[row->BodyB[lane]], ref row->MassB[lane], ref row->InertiaB[lane]);
        }

        if (any)
        {
            WriteResponses(row);
        }
    }

    private static bool HoldStill(byte moves, ref float mass, ref float inertia)
    {
        if (moves != 0 || (mass == 0 && inertia == 0))
        {
            return false;
        }

        mass = 0;
        inertia = 0;
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void WritePoints(in ContactUpdateInput input, ContactBundle* row, int lane, WideMask one, WideMask two)
    {
        Wide id0 = Wide.Keep(one, Wide.Load((float*)input.Pairs->Point0.Id + lane));
        Wide id1 = Wide.Keep(two, Wide.Load((float*)input.Pairs->Point1.Id + lane));
        Wide old0 = Wide.Load((float*)row->Id0 + lane);
        Wide old1 = Wide.Load((float*)row->Id1 + lane);
        WideMask same0 = Wide.SameBits(id0, old0);
        WideMask same1 = Wide.SameBits(id1, old1);
        WideMask crossed0 = ~same0 & Wide.SameBits(id0, old1);
        WideMask crossed1 = Wide.SameBits(id1, old0);
        id0.Store((float*)row->Id0 + lane);
        id1.Store((float*)row->Id1 + lane);
        same1 = same1 & ~crossed1;
        if (input.LoadGrowth > 0)
        {
            Wide growth = Wide.Splat(input.LoadGrowth);
            GrowLoad(&row->Point0, lane, growth);
            GrowLoad(&row->Point1, lane, growth);
        }

        Wide scale = Wide.Splat(input.ImpulseScale);
        Carry(row->Point0.Normal + lane, row->Point1.Normal + lane, same0, crossed0, same1, crossed1, scale);
        Carry(row->Point0.Tangent + lane, row->Point1.Tangent + lane, same0, crossed0, same1, crossed1, scale);
        Carry(row->Point0.PreviousNormal + lane, row->Point1.PreviousNormal + lane, same0, crossed0, same1, crossed1, scale);
        Carry(row->Point0.PreviousTangent + lane, row->Point1.PreviousTangent + lane, same0, crossed0, same1, crossed1, scale);
        Carry(row->Point0.Feed + lane, row->Point1.Feed + lane, same0, crossed0, same1, crossed1, scale);
        Wide rest = ContactBundle.SetRestDepth(row, lane, RestDepth(input, lane));
        ArmTurn turn = Foresee(input, row, lane);
        turn.RadiusA = Radius(&input.Pairs->A, lane);
        turn.RadiusB = Radius(&input.Pairs->B, lane);
        turn.RadiusA.Store(row->RadiusA + lane);
        turn.RadiusB.Store(row->RadiusB + lane);
        WritePoint(&input.Pairs->Point0, &row->Point0, lane, one, rest, turn);
        WritePoint(&input.Pairs->Point1, &row->Point1, lane, two, rest, turn);
    }

    /// <summary>
    /// The middle of the step: how far both bodies have turned until then, and the normal, which turns with the face that it belongs to.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ArmTurn Foresee(in ContactUpdateInput input, ContactBundle* row, int lane)
    {
        PairLanes* pairs = input.Pairs;
        ArmTurn turn = default;
        WideForesight.Turn(Spin(&pairs->A, lane), input.Dt, out turn.LeadA, out Wide cosA);
        WideForesight.Turn(Spin(&pairs->B, lane), input.Dt, out turn.LeadB, out Wide cosB);
        Wide owner = Wide.Load(pairs->NormalOwner + lane);
        WideMask ofA = owner < Wide.Zero;
        WideMask ofB = owner > Wide.Zero;
        turn.NormalSin = Wide.Keep(ofA, turn.LeadA) + Wide.Keep(ofB, turn.LeadB);
        turn.NormalCos = Wide.Select(ofA, cosA, Wide.Select(ofB, cosB, Wide.One));
        turn.SinA = Wide.Keep(~ofA, (turn.LeadA * turn.NormalCos) - (cosA * turn.NormalSin));
        turn.CosA = Wide.Select(ofA, Wide.One, (cosA * turn.NormalCos) + (turn.LeadA * turn.NormalSin));
        turn.SinB = Wide.Keep(~ofB, (turn.LeadB * turn.NormalCos) - (cosB * turn.NormalSin));
        turn.CosB = Wide.Select(ofB, Wide.One, (cosB * turn.NormalCos) + (turn.LeadB * turn.NormalSin));
        Wide nx = Wide.Load(pairs->NormalX + lane);
        Wide ny = Wide.Load(pairs->NormalY + lane);
        ((turn.NormalCos * nx) - (turn.NormalSin * ny)).Store(row->NormalX + lane);
        ((turn.NormalCos * ny) + (turn.NormalSin * nx)).Store(row->NormalY + lane);
        WideMask movesA = WideLanes.Has(Wide.Load((float*)pairs->A.Flags + lane), (int)SideFlags.Turns);
        WideMask movesB = WideLanes.Has(Wide.Load((float*)pairs->B.Flags + lane), (int)SideFlags.Turns);
        turn.HalfStep = Wide.Splat(0.5f * input.Dt);
        turn.SpinA = Wide.Keep(movesA, Wide.Load(pairs->A.AngularVelocity + lane));
        turn.SpinB = Wide.Keep(movesB, Wide.Load(pairs->B.AngularVelocity + lane));
        turn.Slide = Wide.Keep(movesB, (Wide.Load(pairs->B.VelocityX + lane) * ny) - (Wide.Load(pairs->B.VelocityY + lane) * nx))
            - Wide.Keep(movesA, (Wide.Load(pairs->A.VelocityX + lane) * ny) - (Wide.Load(pairs->A.VelocityY + lane) * nx));
        turn.MostSlide = Wide.Splat(SlideShare) * Wide.Min(Wide.Load(pairs->A.Extent + lane), Wide.Load(pairs->B.Extent + lane));
        return turn;
    }

    /// <summary>
    /// A longer substep bears more of a load: of what lasted for two substeps, at most some times the feed-forward, which alone knows only
    /// the lesser of two points. Whole impulses in proportion would repeat blows as much harder, and the little that sweeps have not
    /// settled: a stack of ten boxes leapt by 20 m when steps of 1/300 and 1/30 s took turns. Without it loads sink, and boxes creep down
    /// slopes.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GrowLoad(ContactPointLanes* point, int lane, Wide growth)
    {
        Wide feed = Wide.Load(point->Feed + lane);
        Wide normal = Wide.Load(point->Normal + lane);
        Wide previous = Wide.Load(point->PreviousNormal + lane);
        Wide tangent = Wide.Load(point->Tangent + lane);
        Wide previousTangent = Wide.Load(point->PreviousTangent + lane);
        Wide most = Wide.Splat(ContactCoefficients.LoadInFeeds) * Wide.Max(feed, Wide.Zero);
        Wide more = growth * Wide.Min(Wide.Min(normal, previous), most);
        Wide rub = Wide.Select(feed > Wide.Zero, growth, Wide.Zero);
        (feed + (growth * feed)).Store(point->Feed + lane);
        (normal + more).Store(point->Normal + lane);
        (previous + more).Store(point->PreviousNormal + lane);
        (tangent + (rub * tangent)).Store(point->Tangent + lane);
        (previousTangent + (rub * previousTangent)).Store(point->PreviousTangent + lane);
    }

    /// <summary>Impulses follow their point by its id: into the same place, or crosswise.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Carry(float* first, float* second, WideMask same0, WideMask crossed0, WideMask same1, WideMask crossed1, Wide scale)
    {
        Wide old0 = Wide.Load(first) * scale;
        Wide old1 = Wide.Load(second) * scale;
        (Wide.Keep(same0, old0) | Wide.Keep(crossed0, old1)).Store(first);
        (Wide.Keep(same1, old1) | Wide.Keep(crossed1, old0)).Store(second);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Spin(SideLanes* side, int lane) => Wide.Keep(
        WideLanes.Has(Wide.Load((float*)side->Flags + lane), (int)SideFlags.Turns), Wide.Load(side->AngularVelocity + lane));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Radius(SideLanes* side, int lane) =>
        Wide.Keep(~WideLanes.Has(Wide.Load((float*)side->Flags + lane), (int)SideFlags.Box), Wide.Load(side->HalfX + lane));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void WritePoint(
        PointLanes* source, ContactPointLanes* point, int lane, WideMask exists, Wide rest, in ArmTurn turn)
    {
        // Where the surfaces are still apart they push when they have met: each body then at its own surface, not midway.
        Wide separation = Wide.Load(source->Separation + lane);
        Wide half = Wide.Splat(0.5f) * Wide.Max(separation, Wide.Zero);
        Wide anA = Wide.Load(source->NormalArmA + lane) - half - turn.RadiusA;
        Wide anB = Wide.Load(source->NormalArmB + lane) + half + turn.RadiusB;
        Wide atA = Wide.Load(source->TangentArmA + lane);
        Wide atB = Wide.Load(source->TangentArmB + lane);
        Wide.Keep(exists, (turn.CosA * anA) + (turn.SinA * atA)).Store(point->NormalArmA + lane);
        Wide.Keep(exists, (turn.CosB * anB) + (turn.SinB * atB)).Store(point->NormalArmB + lane);

        // A corner of one body goes along with it; in the other its arm grows by what the surfaces slide.
        Wide owner = Wide.Load(source->Owner + lane);
        Wide slide = turn.HalfStep * (turn.Slide + ((turn.SpinA * anA) - (turn.SpinB * anB)));
        slide = Wide.Max(Wide.Min(slide, turn.MostSlide), Wide.Zero - turn.MostSlide);
        Wide slideA = Wide.Keep(owner > Wide.Zero, slide);
        Wide slideB = Wide.Keep(owner < Wide.Zero, slide);
        Wide.Keep(exists, ((turn.CosA * atA) - (turn.SinA * anA)) + slideA).Store(point->TangentArmA + lane);
        Wide.Keep(exists, ((turn.CosB * atB) - (turn.SinB * anB)) - slideB).Store(point->TangentArmB + lane);

        // Half a step before its middle the separation is to be what it is.
        Wide lessA = (anA * (Wide.One - turn.NormalCos)) + (atA * turn.NormalSin) + (turn.LeadA * slideA);
        Wide lessB = (anB * (Wide.One - turn.NormalCos)) + (atB * turn.NormalSin) - (turn.LeadB * slideB);
        Wide start = ((separation + rest) - (anB - anA)) + (lessB - lessA);
        Wide.Select(exists, start, Wide.Splat(ContactBundle.NoPoint)).Store(point->Base + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void WriteMasses(PairLanes* pairs, ContactBundle* row, int lane)
    {
        Wide.Load(pairs->A.InverseMass + lane).Store(row->MassA + lane);
        Wide.Load(pairs->A.InverseInertia + lane).Store(row->InertiaA + lane);
        Wide.Load(pairs->B.InverseMass + lane).Store(row->MassB + lane);
        Wide.Load(pairs->B.InverseInertia + lane).Store(row->InertiaB + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void WriteResponses(ContactBundle* row, int lane, WideMask one, WideMask two)
    {
        Wide iA = Wide.Load(row->InertiaA + lane);
        Wide iB = Wide.Load(row->InertiaB + lane);
        Wide m = Wide.Load(row->MassA + lane) + Wide.Load(row->MassB + lane);
        Wide atA0 = Wide.Load(row->Point0.TangentArmA + lane);
        Wide atB0 = Wide.Load(row->Point0.TangentArmB + lane);
        Wide atA1 = Wide.Load(row->Point1.TangentArmA + lane);
        Wide atB1 = Wide.Load(row->Point1.TangentArmB + lane);
        Wide k11 = m + (iA * atA0 * atA0) + (iB * atB0 * atB0);
        Wide k22 = m + (iA * atA1 * atA1) + (iB * atB1 * atB1);

        // Of two bodies that a callback has just taken out of motion neither answers: as in an empty lane nothing is to divide by that.
        k11 = Wide.Select(one & (k11 > Wide.Zero), k11, Wide.One);
        k22 = Wide.Select(two & (k22 > Wide.Zero), k22, k11);
        Wide k12 = Wide.Keep(two, m + (iA * atA0 * atA1) + (iB * atB0 * atB1));
        Wide determinant = (k11 * k22) - (k12 * k12);
        WideMask block = two & (determinant > Wide.Max(Wide.Splat(DeterminantShare) * k11 * k22, Wide.Splat(LeastDeterminant)));
        k11.Store(row->K11 + lane);
        k22.Store(row->K22 + lane);
        ContactBundle.Mark(row, lane, block, ContactBundle.BlockMark);
        ContactBundle.Mark(row, lane, FarSurfaces.AreFar(row, lane, m), ContactBundle.FarMark);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void WriteMaterial(in ContactUpdateInput input, ContactBundle* row, int lane)
    {
        PairLanes* pairs = input.Pairs;
        Wide half = Wide.Splat(0.5f);
        Wide frictionA = Wide.Load(pairs->A.Friction + lane);
        Wide frictionB = Wide.Load(pairs->B.Friction + lane);
        Wide friction = input.Settings.FrictionMix switch
        {
            FrictionMix.Minimum => Wide.Min(frictionA, frictionB),
            FrictionMix.GeometricMean => Wide.Sqrt(frictionA * frictionB),
            FrictionMix.Maximum => Wide.Max(frictionA, frictionB),
            FrictionMix.Product => frictionA * frictionB,
            _ => (frictionA + frictionB) * half,
        };
        friction.Store(row->Friction + lane);
        Wide restitutionA = Wide.Load(pairs->A.Restitution + lane);
        Wide restitutionB = Wide.Load(pairs->B.Restitution + lane);
        Wide restitution = input.Settings.RestitutionMix switch
        {
            RestitutionMix.Maximum => Wide.Max(restitutionA, restitutionB),
            RestitutionMix.Minimum => Wide.Min(restitutionA, restitutionB),
            RestitutionMix.Product => restitutionA * restitutionB,
            _ => (restitutionA + restitutionB) * half,
        };
        restitution.Store(row->Restitution + lane);
    }

    /// <summary>How deep in each other the surfaces rest: as far as is allowed, and never so far that it would show.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide RestDepth(in ContactUpdateInput input, int lane)
    {
        Wide size = Wide.Splat(2f) * Wide.Min(Wide.Load(input.Pairs->A.Extent + lane), Wide.Load(input.Pairs->B.Extent + lane));
        return Wide.Min(Wide.Splat(input.Settings.AllowedPenetration), Wide.Splat(input.Settings.AllowedPenetrationShare) * size);
    }

    /// <summary>How fully the load is fed forward, and deepness.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void WriteStiffness(in ContactUpdateInput input, ContactBundle* row, int lane, WideMask one, WideMask two)
    {
        PairLanes* pairs = input.Pairs;
        Wide rest = ContactBundle.RestDepth(row, lane);
        Wide depth = Wide.Zero - Wide.Load(pairs->Point0.Separation + lane);
        depth = Wide.Select(two, Wide.Max(depth, Wide.Zero - Wide.Load(pairs->Point1.Separation + lane)), depth) - rest;
        Wide size = Wide.Splat(2f) * Wide.Min(Wide.Load(pairs->A.Extent + lane), Wide.Load(pairs->B.Extent + lane));
        WideCoefficients.FeedShare(input.Coefficients, size).Store(row->FeedShare + lane);
        Wide load = Wide.Max(
            Wide.Load(row->Point0.Normal + lane) * Wide.Load(row->K11 + lane),
            Wide.Load(row->Point1.Normal + lane) * Wide.Load(row->K22 + lane));
        Wide limit = Wide.Splat(DeepShare) * size;
        Wide sags = Wide.Splat(DeepSags) * WideCoefficients.Sag(input.Coefficients, load);
        limit = limit + Wide.Min(sags, Wide.Splat(MostSag) * size);
        WideMask deep = depth > limit;
        if (!input.Settings.CorrectPositions)
        {
            // What is deep is held hard where it is, and its overlap goes in a pass of its own, which is left out then.
            deep = WideLanes.AllSet;
        }

        WideMask still = ContactBundle.Has(row, lane, ContactBundle.DeepMark) & (depth > Wide.Splat(DeepEnd) * limit);
        ContactBundle.Mark(row, lane, one & (deep | still), ContactBundle.DeepMark);
    }

    /// <summary>Coefficients of pairs that have surfaces of their own.</summary>
    private static void TakeSurfaces(PairSurfaces surfaces, ContactBundle* row)
    {
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            int contact = row->Contact[lane];
            if (contact >= 0 && surfaces[contact].IsSet != 0)
            {
                // What a pass of its own rubs, the row must not.
                row->Friction[lane] = surfaces[contact].IsSpecial ? 0 : surfaces[contact].Friction;
                row->Restitution[lane] = surfaces[contact].Restitution;
            }
        }
    }

    /// <summary>A quirk of the original: the friction of a pair stays what it was when the pair was made.</summary>
    private static void FreezeFriction(in ContactUpdateInput input, ContactBundle* row)
    {
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            if (row->Contact[lane] >= 0)
            {
                row->Friction[lane] = input.Contacts.FirstFriction[row->Contact[lane]];
            }
        }
    }
}
