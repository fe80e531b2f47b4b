using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <content>The impacts of a round: those of one moment that share a body are solved in turns.</content>
internal sealed unsafe partial class ImpactPass
{
    private void Sweep(BodyStore bodies, in ContactCoefficients c)
    {
        int lanes = 0;
        for (int i = 0; i < _hits.Count; i++)
        {
            lanes += BitSet.CountBits((uint)_bounces[_hits[i]].Hits);
        }

        int sweeps = lanes > 1 ? BounceKernel.Sweeps : 1;
        for (int sweep = 0; sweep < sweeps; sweep++)
        {
            _visits += _hits.Count;
            for (int i = 0; i < _hits.Count; i++)
            {
                BounceLanes* bounce = _bounces.Pointer + _hits[i];
                if (sweep == 0 && bounce->Heavy != 0)
                {
                    int now = BounceKernel.Find(bounce, bodies.State.Pointer, bodies.Motion.Pointer, c, bounce->Heavy, onlyHeld: false);
                    bounce->Hits &= now | ~bounce->Heavy;
                    bounce->Heavy = 0;
                }

                if (bounce->Hits != 0)
                {
                    BounceKernel.Apply(bounce, bodies.State.Pointer, bodies.Motion.Pointer, c);
                }
            }

            if (sweep == 0 && sweeps > 1)
            {
                KeepShared();
                sweeps = Math.Min(sweeps, Math.Max(LeastSweeps, SweepVisits / Math.Max(_hits.Count, 1)));
            }
        }
    }

    /// <summary>The lanes of these impacts in which one of two bodies that move takes no noticeable part.</summary>
    private static int HeavyLanes(ContactBundle* row, int hits)
    {
        int heavy = 0;
        for (int lane = 0; hits >> lane != 0; lane++)
        {
            bool moveBoth = row->MassA[lane] + row->InertiaA[lane] > 0 && row->MassB[lane] + row->InertiaB[lane] > 0;
            heavy |= moveBoth && !(YieldsA(row, lane) && YieldsB(row, lane)) ? 1 << lane : 0;
        }

        return heavy & hits;
    }

    /// <summary>Body A takes a noticeable part in the response of an impact.</summary>
    private static bool YieldsA(ContactBundle* row, int lane)
    {
        float arm = row->Point0.TangentArmA[lane];
        return row->MassA[lane] + (row->InertiaA[lane] * arm * arm) > Heavy * row->K11[lane];
    }

    private static bool YieldsB(ContactBundle* row, int lane)
    {
        float arm = row->Point0.TangentArmB[lane];
        return row->MassB[lane] + (row->InertiaB[lane] * arm * arm) > Heavy * row->K11[lane];
    }

    /// <summary>What shares no body with another impact has been solved by the first sweep, whatever happens elsewhere meanwhile.</summary>
    private void KeepShared()
    {
        for (int i = 0; i < _hits.Count; i++)
        {
            Count(_bounces.Pointer + _hits[i], 0);
        }

        for (int i = 0; i < _hits.Count; i++)
        {
            Count(_bounces.Pointer + _hits[i], 1);
        }

        int kept = 0;
        for (int i = 0; i < _hits.Count; i++)
        {
            BounceLanes* bounce = _bounces.Pointer + _hits[i];
            ContactBundle* row = bounce->Row;
            int hits = bounce->Hits;
            for (int lane = 0; hits >> lane != 0; lane++)
            {
                bool shared =
                    (YieldsA(row, lane) && _hitsAt[row->BodyA[lane]] > 1) || (YieldsB(row, lane) && _hitsAt[row->BodyB[lane]] > 1);
                bounce->Hits &= shared ? hits : ~(1 << lane);
            }

            if (bounce->Hits != 0)
            {
                _hits.Pointer[kept++] = _hits[i];
            }
        }

        _hits.SetCount(kept);
    }

    /// <summary>Counts the impacts of a bundle at their bodies; 0 in <paramref name="step"/> begins anew.</summary>
    private void Count(BounceLanes* bounce, int step)
    {
        ContactBundle* row = bounce->Row;
        for (int lane = 0; bounce->Hits >> lane != 0; lane++)
        {
            if (((bounce->Hits >> lane) & 1) != 0)
            {
                _hitsAt[row->BodyA[lane]] = step * (_hitsAt[row->BodyA[lane]] + 1);
                _hitsAt[row->BodyB[lane]] = step * (_hitsAt[row->BodyB[lane]] + 1);
            }
        }
    }
}
