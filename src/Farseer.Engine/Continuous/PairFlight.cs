using System;
using System.Numerics;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Continuous;

/// <summary>Two bodies that meet fast and that nothing else holds, as they were when the step began.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal struct LonePair
{
    public FastMotion A;
    public FastMotion B;
    public int Contact;

    /// <summary>What they gave each other along the tangent.</summary>
    public float Tangent;

    /// <summary>Their separation then, 0 if they did not touch: so deep they may lie in each other.</summary>
    public double Base;

    /// <summary>They touched then.</summary>
    public bool Touches;
}

/// <summary>What a pair gave each other in the step.</summary>
internal struct PairImpulse
{
    public double Normal;
    public double Tangent;
}

/// <summary>
/// Follows two free bodies through a step in which they meet: both fly exactly, to the moment of impact, which is resolved with the arms
/// and the masses of that moment; then they fly on. Bodies that press on each other are bodies that meet again and
/// again: each such impact ends a flight in which they sank into each other by a tolerance, so the step is cut the finer the more their
/// ways bend. Momentum is kept, and energy is lost only by restitution and friction.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed class PairFlight
{
    /// <summary>Impacts of a pair in a step; after them both wait for the next.</summary>
    private const int MostImpacts = 96;

    /// <summary>Searches that end in something to look at.</summary>
    private const int MostSearches = 2 * MostImpacts;

    /// <summary>Impacts that bounce; a ball that comes to rest on the other body has countless ones.</summary>
    private const int MostBounces = 16;

    /// <summary>
    /// Impacts in which the step is to be over. The tolerance is doubled where those left are too few for the time left at the present
    /// pace, so often at most; what turns on quickly in contact ends its step all the same, less exactly.
    /// </summary>
    private const int WantedImpacts = 64;
    private const int MostDoublings = 6;

    /// <summary>
    /// Times that one impact is resolved: friction has a share in the normal velocity of an eccentric impact, which then asks for
    /// more normal impulse, and that for more friction.
    /// </summary>
    private const int MostTurns = 32;

    /// <summary>
    /// Bodies that press on each other sink in by twice the tolerance and come back: the speed times the time between is then 8
    /// tolerances, and 4 from rest. What comes from farther off is an impact of its own.
    /// </summary>
    private const double PressShare = 10;

    /// <summary>What a pair meets besides each other, for both.</summary>
    private readonly FastBodySweep _sweepA;
    private readonly FastBodySweep _sweepB;

    public PairFlight(FastBodySweep a, FastBodySweep b)
    {
        _sweepA = a;
        _sweepB = b;
    }

    /// <summary>Follows a pair. Both bodies are where free flight alone would have brought them.</summary>
    public PairImpulse Run(in SweepInput input, in LonePair pair)
    {
        ContactRecord record = input.Contacts.Records[pair.Contact];
        FreeLeg a = FreeLeg.Of(input.Bodies, pair.A, input.Dt);
        FreeLeg b = FreeLeg.Of(input.Bodies, pair.B, input.Dt);
        var meetings = new Meetings(input, pair, record);
        PairImpulse given = default;
        double left = input.Dt;
        bool waits = false;
        while (meetings.FindNext(input, a, b, out double time))
        {
            if (_sweepA.MeetsBefore(input, a, left, time) || _sweepB.MeetsBefore(input, b, left, time))
            {
                break;
            }

            if (meetings.IsOver)
            {
                a.Place(input, time, left);
                b.Place(input, time, left);
                waits = true;
                break;
            }

            if (meetings.Strike(input, ref a, ref b, time, ref left, ref given))
            {
                if (!(left > 0))
                {
                    break;
                }

                input.Listener.OnWay(_sweepA, a.Body, a.Path);
                input.Listener.OnWay(_sweepB, b.Body, b.Path);
            }
        }

        if (!waits)
        {
            Part(input, a, b, left, meetings.Any);
        }

        return given;
    }

    /// <summary>The rest of the step, in which the two do not meet, or one of them meets something else first.</summary>
    private void Part(in SweepInput input, in FreeLeg a, in FreeLeg b, double left, bool moved)
    {
        if (moved)
        {
            a.Place(input, 0, left);
            b.Place(input, 0, left);
        }

        var seen = new BodySeen(input.Bodies, b.Body);
        _sweepA.FlyOn(input, a, left, moved);
        if (!seen.HasChanged(input.Bodies, b.Body))
        {
            _sweepB.FlyOn(input, b, left, moved);
        }
    }

    /// <summary>The impacts of the pair, one after the other.</summary>
    private struct Meetings
    {
        private readonly ContactRecord _record;
        private readonly int _contact;
        private readonly double _base;
        private readonly double _finest;
        private double _target;
        private int _impacts;
        private int _searches;
        private int _doublings;

        /// <summary>Seconds since the last impact.</summary>
        private double _flown;

        /// <summary>Share of the way up to which nothing is met.</summary>
        private double _from;
        private double _separation;
        private bool _met;
        private bool _over;

        public Meetings(in SweepInput input, in LonePair pair, in ContactRecord record)
        {
            this = default;
            _record = record;
            _contact = pair.Contact;
            _base = pair.Base;
            _finest = FastPairs.Tolerance(ExtentOf(input, record));
            _met = pair.Touches;
            _target = _base - (2 * _finest);
        }

        /// <summary>There was an impact.</summary>
        public readonly bool Any => _impacts > 0;

        /// <summary>There were too many.</summary>
        public readonly bool IsOver => _impacts >= MostImpacts || _searches >= MostSearches;

        private readonly double Tolerance => _finest * (1 << _doublings);

        /// <summary>When they meet, as a share of the way.</summary>
        public bool FindNext(in SweepInput input, in FreeLeg a, in FreeLeg b, out double time)
        {
            time = 1;
            if (_over)
            {
                return false;
            }

            ImpactQuery query;
            query.Tolerance = Tolerance;
            query.From = _from;
            query.Until = 1;
            var search = new TimeOfImpact(input.Shapes, _record.PieceA, a.Path, _record.PieceB, b.Path);
            if (!_met)
            {
                // The first impact is none as long as it is a glance.
                query.Target = -FastPairs.Glance(input.Shapes.Pieces[_record.PieceA], input.Shapes.Pieces[_record.PieceB]);
                if (!search.Find(query, out double deep, out _))
                {
                    return false;
                }

                query.Target = 0;
                query.Until = Math.Min(1, deep + FastPairs.MomentShare);
                search.Find(query, out time, out _separation);
                return true;
            }

            query.Target = _target;
            return search.Find(query, out time, out _separation);
        }

        /// <summary>Resolves what they meet with.</summary>
        /// <returns>True if they go on otherwise than before, from where they met.</returns>
        public bool Strike(in SweepInput input, ref FreeLeg a, ref FreeLeg b, double time, ref double left, ref PairImpulse given)
        {
            _searches++;
            double tolerance = Tolerance;
            PairInput pair = ImpactPose.Pair(input.Shapes, _record.PieceA, _record.PieceB, a.Path, b.Path, time, (float)(4 * tolerance));
            Collision.Collide(pair, out Manifold manifold);
            if (manifold.Count == 0)
            {
                // A search that creeps ends early, and is taken up there. If they do meet, one is one-sided and seen from behind.
                _over = _separation <= 2 * tolerance;
                _from = time;
                return false;
            }

            _met = true;
            double depth = manifold.Point0.Separation;
            depth = manifold.Count > 1 ? Math.Min(depth, manifold.Point1.Separation) : depth;
            _target = Math.Min(depth, _base) - (2 * tolerance);
            Mover mover = b.MoverAt(input.Bodies, time, left);
            Obstacle other = Other(input, a, b, time, left, manifold);
            Manifold own = Impact.Shift(manifold, pair.Offset);
            _flown += time * left;
            if (_impacts > 0 && Impact.Approach(mover, other, own) * _flown < PressShare * tolerance)
            {
                // They press on each other. To part at the speed at which they sank in keeps the energy, and their mean speed is none.
                other.Restitution = 1;
                other.Slowest = 0;
            }

            double approach = Impact.Approach(mover, other, own);
            Mover before = mover;
            if (!Impact.Resolve(ref mover, ref other, own))
            {
                return false;
            }

            other.Restitution = 0;
            for (int turn = 1; turn < MostTurns && Impact.Resolve(ref mover, ref other, own); turn++)
            {
            }

            _from = 0;
            _impacts++;
            PairImpulse here = Given(before, mover, manifold);
            given.Normal += here.Normal;
            given.Tangent += here.Tangent;
            if (input.Impulses != null)
            {
                NoteOnWay(input.Impulses, a, time, manifold, here, approach);
            }

            left *= 1 - time;
            Pace(left);
            _flown = 0;
            a.GoOn(time, other.VelocityX, other.VelocityY, other.Spin, left);
            b.GoOn(time, mover.VelocityX, mover.VelocityY, mover.Spin, left);
            return true;
        }

        /// <summary>Sets the tolerance by the time since the last impact.</summary>
        private void Pace(double left)
        {
            double wanted = left / Math.Max(1, WantedImpacts - _impacts);
            if (_impacts > 1 && _flown * 2 < wanted && _doublings < MostDoublings)
            {
                _doublings++;
            }
            else if (_flown > wanted * 2 && _doublings > 0)
            {
                _doublings--;
            }
        }

        private readonly Obstacle Other(in SweepInput input, in FreeLeg a, in FreeLeg b, double time, double left, in Manifold manifold)
        {
            Mover body = a.MoverAt(input.Bodies, time, left);
            Obstacle other = FastBodySweep.Describe(
                input, _contact, isA: false, a.Path.XAt(time) - b.Path.XAt(time), a.Path.YAt(time) - b.Path.YAt(time));
            other.VelocityX = body.VelocityX;
            other.VelocityY = body.VelocityY;
            other.Spin = body.Spin;
            other.InverseMass = body.InverseMass;
            other.InverseInertia = body.InverseInertia;
            other.Slowest = FastBodySweep.Slowest(input, b.Gain - a.Gain, manifold.Normal);
            other.Restitution = _impacts < MostBounces ? other.Restitution : 0;
            return other;
        }

        /// <summary>What B was given.</summary>
        private static PairImpulse Given(in Mover before, in Mover after, in Manifold manifold)
        {
            PairImpulse given = default;
            if (after.InverseMass > 0)
            {
                double x = (after.VelocityX - before.VelocityX) / after.InverseMass;
                double y = (after.VelocityY - before.VelocityY) / after.InverseMass;
                given.Normal = (x * manifold.Normal.X) + (y * manifold.Normal.Y);
                given.Tangent = (x * manifold.Normal.Y) - (y * manifold.Normal.X);
            }

            return given;
        }

        private readonly void NoteOnWay(
            ContactImpulses impulses, in FreeLeg a, double time, in Manifold manifold, in PairImpulse given, double approach)
        {
            Vector2 point = manifold.Point0.Anchor;
            point = manifold.Count > 1 ? (point + manifold.Point1.Anchor) / 2 : point;
            ContactImpulse impact = default;
            impact.Normal0 = given.Normal;
            impact.Tangent0 = given.Tangent;
            impact.Approach = (float)approach;
            impact.X = a.Path.XAt(time) + point.X;
            impact.Y = a.Path.YAt(time) + point.Y;
            impact.Axis = manifold.Normal;
            impulses.AddOnWay(_contact, impact);
        }

        private static float ExtentOf(in SweepInput input, in ContactRecord record) =>
            FastPairs.Extent(input.Shapes.Pieces[record.PieceA], input.Shapes.Pieces[record.PieceB], true, true);
    }
}
