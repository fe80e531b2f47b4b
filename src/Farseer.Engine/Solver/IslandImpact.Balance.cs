using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Islands;

namespace Farseer.Engine.Solver;

/// <content>The impulses of an impact: what pushes and what rubs, in balance.</content>
internal sealed unsafe partial class IslandImpact
{
    /// <summary>
    /// Turns of what pushes and what rubs, and sweeps of friction in each. Each turn leaves 0.5 to 0.8 of the error of the last, at worst
    /// seen 0.97: with 32 turns one island in eleven was not done, and which one was for rounding to say.
    /// </summary>
    private const int Turns = 512;
    private const int Rubs = 8;

    /// <summary>Share of all impulses by which they may still change.</summary>
    private const double Balanced = 1e-6;

    /// <summary>
    /// Finds what pushes and what rubs. Newton's rule with friction in the balance may add energy: such an impact is pushed as if it were
    /// smooth and rubbed afterwards, which takes energy in any case. (Without a bounce impulses p leave velocities v' with p·v' ≤ 0, and
    /// take half of pᵀKp.)
    /// </summary>
    /// <returns>False if no impulses were found.</returns>
    private bool Balance(int most)
    {
        for (int i = 0; _bounces && i < _system.Count; i++)
        {
            // Beside a bounce what parts already may come to approach as fast: to stop it before adds energy (see Impact.Row.Target).
            ref Side side = ref _sides[i];
            side.Excess = side.Bounce == null && side.Excess > 0 ? 2 * side.Excess : side.Excess;
        }

        return (BalanceBy(most) && !(_bounces && AddsEnergy())) || BalanceBy(1);
    }

    /// <summary>
    /// Finds what pushes and what rubs by turns: friction changes how fast surfaces approach, and they push on it until neither changes any
    /// more. Left to the next round, what friction has undone would be an impact of its own, at a moment that rounding tells. With one turn
    /// what rubs comes after.
    /// </summary>
    /// <returns>False if no impulses were found, or they still change.</returns>
    private bool BalanceBy(int turns)
    {
        double before = 0;
        for (int i = 0; i < _system.Count; i++)
        {
            _sides[i].Rub = 0;
        }

        for (int turn = 0; turn < turns; turn++)
        {
            for (int i = 0; i < _bodies.Count; i++)
            {
                _changes[i] = default;
            }

            for (int i = 0; i < _system.Count; i++)
            {
                Rub(_system[i], _sides[i], _sides[i].Rub);
            }

            for (int i = 0; i < _system.Count; i++)
            {
                ref SystemPoint point = ref _system[i];
                point.Excess = _sides[i].Excess + Parting(point);
            }

            _turns++;
            if (!_system.Solve())
            {
                return false;
            }

            double sum = 0;
            for (int i = 0; i < _system.Count; i++)
            {
                Push(_system[i]);
                sum += _system[i].Impulse;
            }

            if (turn > 0 && Math.Abs(sum - before) <= Balanced * sum)
            {
                return true;
            }

            before = sum;
            for (int rub = 0; rub < Rubs; rub++)
            {
                for (int i = 0; i < _system.Count; i++)
                {
                    FindRub(_system[i], ref _sides[i]);
                }
            }
        }

        return turns == 1;
    }

    /// <summary>The work of all impulses: each times the mean of the speeds at its point before and after.</summary>
    private bool AddsEnergy()
    {
        double work = 0;
        double taken = 0;
        for (int i = 0; i < _system.Count; i++)
        {
            ref SystemPoint point = ref _system[i];
            ref Side side = ref _sides[i];
            double push = point.Impulse * (side.Speed + (0.5 * Parting(point)));
            double rub = side.Rub * (side.Slip + (0.5 * Slipping(point, side)));
            work += push + rub;
            taken += Math.Abs(push) + Math.Abs(rub);
        }

        return work > Balanced * taken;
    }

    /// <summary>How much faster the surfaces of a point part by what was found so far.</summary>
    private double Parting(in SystemPoint point)
    {
        ContactBundle* row = point.Bundle;
        int lane = point.Lane;
        Change a = ChangeOf(row->BodyA[lane], row->MassA[lane] + row->InertiaA[lane]);
        Change b = ChangeOf(row->BodyB[lane], row->MassB[lane] + row->InertiaB[lane]);
        return (row->NormalX[lane] * (b.X - a.X)) + (row->NormalY[lane] * (b.Y - a.Y)) + (b.W * point.ArmB) - (a.W * point.ArmA);
    }

    /// <summary>How much faster they slip.</summary>
    private double Slipping(in SystemPoint point, in Side side)
    {
        ContactBundle* row = point.Bundle;
        int lane = point.Lane;
        Change a = ChangeOf(row->BodyA[lane], row->MassA[lane] + row->InertiaA[lane]);
        Change b = ChangeOf(row->BodyB[lane], row->MassB[lane] + row->InertiaB[lane]);
        return (row->NormalY[lane] * (b.X - a.X)) - (row->NormalX[lane] * (b.Y - a.Y)) + (a.W * side.AlongA) - (b.W * side.AlongB);
    }

    private Change ChangeOf(int body, float answer) => answer > 0 ? _changes[_places[body]] : default;

    private void Push(in SystemPoint point)
    {
        ContactBundle* row = point.Bundle;
        int lane = point.Lane;
        double x = point.Impulse;
        double px = row->NormalX[lane] * x;
        double py = row->NormalY[lane] * x;
        Apply(row->BodyA[lane], -row->MassA[lane] * px, -row->MassA[lane] * py, -row->InertiaA[lane] * point.ArmA * x);
        Apply(row->BodyB[lane], row->MassB[lane] * px, row->MassB[lane] * py, row->InertiaB[lane] * point.ArmB * x);
    }

    /// <summary>Ends the slip of a point as far as its cone allows.</summary>
    private void FindRub(in SystemPoint point, ref Side side)
    {
        ContactBundle* row = point.Bundle;
        int lane = point.Lane;
        double bound = row->Friction[lane] * Math.Max(point.Impulse, 0);
        double slip = side.Slip + Slipping(point, side);
        double response = row->MassA[lane] + row->MassB[lane]
            + (row->InertiaA[lane] * side.AlongA * side.AlongA) + (row->InertiaB[lane] * side.AlongB * side.AlongB);
        double found = Math.Max(-bound, Math.Min(bound, side.Rub - (slip / response)));
        Rub(point, side, found - side.Rub);
        side.Rub = found;
    }

    private void Rub(in SystemPoint point, in Side side, double p)
    {
        ContactBundle* row = point.Bundle;
        int lane = point.Lane;
        double px = row->NormalY[lane] * p;
        double py = -row->NormalX[lane] * p;
        Apply(row->BodyA[lane], -row->MassA[lane] * px, -row->MassA[lane] * py, row->InertiaA[lane] * side.AlongA * p);
        Apply(row->BodyB[lane], row->MassB[lane] * px, row->MassB[lane] * py, -row->InertiaB[lane] * side.AlongB * p);
    }

    private void Apply(int body, double x, double y, double w)
    {
        if ((x != 0 || y != 0 || w != 0) && Has(body))
        {
            ref Change change = ref _changes[_places[body]];
            change.X += x;
            change.Y += y;
            change.W += w;
        }
    }
}
