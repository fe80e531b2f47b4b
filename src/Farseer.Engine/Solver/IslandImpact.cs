using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Islands;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// An impact in a small island, solved directly with all contacts that touch and do not bounce: what falls on something that stands has no
/// speed back, whatever the masses. (A sweep over contacts takes off a heavy body's speed the share of the light one's mass; what it has
/// not found by then is stored as overlap and given back as speed.) Contacts that bounce hand a blow on one after the other, as they do
/// everywhere.
/// </summary>
internal sealed unsafe partial class IslandImpact
{
    private const int MostPoints = ContactSystem.MostPoints;

    /// <summary>Share of the arms by which a gap may be wrong: some units in the last place of each.</summary>
    private const double GapRounding = 1e-6;

    private readonly ContactSystem _system = new ContactSystem();
    private readonly Column<Side> _sides = new Column<Side>();
    private readonly Column<Change> _changes = new Column<Change>();

    /// <summary>Where a body stands in the list of the island's bodies, and its change with it.</summary>
    private readonly Column<int> _places = new Column<int>();
    private readonly IndexList _bodies = new IndexList();

    /// <summary>Some point is to part by a restitution. (What is driven on within the substep parts by rounding, or little more.)</summary>
    private bool _bounces;

    private int _turns;

    /// <summary>Sums what contacts give, if somebody reads it.</summary>
    public ContactImpulses? Impulses { get; set; }

    /// <summary>The bodies of the island of the last impact, those that can move.</summary>
    public IndexList Bodies => _bodies;

    /// <summary>Makes room for the largest island, once: later steps are not to allocate.</summary>
    public void Begin(int bodyEnd)
    {
        _places.EnsureCapacity(bodyEnd);
        int points = Math.Min(MostPoints, 2 * bodyEnd);
        _changes.EnsureCapacity(points);
        _system.Reserve(points);
        _sides.EnsureCapacity(points);
        _bodies.Reserve(points);
    }

    /// <summary>Solves the impacts of an island at one moment.</summary>
    /// <param name="island">Which.</param>
    /// <param name="islands">Its rows.</param>
    /// <param name="bounces">Its impacts.</param>
    /// <param name="bodies">The store.</param>
    /// <param name="time">The moment, seconds before the end of the substep.</param>
    /// <param name="turns">What pushes and what rubs is brought into balance in so many turns at most.</param>
    /// <param name="stop">Contacts that bounce are stopped with the others, and there is no new impact.</param>
    /// <param name="c">Of the substep.</param>
    /// <returns>Turns that it took.</returns>
    public int Solve(
        int island,
        SmallIslands islands,
        BounceLanes* bounces,
        BodyStore bodies,
        float time,
        int turns,
        bool stop,
        in ContactCoefficients c)
    {
        _system.Clear();
        _bodies.Clear();
        _bounces = false;
        float same = (float)BounceKernel.SameMoment * c.Substep;
        for (int k = islands.First(island); k >= 0; k = islands[k].Next)
        {
            ref SmallIslandRow entry = ref islands[k];
            BounceLanes* bounce = entry.Bounce < 0 ? null : bounces + entry.Bounce;
            int lane = entry.Lane;
            if (!Answers(entry.Row, lane))
            {
                continue;
            }

            Enlist(entry.Row, lane);
            if (bounce != null && !stop && (((bounce->Hits | bounce->Later) >> lane) & 1) != 0)
            {
                // What meets later in the substep is another impact, and touches nothing yet.
                if (((bounce->Hits >> lane) & 1) != 0 && bounce->Time[lane] >= time - same)
                {
                    AddStruck(entry.Row, lane, bounce, bodies, bounce->Time[lane], c);
                }
            }
            else if (stop || !(entry.Row->Restitution[lane] > 0))
            {
                AddTouching(entry.Row, lane, bodies, c);
            }
        }

        _turns = 0;
        if (!Balance(Math.Min(turns, Turns)))
        {
            return _turns;
        }

        for (int i = 0; i < _system.Count; i++)
        {
            Note(_system[i], _sides[i]);
        }

        for (int i = 0; i < _bodies.Count; i++)
        {
            Give(bodies, _bodies[i], stop ? 0 : time);
        }

        return _turns;
    }

    private void Enlist(ContactBundle* row, int lane)
    {
        Enlist(row->BodyA[lane], row->MassA[lane] + row->InertiaA[lane]);
        Enlist(row->BodyB[lane], row->MassB[lane] + row->InertiaB[lane]);
    }

    private void Enlist(int body, float answer)
    {
        if (!(answer > 0) || Has(body))
        {
            return;
        }

        int place = _bodies.Count;
        _places[body] = place;
        _changes.EnsureCapacity(place + 1);
        _changes[place] = default;
        _bodies.Add(body);
    }

    /// <summary>A body is one of the island's that can move.</summary>
    private bool Has(int body)
    {
        int place = _places[body];
        return (uint)place < (uint)_bodies.Count && _bodies[place] == body;
    }

    private void AddStruck(ContactBundle* row, int lane, BounceLanes* bounce, BodyStore bodies, float time, in ContactCoefficients c)
    {
        Moment a = At(bodies, row->BodyA[lane], row->MassA[lane] + row->InertiaA[lane], time, c);
        Moment b = At(bodies, row->BodyB[lane], row->MassB[lane] + row->InertiaB[lane], time, c);
        AddStruck(row, lane, second: false, a, b, &bounce->Point0, bounce);
        AddStruck(row, lane, second: true, a, b, &bounce->Point1, bounce);
    }

    /// <summary>A point that is struck, or is pressed while the other one is: what it bears holds it down, and it may slip.</summary>
    private void AddStruck(
        ContactBundle* row, int lane, bool second, in Moment a, in Moment b, BouncePointLanes* struck, BounceLanes* bounce)
    {
        ContactPointLanes* point = second ? &row->Point1 : &row->Point0;
        if (struck->Target[lane] >= 0)
        {
            Add(row, lane, second, a, b, struck->Target[lane], bounce);
        }
        else if (point->Normal[lane] > 0 && point->Base[lane] < ContactBundle.NoPoint)
        {
            Add(row, lane, second, a, b, 0, null);
        }
    }

    private void AddTouching(ContactBundle* row, int lane, BodyStore bodies, in ContactCoefficients c)
    {
        FindGaps(row, lane, bodies, out double gap0, out double gap1);
        Moment a = At(bodies, row->BodyA[lane], row->MassA[lane] + row->InertiaA[lane], 0, c);
        Moment b = At(bodies, row->BodyB[lane], row->MassB[lane] + row->InertiaB[lane], 0, c);
        if (Touches(&row->Point0, lane, gap0, c))
        {
            Add(row, lane, second: false, a, b, 0, null);
        }

        if (Touches(&row->Point1, lane, gap1, c))
        {
            Add(row, lane, second: true, a, b, 0, null);
        }
    }

    /// <summary>
    /// It is loaded, or nearer than a substep's fall and its rounding: what rests has gaps about 0, and their rounding is to decide
    /// nothing.
    /// </summary>
    private static bool Touches(ContactPointLanes* point, int lane, double gap, in ContactCoefficients c)
    {
        double arms = Math.Abs(point->NormalArmA[lane]) + Math.Abs(point->NormalArmB[lane]);
        return point->Base[lane] < ContactBundle.NoPoint
            && (point->Normal[lane] > 0 || gap <= (c.Gravity * c.Substep * c.Substep) + (GapRounding * arms));
    }

    /// <summary>How far apart the surfaces of both points are.</summary>
    private static void FindGaps(ContactBundle* row, int lane, BodyStore bodies, out double gap0, out double gap1)
    {
        ref BodyState a = ref bodies.State[row->BodyA[lane]];
        ref BodyState b = ref bodies.State[row->BodyB[lane]];
        Vector2 moved = b.DeltaPosition - a.DeltaPosition;
        double along =
            ((double)row->NormalX[lane] * moved.X) + ((double)row->NormalY[lane] * moved.Y) - ContactBundle.RestDepthOf(row, lane);
        gap0 = along + row->Point0.Base[lane] + Along(&row->Point0, lane, b, second: true) - Along(&row->Point0, lane, a, second: false);
        gap1 = along + row->Point1.Base[lane] + Along(&row->Point1, lane, b, second: true) - Along(&row->Point1, lane, a, second: false);
    }

    private static double Along(ContactPointLanes* point, int lane, in BodyState state, bool second) => second
        ? ((double)state.DeltaCos * point->NormalArmB[lane]) + ((double)state.DeltaSin * point->TangentArmB[lane])
        : ((double)state.DeltaCos * point->NormalArmA[lane]) + ((double)state.DeltaSin * point->TangentArmA[lane]);

    /// <summary>How fast the surfaces part at a point, and its arms along the surface.</summary>
    private static double SpeedOf(
        ContactBundle* row, int lane, ContactPointLanes* point, in Moment a, in Moment b, out double armA, out double armB)
    {
        armA = (a.Cos * point->TangentArmA[lane]) - (a.Sin * point->NormalArmA[lane]);
        armB = (b.Cos * point->TangentArmB[lane]) - (b.Sin * point->NormalArmB[lane]);
        return ((double)row->NormalX[lane] * (b.X - a.X)) + ((double)row->NormalY[lane] * (b.Y - a.Y)) + (b.W * armB) - (a.W * armA);
    }

    private void Add(ContactBundle* row, int lane, bool second, in Moment a, in Moment b, double target, BounceLanes* bounce)
    {
        SystemPoint added = default;
        added.Bundle = row;
        added.Lane = lane;
        added.Second = second;
        ContactPointLanes* point = added.Lanes;
        _bounces |= target > 0 && row->Restitution[lane] > 0;
        Side side = default;
        side.Speed = SpeedOf(row, lane, point, a, b, out added.ArmA, out added.ArmB);
        side.Excess = side.Speed - target;
        side.Bounce = bounce;
        side.AlongA = (a.Cos * point->NormalArmA[lane]) + (a.Sin * point->TangentArmA[lane]) + row->RadiusA[lane];
        side.AlongB = (b.Cos * point->NormalArmB[lane]) + (b.Sin * point->TangentArmB[lane]) - row->RadiusB[lane];
        side.Slip = ((double)row->NormalY[lane] * (b.X - a.X)) - ((double)row->NormalX[lane] * (b.Y - a.Y))
            + (a.W * side.AlongA) - (b.W * side.AlongB);
        _sides.EnsureCapacity(_system.Count + 1);
        _sides[_system.Count] = side;
        _system.Add(added);
    }

    /// <summary>A body some time before the end of the substep.</summary>
    private static Moment At(BodyStore bodies, int body, float answer, double time, in ContactCoefficients c)
    {
        ref BodyState state = ref bodies.State[body];
        Moment moment;
        moment.X = state.LinearVelocity.X;
        moment.Y = state.LinearVelocity.Y;
        moment.W = state.AngularVelocity;
        moment.Sin = state.DeltaSin;
        moment.Cos = state.DeltaCos;
        if (!(time > 0))
        {
            return moment;
        }

        // What cannot move is not integrated: its start is of another time.
        ref BodyMotion motion = ref bodies.Motion[body];
        double share = answer > 0 ? time * c.InverseSubstep : 0;
        double spin = moment.W;
        moment.X -= (moment.X - motion.StartX) * share;
        moment.Y -= (moment.Y - motion.StartY) * share;
        moment.W -= (spin - motion.StartW) * share;
        double turn = time * 0.5 * (spin + moment.W);
        if (turn != 0)
        {
            double turned = Math.Max(-Integrator.LargestTurn, Math.Min(Integrator.LargestTurn, motion.Turned - turn));
            StableMath.SinCos(turned, out moment.Sin, out moment.Cos);
        }

        return moment;
    }

    private void Note(in SystemPoint point, in Side side)
    {
        float x = (float)point.Impulse;
        BounceLanes* bounce = side.Bounce;
        Impulses?.AddBeside(point.Bundle, point.Lane, point.Second, bounce == null ? point.Impulse : 0, side.Rub);
        if (bounce == null)
        {
            point.Bundle->Struck[point.Lane] += x;
            return;
        }

        point.Lanes->Normal[point.Lane] += x;
        (point.Second ? &bounce->Point1 : &bounce->Point0)->Pushed[point.Lane] += x;
    }

    /// <summary>A body gets its change of velocity, and is where that has brought it since: see <see cref="WideFlight.CatchUp"/>.</summary>
    private void Give(BodyStore bodies, int body, double time)
    {
        Change change = _changes[_places[body]];
        if (change.X == 0 && change.Y == 0 && change.W == 0)
        {
            return;
        }

        ref BodyState state = ref bodies.State[body];
        ref BodyMotion motion = ref bodies.Motion[body];
        state.LinearVelocity = new Vector2((float)(state.LinearVelocity.X + change.X), (float)(state.LinearVelocity.Y + change.Y));
        state.AngularVelocity = (float)(state.AngularVelocity + change.W);
        motion.StartX += (float)change.X;
        motion.StartY += (float)change.Y;
        motion.StartW += (float)change.W;
        state.DeltaPosition =
            new Vector2((float)(state.DeltaPosition.X + (change.X * time)), (float)(state.DeltaPosition.Y + (change.Y * time)));
        if (change.W * time != 0)
        {
            motion.Turned = (float)(motion.Turned + (change.W * time));
            double turned = Math.Max(-Integrator.LargestTurn, Math.Min(Integrator.LargestTurn, motion.Turned));
            StableMath.SinCos(turned, out double sin, out double cos);
            state.DeltaSin = (float)sin;
            state.DeltaCos = (float)cos;
        }
    }

    /// <summary>What a point has beside its part in the system.</summary>
    private struct Side
    {
        public BounceLanes* Bounce;
        public double AlongA;
        public double AlongB;

        /// <summary>How fast the surfaces part without the impact, and how much faster than they are to.</summary>
        public double Speed;
        public double Excess;

        /// <summary>How fast the surfaces slip past each other without the impact, and the friction found.</summary>
        public double Slip;
        public double Rub;
    }

    /// <summary>What the impact changes the velocities of a body by.</summary>
    private struct Change
    {
        public double X;
        public double Y;
        public double W;
    }

    private struct Moment
    {
        public double X;
        public double Y;
        public double W;
        public double Sin;
        public double Cos;
    }
}
