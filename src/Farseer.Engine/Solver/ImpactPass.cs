using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// The impacts of a substep, in the order in which they happen: what has struck is given its speed, which may make it strike the next,
/// until nothing approaches any more. So the first ball of a row stops and the last one leaves. Where contacts that do not bounce hold
/// a body that was struck, they and the impact are solved in turns, and the speed of parting stays that of the impact: a ball comes
/// back from a box on the ground as from the ground.
/// </summary>
internal sealed unsafe partial class ImpactPass
{
    /// <summary>Impacts one after the other in a substep; a blow that runs on beyond goes on in the next.</summary>
    private const int MostRounds = 1024;

    /// <summary>
    /// Visits of bundles in a substep, those of its passes with them, after which there are no rounds but the first few, and one turn of
    /// what does not bounce: without that one a rotor in a dense heap throws it about with ten times its energy. A blow that runs through
    /// a thousand balls visits few in a round, while in a large pile in which everything strikes each round visits nearly all.
    /// </summary>
    private const int MostVisits = 1 << 13;
    private const int PassVisits = 4;
    private const int LeastRounds = 2;
    private const int LeastTurns = 1;

    /// <summary>
    /// Rounds in which nothing but weak bounces happens: a body that is pressed between a rotor and a heap goes to and fro between them for
    /// as long as it is let. Of a speed at which balls meet less than 3/4 is handed on, so after 64 rounds 10⁻⁸ of it is left.
    /// </summary>
    private const int MostWeakRounds = 64;

    /// <summary>
    /// Room from the first step on, and bundles for each body where something bounces, and where bodies only fall: later steps are not to
    /// allocate.
    /// </summary>
    private const int LeastBundles = 64;
    private const float BouncingShare = 0.5f;
    private const float FallingShare = 1f / 32;

    /// <summary>
    /// Visits of bundles in the sweeps of a round, but for the first few: what still approaches is found by the next one.
    /// </summary>
    private const int SweepVisits = 512;
    private const int LeastSweeps = 2;

    /// <summary>Turns of what does not bounce and what does.</summary>
    private const int Turns = 6;

    /// <summary>
    /// A body whose part in the response of an impact is smaller goes on almost as if nothing had been: its impacts do not wait for each
    /// other. A rotor that strikes a hundred balls in a substep struck one a round. Each looks anew how fast it is when its turn comes:
    /// with the speed before all of them thirty elastic balls took 0.3 % too much.
    /// </summary>
    private const float Heavy = 1f / 64;

    private readonly Column<BounceLanes> _bounces = new Column<BounceLanes>();

    /// <summary>
    /// Bundles with an impact in this round, in order: a round has few, and walking all of them a dozen times for these was half of the
    /// solver's time where much bounces.
    /// </summary>
    private readonly IndexList _hits = new IndexList();

    /// <summary>See <see cref="ListMet"/>.</summary>
    private readonly IndexList _met = new IndexList();
    private readonly Column<float> _latest = new Column<float>();

    /// <summary>Impacts of the round at a body.</summary>
    private readonly Column<int> _hitsAt = new Column<int>();

    /// <summary>1 for an island that was struck.</summary>
    private readonly Column<byte> _islandStruck = new Column<byte>();
    private readonly ImpactNeighbors _neighbors = new ImpactNeighbors();
    private readonly IslandImpact _island = new IslandImpact();

    /// <summary>Small islands with an impact in this round, and in this substep.</summary>
    private readonly IndexList _islandsHit = new IndexList();
    private readonly IndexList _struckSmall = new IndexList();

    /// <summary>The moment of the first impact of the round in a small island.</summary>
    private readonly Column<float> _timeOf = new Column<float>();
    private SmallIslands? _small;

    /// <summary>The round and the substep, counted without end, in which a small island was listed last.</summary>
    private readonly Column<int> _hitIn = new Column<int>();
    private readonly Column<int> _struckIn = new Column<int>();
    private int _smallRound;
    private int _smallRun;

    /// <summary>The last round, counted in the step, that changed a body.</summary>
    private readonly Column<int> _changed = new Column<int>();
    private int _round;
    private int _visits;
    private int _count;
    private int _rows;
    private bool _any;

    /// <summary>An impact of the last round concerns others than its two bodies.</summary>
    private bool _concerned;

    /// <summary>The rounds have ended before such impacts did.</summary>
    private bool _goesOn;

    /// <summary>Makes room: later steps are not to allocate.</summary>
    /// <param name="bodies">For as many bodies.</param>
    /// <param name="bundles">There is room for so many bundles of rows.</param>
    /// <param name="bounce">Some of which bounce.</param>
    public void Reserve(int bodies, int bundles, bool bounce)
    {
        ReserveSmall(bodies);
        _bounces.EnsureCapacity(Math.Min(LeastBundles, (bundles + 1) / 2) + (int)(bodies * (bounce ? BouncingShare : FallingShare)));
        _hits.Reserve(_bounces.Capacity);
        _met.Reserve(_bounces.Capacity);
        _latest.EnsureCapacity(bodies);
        _hitsAt.EnsureCapacity(bodies);
        _islandStruck.EnsureCapacity(bodies + 1);
        _changed.EnsureCapacity(bodies);
        _neighbors.Reserve(_bounces.Capacity, bodies);
    }

    /// <summary>Lists the bundles that can have impacts.</summary>
    /// <param name="colors">The rows.</param>
    /// <param name="bodies">The store.</param>
    /// <param name="bounce">Some of them bounce.</param>
    /// <param name="free">Contacts that nothing presses yet; null: there are none.</param>
    /// <param name="driven">How far restitutions above 1 drive.</param>
    /// <returns>True if there are some.</returns>
    public bool Begin(ReadOnlySpan<GraphColor> colors, BodyStore bodies, bool bounce, FreeImpacts? free, in DrivenBound driven)
    {
        _count = 0;
        _rows = 0;
        _small = free is { Small.Any: true } ? free.Small : null;
        if (bounce || _small != null)
        {
            int place = 0;
            for (int k = 0; k < colors.Length; k++)
            {
                foreach (ContactBundle* row in colors[k].Bundles)
                {
                    ContactBundle.AskAhead(row->Restitution);
                    List(row, place++, bounce ? BounceKernel.BouncingLanes(row) : 0, free);
                }
            }
        }
        else if (free != null)
        {
            for (int i = 0; i < free.Count; i++)
            {
                ContactBundle* row = free.BundleAt(i, out int place);
                List(row, place, 0, free);
            }
        }

        for (int i = 0; i < _count; i++)
        {
            driven.Note(_bounces.Pointer + i, bodies);
        }

        if (_count > 0)
        {
            _round = 0;
            new Span<int>(_changed.Pointer, bodies.Ids.End).Clear();
            _neighbors.Begin(_bounces.Capacity, bodies.Ids.End);
        }

        return _count > 0;
    }

    private void List(ContactBundle* row, int place, int can, FreeImpacts? free)
    {
        int alone = 0;
        int pointByPoint = 0;
        can |= free != null ? free.LanesOf(row, out alone, out pointByPoint) : 0;
        if (can == 0)
        {
            return;
        }

        _small?.Bind(place, _count);
        _rows += BitSet.CountBits((uint)can);
        _bounces.EnsureCapacity(_count + 1);
        BounceLanes* bounce = _bounces.Pointer + _count++;
        bounce->Row = row;
        bounce->Can = can;
        bounce->Free = alone;
        bounce->Direct = _small != null ? DirectLanes(row, can) : 0;
        bounce->PointByPoint = pointByPoint;
    }

    /// <summary>Before the velocities of a substep are integrated.</summary>
    public void Prepare(BodyStore bodies, in ContactCoefficients c)
    {
        _any = false;
        for (int i = 0; i < _count; i++)
        {
            _any |= BounceKernel.Prepare(_bounces.Pointer + i, bodies.State.Pointer, bodies.Motion.Pointer, bodies.Drive.Pointer, c);
        }
    }

    /// <summary>After the relax pass.</summary>
    public void Run(in SolverInput input, ContactPasses passes)
    {
        if (!_any)
        {
            return;
        }

        _island.Impulses = input.Impulses;
        BodyStore bodies = input.Bodies;
        ListMet();
        HoldAll(false);
        _islandsHit.Clear();
        _struckSmall.Clear();
        _smallRun++;
        bool struck = false;
        int weakRounds = 0;
        _visits = PassVisits * _count;
        _goesOn = false;
        for (int round =
            0; round < MostRounds && weakRounds < MostWeakRounds && (round < LeastRounds || _visits < MostVisits || !_concerned); round++)
        {
            bool any = FindFirst(bodies, input.Coefficients, round > 0);
            _goesOn = any && _concerned;
            if (!any)
            {
                _islandsHit.Clear();
                break;
            }

            weakRounds += AreAllWeak() ? 1 : 0;
            if (_small != null)
            {
                SolveSmall(bodies, input.Coefficients);
            }

            struck |= _concerned;
            Sweep(bodies, input.Coefficients);
        }

        if (struck && _rows < input.RowCount)
        {
            Settle(input, passes);
        }
    }

    /// <summary>
    /// Lets the impulses of the substep's impacts go. If impacts are left, what approaches still is stopped without a bounce, all of it
    /// together: the series of impacts in a pile has no end, and what it tends to is that nothing approaches. Left as it is, it would fly
    /// on, and the pile sink into itself.
    /// </summary>
    public void Finish(in SolverInput input, ContactPasses passes)
    {
        if (_any && input.Impulses != null)
        {
            SubstepSolver.AddImpulses(input.Colors, input.Impulses, 1);
        }

        for (int i = 0; _any && i < _count; i++)
        {
            BounceKernel.Finish(_bounces.Pointer + i);
        }

        if (_any && _small != null)
        {
            FinishSmall(input);
        }

        if (_any && input.Impulses != null)
        {
            SubstepSolver.AddImpulses(input.Colors, input.Impulses, -1);
        }

        for (int turn = 0; _any && _goesOn && turn < (_visits < MostVisits ? Turns : LeastTurns); turn++)
        {
            passes.Relax(input.Colors, true, false);
        }
    }

    /// <summary>Finds the impacts that no other of their bodies precedes.</summary>
    /// <param name="bodies">The store.</param>
    /// <param name="c">Of the substep.</param>
    /// <param name="again">Only bodies that the last impacts changed can have new ones.</param>
    private bool FindFirst(BodyStore bodies, in ContactCoefficients c, bool again)
    {
        _hits.Clear();
        _concerned = false;
        _neighbors.Take();
        int count = again ? _neighbors.Taken.Count : _count;
        for (int i = 0; i < count; i++)
        {
            Look(again ? _neighbors.Taken[i] : i, bodies, c, again);
        }

        _round++;
        if (_hits.Count == 0)
        {
            return false;
        }

        _neighbors.Link(_bounces.Pointer, _count);
        for (int i = 0; i < _hits.Count; i++)
        {
            BounceLanes* bounce = _bounces.Pointer + _hits[i];
            for (int lane = 0; bounce->Hits >> lane != 0; lane++)
            {
                if (((bounce->Hits >> lane) & 1) != 0)
                {
                    NoteTime(bounce->Row->BodyA[lane], YieldsA(bounce->Row, lane), bounce->Time[lane]);
                    NoteTime(bounce->Row->BodyB[lane], YieldsB(bounce->Row, lane), bounce->Time[lane]);
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
                    bounce->Later |= 1 << lane;
                }
            }

            bounce->Struck |= bounce->Hits;
            _concerned |= (bounce->Hits & ~(bounce->Free | bounce->Direct)) != 0;
            bounce->Heavy = HeavyLanes(bounce->Row, bounce->Hits);
        }

        return true;
    }

    /// <summary>No impact of the round gives back more than a quarter of its energy.</summary>
    private bool AreAllWeak()
    {
        int strong = 0;
        for (int i = 0; i < _hits.Count; i++)
        {
            BounceLanes* bounce = _bounces.Pointer + _hits[i];
            strong |= bounce->Hits & BounceKernel.StrongLanes(bounce->Row);
        }

        return strong == 0;
    }

    /// <summary>
    /// The lanes with a body that the last round changed: which contacts lie beside them in a bundle is to change nothing.
    /// </summary>
    private int ChangedLanes(ContactBundle* row, int can)
    {
        int changed = 0;
        for (int lane = 0; can >> lane != 0; lane++)
        {
            changed |= _changed[row->BodyA[lane]] == _round || _changed[row->BodyB[lane]] == _round ? 1 << lane : 0;
        }

        return changed & can;
    }

    private void Look(int index, BodyStore bodies, in ContactCoefficients c, bool again)
    {
        // At first nothing but what was held back can have met.
        BounceLanes* bounce = _bounces.Pointer + index;
        bounce->Later = 0;
        int lanes = again ? ChangedLanes(bounce->Row, bounce->Can) : bounce->Held;
        if (lanes == 0)
        {
            bounce->Hits = 0;
            return;
        }

        _visits++;
        bounce->Hits = BounceKernel.Find(bounce, bodies.State.Pointer, bodies.Motion.Pointer, c, lanes, onlyHeld: !again);
        if (bounce->Hits == 0)
        {
            return;
        }

        _hits.Add(index);
        bounce->Met |= bounce->Hits;
        for (int lane = 0; bounce->Hits >> lane != 0; lane++)
        {
            if (((bounce->Hits >> lane) & 1) != 0)
            {
                _latest[bounce->Row->BodyA[lane]] = 0;
                _latest[bounce->Row->BodyB[lane]] = 0;
            }
        }
    }

    private void NoteChange(int body)
    {
        if (_changed[body] != _round)
        {
            _neighbors.Mark(body);
            _changed[body] = _round;
        }
    }

    private void NoteTime(int body, bool yields, float time)
    {
        if (yields)
        {
            NoteChange(body);
            _latest[body] = Math.Max(_latest[body], time);
        }
    }

    private void Settle(in SolverInput input, ContactPasses passes)
    {
        BodyStore bodies = input.Bodies;
        ListMet();
        bool some =
            input.Joints is not { Impacts.TiesBodies: true } && passes.Choose(FindStruckIslands(input.Islands), input.Islands.OfSlot);
        for (int turn = 0; turn < Turns && (turn < LeastTurns || _visits < MostVisits); turn++)
        {
            _visits += _count;
            HoldAll(true);
            if (some)
            {
                passes.RelaxChosen();
            }
            else
            {
                passes.Relax(input.Colors, true, false);
            }

            input.Joints?.Relax(true, true, 1);
            HoldAll(false);
            _hits.Clear();
            for (int i = 0; i < _met.Count; i++)
            {
                BounceLanes* bounce = _bounces.Pointer + _met[i];
                bounce->Hits = BounceKernel.FindAgain(bounce, bodies.State.Pointer);
                if (bounce->Hits != 0)
                {
                    _hits.Add(_met[i]);
                }
            }

            if (_hits.Count == 0)
            {
                return;
            }

            Sweep(bodies, input.Coefficients);
        }
    }

    /// <summary>Marks the islands with an impact in this substep: what does not bounce need not be settled anew in the others.</summary>
    private byte* FindStruckIslands(IslandStore islands)
    {
        new Span<byte>(_islandStruck.Pointer, islands.Count + 1).Clear();
        for (int i = 0; i < _met.Count; i++)
        {
            BounceLanes* bounce = _bounces.Pointer + _met[i];
            for (int lane = 0; bounce->Struck >> lane != 0; lane++)
            {
                _islandStruck[islands.OfSlot[bounce->Row->Slot[lane]]] |= (byte)((bounce->Struck >> lane) & 1);
            }
        }

        return _islandStruck.Pointer;
    }

    /// <summary>Lists the bundles of which something is held back, or has been struck.</summary>
    private void ListMet()
    {
        _met.Clear();
        for (int i = 0; i < _count; i++)
        {
            if ((_bounces[i].Held | _bounces[i].Met) != 0)
            {
                _met.Add(i);
            }
        }
    }

    private void HoldAll(bool hold)
    {
        for (int i = 0; i < _met.Count; i++)
        {
            BounceKernel.Hold(_bounces.Pointer + _met[i], hold);
        }
    }
}
