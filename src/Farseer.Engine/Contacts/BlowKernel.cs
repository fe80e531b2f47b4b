using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// A blow, the first push of a contact, comes at one moment of the step and turns bodies at the arms of that moment. The passes push at
/// the arms of the middle of the step: for what goes on pushing their mean is what counts, and that K and the arms agree is what makes
/// the block solve exact (with turned arms a box that tips over its corner ended 5e-4 rad/s off, at 5 substeps, in place of 1.2e-4). But a
/// box that fell on its corner at the step's end got a tenth too little spin so. Here is what a blow lacks. Few bundles have one, so this
/// stands outside of the passes.
/// </summary>
internal static unsafe class BlowKernel
{
    /// <summary>
    /// A response with the arms of the moment, in units of that with the middle's, beyond which a blow keeps the middle's: K does not fit
    /// any more, and at 2 a pass would not take any of the error off. Where arms are not turned along further (see
    /// <see cref="TurnedArms"/>) it keeps them as well: what the biased pass pushes and the relax pass takes back would act at arms so far
    /// apart that they leave spin behind. A wall that broke at 200 m/s sent bricks off at 290.
    /// </summary>
    private const float LargestResponse = 1.5f;

    /// <summary>What the spins of some bundles lack after normal impulses were applied at the arms of the middle.</summary>
    /// <returns>Those of the <paramref name="blows"/> that are some.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static ulong Strike(ContactBundle** some, int count, ContactWork* work, BodyState* bodies, ulong blows)
    {
        ulong fresh = 0;
        ContactMoved* moved = ContactWork.Moved(work);
        for (int i = 0; i < count; i++, work++)
        {
            ContactBundle* row = some[i];
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                ulong bit = ContactWork.Bit(i, lane);
                if ((blows & bit) != 0 && WideLanes.Any(Fresh(row, lane, work)))
                {
                    fresh |= bit;
                    StrikeLanes(row, lane, work, moved + i, bodies);
                }
            }
        }

        return fresh;
    }

    /// <summary>The same for friction impulses.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Rub(ContactBundle** some, int count, ContactWork* work, BodyState* bodies, ulong blows)
    {
        ContactMoved* moved = ContactWork.Moved(work);
        for (int i = 0; i < count; i++, work++)
        {
            ContactBundle* row = some[i];
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                if ((blows & ContactWork.Bit(i, lane)) != 0)
                {
                    RubLanes(row, lane, work, moved + i, bodies);
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StrikeLanes(ContactBundle* row, int lane, ContactWork* work, ContactMoved* moved, BodyState* bodies)
    {
        ContactStages.GatherMoved(row, lane, moved, bodies, out WideDelta movedA, out WideDelta movedB);
        Wide a0 = Turn(row->Point0.TangentArmA + lane, row->Point0.NormalArmA + lane, movedA.Cos, Wide.Zero - movedA.Sin);
        Wide b0 = Turn(row->Point0.TangentArmB + lane, row->Point0.NormalArmB + lane, movedB.Cos, Wide.Zero - movedB.Sin);
        Wide a1 = Turn(row->Point1.TangentArmA + lane, row->Point1.NormalArmA + lane, movedA.Cos, Wide.Zero - movedA.Sin);
        Wide b1 = Turn(row->Point1.TangentArmB + lane, row->Point1.NormalArmB + lane, movedB.Cos, Wide.Zero - movedB.Sin);
        WideMask blow = Fresh(row, lane, work) & TurnedArms.AreWithin(movedA, movedB)
            & Fits(row, lane, Wide.One / Wide.Load(row->K11 + lane), a0, b0)
            & Fits(row, lane, Wide.One / Wide.Load(row->K22 + lane), a1, b1);
        Wide more0 = Wide.Keep(blow, Wide.Load(work->Value0 + lane));
        Wide more1 = Wide.Keep(blow, Wide.Load(work->Value1 + lane));
        Wide spinA = Wide.Load(row->InertiaA + lane)
            * (((Wide.Load(row->Point0.TangentArmA + lane) - a0) * more0) + ((Wide.Load(row->Point1.TangentArmA + lane) - a1) * more1));
        Wide spinB = Wide.Load(row->InertiaB + lane)
            * (((b0 - Wide.Load(row->Point0.TangentArmB + lane)) * more0) + ((b1 - Wide.Load(row->Point1.TangentArmB + lane)) * more1));
        Store(work, lane, blow, spinA, spinB);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void RubLanes(ContactBundle* row, int lane, ContactWork* work, ContactMoved* moved, BodyState* bodies)
    {
        ContactStages.GatherMoved(row, lane, moved, bodies, out WideDelta movedA, out WideDelta movedB);
        Wide radiusA = Wide.Load(row->RadiusA + lane);
        Wide radiusB = Wide.Load(row->RadiusB + lane);
        Wide a0 = Turn(row->Point0.NormalArmA + lane, row->Point0.TangentArmA + lane, movedA.Cos, movedA.Sin);
        Wide b0 = Turn(row->Point0.NormalArmB + lane, row->Point0.TangentArmB + lane, movedB.Cos, movedB.Sin);
        Wide a1 = Turn(row->Point1.NormalArmA + lane, row->Point1.TangentArmA + lane, movedA.Cos, movedA.Sin);
        Wide b1 = Turn(row->Point1.NormalArmB + lane, row->Point1.TangentArmB + lane, movedB.Cos, movedB.Sin);
        WideMask blow = Fresh(row, lane, work) & TurnedArms.AreWithin(movedA, movedB)
            & Fits(row, lane, ContactFriction.TangentMass(row, &row->Point0, lane), a0 + radiusA, b0 - radiusB)
            & Fits(row, lane, ContactFriction.TangentMass(row, &row->Point1, lane), a1 + radiusA, b1 - radiusB);
        Wide more0 = Wide.Keep(blow, Wide.Load(work->Value0 + lane));
        Wide more1 = Wide.Keep(blow, Wide.Load(work->Value1 + lane));
        Wide spinA = Wide.Load(row->InertiaA + lane)
            * (((a0 - Wide.Load(row->Point0.NormalArmA + lane)) * more0) + ((a1 - Wide.Load(row->Point1.NormalArmA + lane)) * more1));
        Wide spinB = Wide.Load(row->InertiaB + lane)
            * (((Wide.Load(row->Point0.NormalArmB + lane) - b0) * more0) + ((Wide.Load(row->Point1.NormalArmB + lane) - b1) * more1));
        Store(work, lane, blow, spinA, spinB);
    }

    /// <summary>No lane gets another bit because one beside it is struck.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(ContactWork* work, int lane, WideMask blow, Wide spinA, Wide spinB)
    {
        Wide.Select(blow, spinA, Wide.Splat(-0f)).Store(work->BlowA + lane);
        Wide.Select(blow, spinB, Wide.Splat(-0f)).Store(work->BlowB + lane);
    }

    /// <summary>Lanes that may be struck and whose contact did not push before this substep.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask Fresh(ContactBundle* row, int lane, ContactWork* work) =>
        ((Wide.Load(row->Point0.PreviousNormal + lane) + Wide.Load(row->Point1.PreviousNormal + lane)) <= Wide.Zero)
            & (Wide.Load(work->MayBlow + lane) > Wide.Zero);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Turn(float* along, float* across, Wide cos, Wide sin) => (cos * Wide.Load(along)) + (sin * Wide.Load(across));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask Fits(ContactBundle* row, int lane, Wide inverse, Wide armA, Wide armB)
    {
        Wide mass = Wide.Load(row->MassA + lane) + Wide.Load(row->MassB + lane);
        Wide now = mass + (Wide.Load(row->InertiaA + lane) * armA * armA) + (Wide.Load(row->InertiaB + lane) * armB * armB);
        return (inverse * now) <= Wide.Splat(LargestResponse);
    }
}
