using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <content>Impacts in small islands, each island by itself: see <see cref="IslandImpact"/>.</content>
internal sealed unsafe partial class ImpactPass
{
    /// <summary>
    /// Turns of all impacts of an island in a substep. One impact takes some 30; without a bound 1,024 of them, none of which came to a
    /// balance, took half a minute.
    /// </summary>
    private const int MostTurns = 4096;

    private readonly Column<int> _turnsOf = new Column<int>();

    /// <summary>Lets go of the world.</summary>
    public void Forget()
    {
        _small = null;
        _island.Impulses = null;
    }

    private void ReserveSmall(int bodies)
    {
        _island.Begin(bodies);
        _islandsHit.Reserve(bodies);
        _struckSmall.Reserve(bodies);
        _timeOf.EnsureCapacity(bodies + 1);
        _hitIn.EnsureCapacity(bodies + 1);
        _struckIn.EnsureCapacity(bodies + 1);
        _turnsOf.EnsureCapacity(bodies + 1);
    }

    private int DirectLanes(ContactBundle* row, int can)
    {
        int direct = 0;
        for (int lane = 0; can >> lane != 0; lane++)
        {
            direct |= ((can >> lane) & 1) != 0 && _small!.Has(row, lane) ? 1 << lane : 0;
        }

        return direct;
    }

    /// <summary>Solves the impacts in small islands, each island by itself, and takes them out of the round.</summary>
    private void SolveSmall(BodyStore bodies, in ContactCoefficients c)
    {
        _islandsHit.Clear();
        _smallRound++;
        for (int i = 0; i < _hits.Count; i++)
        {
            BounceLanes* bounce = _bounces.Pointer + _hits[i];
            int direct = bounce->Hits & bounce->Direct;
            for (int lane = 0; direct >> lane != 0; lane++)
            {
                if (((direct >> lane) & 1) != 0)
                {
                    NoteIsland(_small!.IslandOf(bounce->Row, lane), bounce->Time[lane]);
                }
            }
        }

        for (int i = 0; i < _islandsHit.Count; i++)
        {
            int island = _islandsHit[i];
            if (NoteOnce(_struckSmall, _struckIn, _smallRun, island))
            {
                _turnsOf[island] = 0;
            }

            _turnsOf[island] += _island.Solve(island, _small!, _bounces.Pointer, bodies, _timeOf[island], TurnsFor(island), stop: false, c);
            for (int k = 0; k < _island.Bodies.Count; k++)
            {
                NoteChange(_island.Bodies[k]);
            }
        }

        for (int i = 0; i < _hits.Count; i++)
        {
            BounceLanes* bounce = _bounces.Pointer + _hits[i];
            bounce->Hits &= ~bounce->Direct;
        }
    }

    /// <summary>What is left of an island's turns: beyond, its impacts are pushed as if they were smooth, and rubbed afterwards.</summary>
    private int TurnsFor(int island) => Math.Max(1, MostTurns - _turnsOf[island]);

    private void NoteIsland(int island, float time)
    {
        _timeOf[island] = NoteOnce(_islandsHit, _hitIn, _smallRound, island) ? time : Math.Max(_timeOf[island], time);
    }

    /// <summary>
    /// Lists an island that was not listed since a count began; as many may be struck at once as there are, so the list is not searched.
    /// </summary>
    /// <returns>True if it was not listed yet.</returns>
    private static bool NoteOnce(IndexList list, Column<int> listedIn, int now, int island)
    {
        if (listedIn[island] == now)
        {
            return false;
        }

        listedIn[island] = now;
        list.Add(island);
        return true;
    }

    /// <summary>
    /// Small islands that were struck bear what has come to lie on them; where impacts are left, what approaches is stopped.
    /// </summary>
    private void FinishSmall(in SolverInput input)
    {
        for (int i = 0; i < _islandsHit.Count; i++)
        {
            int island = _islandsHit[i];
            _island.Solve(island, _small!, _bounces.Pointer, input.Bodies, 0, TurnsFor(island), stop: true, input.Coefficients);
        }

        for (int i = 0; i < _struckSmall.Count; i++)
        {
            _island.GiveLoads(_struckSmall[i], _small!, _bounces.Pointer, input.Bodies, input.GravityVector, input.Coefficients);
        }
    }
}
