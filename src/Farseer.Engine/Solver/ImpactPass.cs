using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// The impacts of a substep, in the order in which they happen: what has struck is given its speed, which may make it strike the next,
/// until nothing approaches any more. So the first ball of a row stops and the last one leaves. Where contacts that do not bounce hold
/// a body that was struck, they and the impact are solved in turns, and the speed of parting stays that of the impact: a ball comes
/// back from a box on the ground as from the ground.
/// </summary>
internal sealed unsafe class ImpactPass
{
    /// <summary>Impacts one after the other in a substep; a blow that runs on beyond goes on in the next.</summary>
    private const int MostRounds = 1024;

    /// <summary>
    /// Looks at bundles in all rounds of a substep but for the first few: a blow that runs through a thousand balls looks at few in a round, while
    /// in a large pile in which everything strikes each round looks at nearly all.
    /// </summary>
    private const int MostLooks = 1 << 15;
    private const int LeastRounds = 16;

    /// <summary>Asking whether a bundle was struck takes this part of a look.</summary>
    private const int AskingShare = 16;

    /// <summary>Room from the first step on, and half a bundle for each body: later steps are not to allocate.</summary>
    private const int LeastBundles = 64;

    /// <summary>Turns of what does not bounce and what does.</summary>
    private const int Turns = 6;

    private readonly Column<BounceLanes> _bounces = new Column<BounceLanes>();

    /// <summary>
    /// Bundles with an impact in this round, in order: a round has few, and walking all of them a dozen times for these was half of the
    /// solver's time where much bounces.
    /// </summary>
    private readonly IndexList _hits = new IndexList();
    private readonly Column<float> _latest = new Column<float>();

    /// <summary>The last look before which an impact changed a body: the next need not ask the others again.</summary>
    private readonly Column<int> _struckBefore = new Column<int>();
    private int _look;
    private int _looks;
    private int _count;
    private int _rows;
    private bool _any;

    /// <summary>Lists the bundles that can bounce.</summary>
    public void Begin(ReadOnlySpan<GraphColor> colors, BodyStore bodies)
    {
        _count = 0;
        _rows = 0;
        _bounces.EnsureCapacity(LeastBundles + (bodies.Ids.End / 2));
        _hits.Reserve(_bounces.Capacity);
        _latest.EnsureCapacity(bodies.Ids.End);
        _struckBefore.EnsureCapacity(bodies.Ids.End);
        for (int k = 0; k < colors.Length; k++)
        {
            GraphColor color = colors[k];
            for (int i = 0; i < color.BundleCount; i++)
            {
                ContactBundle* row = color.Bundles + i;
                int can = BounceKernel.Bounces(row) ? CanBounce(row) : 0;
                if (can > 0)
                {
                    _rows += can;
                    _bounces.EnsureCapacity(_count + 1);
                    _bounces[_count++].Row = row;
                }
            }
        }
    }

    /// <summary>Before the velocities of a substep are integrated.</summary>
    public void Prepare(BodyStore bodies, in ContactCoefficients c)
    {
        _any = false;
        for (int i = 0; i < _count; i++)
        {
            _any |= BounceKernel.Prepare(_bounces.Pointer + i, bodies.State.Pointer, bodies.Drive.Pointer, c);
        }
    }

    /// <summary>After the relax pass.</summary>
    public void Run(in SolverInput input, ContactPasses passes)
    {
        if (!_any)
        {
            return;
        }

        BodyStore bodies = input.Bodies;
        HoldAll(false);
        bool struck = false;
        _looks = 0;
        for (int round = 0; round < MostRounds && (round < LeastRounds || _looks < MostLooks); round++)
        {
            if (!FindFirst(bodies, input.Coefficients, round > 0))
            {
                break;
            }

            struck = true;
            Sweep(bodies, input.Coefficients);
        }

        if (struck && _rows < input.RowCount)
        {
            Settle(input, passes);
        }

        for (int i = 0; i < _count; i++)
        {
            BounceKernel.Finish(_bounces.Pointer + i);
        }
    }

    /// <summary>Finds the impacts that no other of their bodies precedes.</summary>
    /// <param name="bodies">The store.</param>
    /// <param name="c">Of the substep.</param>
    /// <param name="again">Only bodies that the last impacts changed can have new ones.</param>
    private bool FindFirst(BodyStore bodies, in ContactCoefficients c, bool again)
    {
        int before = _look++;
        _looks += _count / AskingShare;
        _hits.Clear();
        for (int i = 0; i < _count; i++)
        {
            BounceLanes* bounce = _bounces.Pointer + i;
            if (again && !IsStruck(bounce->Row, before))
            {
                continue;
            }

            _looks++;
            bounce->Hits = BounceKernel.Find(bounce, bodies.State.Pointer, bodies.Motion.Pointer, c);
            if (bounce->Hits != 0)
            {
                _hits.Add(i);
            }

            for (int lane = 0; bounce->Hits >> lane != 0; lane++)
            {
                if (((bounce->Hits >> lane) & 1) != 0)
                {
                    _latest[bounce->Row->BodyA[lane]] = 0;
                    _latest[bounce->Row->BodyB[lane]] = 0;
                }
            }
        }

        if (_hits.Count == 0)
        {
            return false;
        }

        for (int i = 0; i < _hits.Count; i++)
        {
            BounceLanes* bounce = _bounces.Pointer + _hits[i];
            for (int lane = 0; bounce->Hits >> lane != 0; lane++)
            {
                if (((bounce->Hits >> lane) & 1) != 0)
                {
                    NoteTime(bounce->Row->BodyA[lane], bounce->Row->MassA[lane], bounce->Time[lane]);
                    NoteTime(bounce->Row->BodyB[lane], bounce->Row->MassB[lane], bounce->Time[lane]);
                }
            }
        }

        float same = (float)BounceKernel.SameMoment * c.Substep;
        for (int i = 0; i < _hits.Count; i++)
        {
            BounceLanes* bounce = _bounces.Pointer + _hits[i];
            int hits = bounce->Hits;
            for (int lane = 0; hits >> lane != 0; lane++)
            {
                float first = Math.Max(_latest[bounce->Row->BodyA[lane]], _latest[bounce->Row->BodyB[lane]]);
                if (((hits >> lane) & 1) != 0 && bounce->Time[lane] < first - same)
                {
                    bounce->Hits &= ~(1 << lane);
                }
            }

            bounce->Struck |= bounce->Hits;
        }

        return true;
    }

    private bool IsStruck(ContactBundle* row, int look)
    {
        int* before = _struckBefore.Pointer;
        bool struck = false;
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            struck |= before[row->BodyA[lane]] == look | before[row->BodyB[lane]] == look;
        }

        return struck;
    }

    private void NoteTime(int body, float inverseMass, float time)
    {
        if (inverseMass > 0)
        {
            _latest[body] = Math.Max(_latest[body], time);
            _struckBefore[body] = _look;
        }
    }

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
            for (int i = 0; i < _hits.Count; i++)
            {
                BounceLanes* bounce = _bounces.Pointer + _hits[i];
                if (bounce->Hits != 0)
                {
                    BounceKernel.Apply(bounce, bodies.State.Pointer, bodies.Motion.Pointer, c);
                }
            }
        }
    }

    private void Settle(in SolverInput input, ContactPasses passes)
    {
        BodyStore bodies = input.Bodies;
        for (int turn = 0; turn < Turns; turn++)
        {
            HoldAll(true);
            passes.Relax(input.Colors, true, false);
            input.Joints?.Relax(true, true);
            HoldAll(false);
            _hits.Clear();
            for (int i = 0; i < _count; i++)
            {
                BounceLanes* bounce = _bounces.Pointer + i;
                bounce->Hits = BounceKernel.FindAgain(bounce, bodies.State.Pointer);
                if (bounce->Hits != 0)
                {
                    _hits.Add(i);
                }
            }

            if (_hits.Count == 0)
            {
                return;
            }

            Sweep(bodies, input.Coefficients);
        }
    }

    private void HoldAll(bool hold)
    {
        for (int i = 0; i < _count; i++)
        {
            BounceKernel.Hold(_bounces.Pointer + i, hold);
        }
    }

    private static int CanBounce(ContactBundle* row)
    {
        int count = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            count += row->Contact[lane] >= 0 && row->Restitution[lane] > 0 ? 1 : 0;
        }

        return count;
    }
}
