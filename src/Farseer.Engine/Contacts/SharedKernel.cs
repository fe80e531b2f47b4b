using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// The passes over rows of which many have one heavy body: a drum, a rotor, a ram. Those of a bundle are solved side by side from the same
/// velocities, and what each changes of the velocities of its bodies is added to them, lane after lane, so that the order of vectors and
/// their width mean nothing and no momentum is lost. To the next bundle the heavy body has moved on.
/// </summary>
/// <remarks>
/// A lane does not see what the others do to the heavy body at the same time. With the answers h of that one and l of the light ones to an
/// impulse, its relative velocity is off by h/(h + l) of what each other lane takes from its own: with l at least 64 h and seven others by
/// a ninth at most, where all push against each other, and in the next pass by a ninth of that. One after the other, as rows of the
/// overflow are, they were a third of the passes of a tumbler (docs/decisions/017).
/// </remarks>
internal static unsafe class SharedKernel
{
    /// <summary>Runs a pass, a bundle at a time.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Run(in ContactPass pass, in BundleList rows)
    {
        byte* memory = stackalloc byte[ContactWork.Bytes];
        ContactWork* work = ContactWork.In(memory);
        for (int i = 0; i < rows.Count; i++)
        {
            ContactBundle** at = rows.Bundles + i;
            ContactBundle* row = *at;
            switch (pass.Kind)
            {
                case ContactPassKind.WarmStart:
                    WarmStart(row, work, pass);
                    break;
                case ContactPassKind.Biased:
                    SolveBiased(rows, at, work, pass);
                    break;
                case ContactPassKind.PushOut when ContactBundle.LanesWith(row, ContactBundle.DeepMark) == 0:
                    continue;
                case ContactPassKind.PushOut:
                    PushOut(rows, at, work, pass);
                    break;
                case ContactPassKind.Relax:
                    Relax(rows, at, work, pass);
                    break;
            }

            Add(row, ChangesOf(work), pass.States);
        }
    }

    /// <summary>What the stages find stands in the first work, what changes in the one behind it.</summary>
    private static ContactWork* ChangesOf(ContactWork* work) => work + 1;

    private static void WarmStart(ContactBundle* row, ContactWork* work, in ContactPass pass)
    {
        Wide fall = Wide.Splat(pass.Coefficients.Gravity * pass.Coefficients.Substep);
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            BodyLanes.GatherVelocities(pass.States, row->BodyA + lane, row->BodyB + lane, out WideVelocity a, out WideVelocity b);
            ContactWork.Keep(ChangesOf(work), lane, a, b);
            ContactKernel.ApplyStart<TwoPoints>(row, lane, pass.Coefficients, fall, ref a, ref b);
            KeepChange(ChangesOf(work), lane, a, b);
        }
    }

    private static void SolveBiased(in BundleList rows, ContactBundle** at, ContactWork* work, in ContactPass pass)
    {
        ContactStages.AimBiased<TwoPoints>(rows, at, 1, work, pass.States, pass.Coefficients, pass.Flag);
        KeepStart(work);
        ulong blows = Push(at, work, pass, onlyUnfed: true, feed: false);
        KeepPushed(*at, work, blows);
    }

    private static void PushOut(in BundleList rows, ContactBundle** at, ContactWork* work, in ContactPass pass)
    {
        ContactStages.AimApart<TwoPoints>(rows, at, 1, work, pass.States, pass.Coefficients, pass.Rate);
        KeepStart(work);
        ContactStages.PushApart<TwoPoints>(at, 1, work);
        KeepPushed(*at, work, blows: 0);
    }

    private static void Relax(in BundleList rows, ContactBundle** at, ContactWork* work, in ContactPass pass)
    {
        ContactStages.AimRelaxed<TwoPoints>(rows, at, 1, work, pass.States, pass.Coefficients);
        KeepStart(work);
        ulong blows = Push(at, work, pass, onlyUnfed: pass.First, feed: true);
        if (!pass.Flag)
        {
            KeepPushed(*at, work, blows);
            return;
        }

        ContactStages.Rub<TwoPoints>(at, 1, work, blows);
        if (blows != 0)
        {
            BlowKernel.Rub(at, 1, work, pass.States, blows);
        }

        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            ContactStages.TakeRubbed(
                *at, lane, work, (blows & ContactWork.Bit(0, lane)) != 0, out WideVelocity a, out WideVelocity b, two: true);
            KeepChange(ChangesOf(work), lane, a, b);
        }
    }

    private static ulong Push(ContactBundle** at, ContactWork* work, in ContactPass pass, bool onlyUnfed, bool feed)
    {
        ulong blows = ContactStages.Push<TwoPoints>(at, null, 1, work, onlyUnfed, feed);
        return blows == 0 ? 0 : BlowKernel.Strike(at, 1, work, pass.States, blows);
    }

    private static void KeepPushed(ContactBundle* row, ContactWork* work, ulong blows)
    {
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            ContactStages.TakePushed(
                row, lane, work, (blows & ContactWork.Bit(0, lane)) != 0, out WideVelocity a, out WideVelocity b, two: true);
            KeepChange(ChangesOf(work), lane, a, b);
        }
    }

    /// <summary>Friction writes over the velocities that the first stage has read.</summary>
    private static void KeepStart(ContactWork* work)
    {
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            ContactWork.Take(work, lane, out WideVelocity a, out WideVelocity b);
            ContactWork.Keep(ChangesOf(work), lane, a, b);
        }
    }

    /// <summary>In place of the velocities before, by how much those now are others.</summary>
    private static void KeepChange(ContactWork* changes, int lane, WideVelocity a, WideVelocity b)
    {
        ContactWork.Take(changes, lane, out WideVelocity startA, out WideVelocity startB);
        ContactWork.Keep(changes, lane, Change(startA, a), Change(startB, b));
    }

    private static WideVelocity Change(in WideVelocity from, in WideVelocity to)
    {
        WideVelocity change;
        change.X = to.X - from.X;
        change.Y = to.Y - from.Y;
        change.W = to.W - from.W;
        return change;
    }

    private static void Add(ContactBundle* row, ContactWork* changes, BodyState* bodies)
    {
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            if (row->MassA[lane] + row->InertiaA[lane] > 0)
            {
                *BodyState.VelocityOf(bodies + row->BodyA[lane]) +=
                    new Vector4(changes->VelocityAX[lane], changes->VelocityAY[lane], changes->SpinA[lane], 0);
            }

            if (row->MassB[lane] + row->InertiaB[lane] > 0)
            {
                *BodyState.VelocityOf(bodies + row->BodyB[lane]) +=
                    new Vector4(changes->VelocityBX[lane], changes->VelocityBY[lane], changes->SpinB[lane], 0);
            }
        }
    }
}
