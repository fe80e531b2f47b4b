using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Solver;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Continuous;

/// <summary>
/// Follows a fast body along the way that it took in this step. A free one bounces where and when it meets what cannot move, and
/// flies on with the rest of its time; one that the solver moved is stopped there, keeps its velocity, and the next step finds it in
/// contact. Either may lose the rest of its step, but never passes.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed partial class FastBodySweep
{
    /// <summary>Impacts of one body in a step; after them it waits for the next.</summary>
    private const int MostImpacts = 16;

    /// <summary>Searches of one body in a step that end in something to look at.</summary>
    private const int MostSearches = 96;

    /// <summary>
    /// Share of its extent by which a body that the solver handled may sink into something: what it does there is the solver's
    /// business, as long as it does not get through.
    /// </summary>
    private const double CoreShare = 0.25;

    /// <summary>The same for a body with joints: stopping it alone tears them open by as much as it is put back.</summary>
    private const double JointedCoreShare = 0.75;

    /// <summary>Impacts slower than this many substeps of outside acceleration are rest, as in the solver.</summary>
    private const double RestSubsteps = 4;

    private readonly Column<SweepCandidate> _candidates = new Column<SweepCandidate>();
    private int _count;

    public void Begin() => _count = 0;

    public void Add(int contact, bool moves)
    {
        _candidates.EnsureCapacity(_count + 1);
        _candidates[_count++] = new SweepCandidate { Contact = contact, Moves = moves ? (byte)1 : (byte)0 };
    }

    /// <summary>Makes room for so many candidates.</summary>
    public void Reserve(int candidates) => _candidates.EnsureCapacity(candidates);

    /// <summary>Whether <see cref="Run"/> would leave the body as it is. Nothing changes by the question.</summary>
    public bool MeetsNothing(in SweepInput input, in FastMotion motion)
    {
        if (motion.Free != 0)
        {
            FreeLeg leg = FreeLeg.Of(input.Bodies, motion, input.Dt);
            return FindFirst(input, leg.Body, leg.Path, input.Dt, out _) < 0;
        }

        BodyPath path = WayOf(input, motion);
        return input.Listener.AddsNothing(motion.Body, path) && FindGuarded(input, motion.Body, path, out _) < 0;
    }

    /// <summary>Sweeps one body against the candidates added.</summary>
    public void Run(in SweepInput input, in FastMotion motion)
    {
        if (motion.Free != 0)
        {
            FlyOn(input, FreeLeg.Of(input.Bodies, motion, input.Dt), input.Dt, moved: false);
        }
        else
        {
            Guard(input, motion);
        }
    }

    /// <summary>Lets a body that is placed on its way fly to the end of the step, and bounce off what it meets.</summary>
    /// <param name="input">The world.</param>
    /// <param name="leg">Its way.</param>
    /// <param name="left">Seconds that the way takes.</param>
    /// <param name="moved">It is not where this way ends.</param>
    public void FlyOn(in SweepInput input, FreeLeg leg, double left, bool moved)
    {
        int impacts = 0;
        for (int search = 0; ; search++)
        {
            int found = FindFirst(input, leg.Body, leg.Path, left, out double time);
            bool stop = found >= 0 && (search == MostSearches || impacts == MostImpacts || _candidates[found].Moves != 0);
            if (found < 0 && !moved)
            {
                return;
            }

            if (found < 0 || stop)
            {
                leg.Place(input, found < 0 ? 1 : time, left);
                return;
            }

            Meeting meeting = Meet(input, leg, time, left, found);
            if (meeting == Meeting.Gone)
            {
                return;
            }

            moved |= meeting != Meeting.Missed;
            if (meeting != Meeting.Struck)
            {
                continue;
            }

            impacts++;
            left *= 1 - time;
            if (!(left > 0))
            {
                return;
            }

            leg.GoOn(input.Bodies, left);
            input.Listener.OnWay(this, leg.Body, leg.Path);
        }
    }

    /// <summary>Whether the body meets something on its way before a share of it.</summary>
    public bool MeetsBefore(in SweepInput input, in FreeLeg leg, double left, double until) =>
        _count > 0 && FindFirst(input, leg.Body, leg.Path, left, out double time) >= 0 && time < until;

    public static Obstacle Describe(in SweepInput input, int contact, bool isA, double x, double y)
    {
        ref ContactRecord record = ref input.Contacts.Records[contact];
        BodyState state = input.Bodies.State[isA ? record.BodyB : record.BodyA];
        Obstacle obstacle = default;
        obstacle.X = x;
        obstacle.Y = y;
        obstacle.VelocityX = state.LinearVelocity.X;
        obstacle.VelocityY = state.LinearVelocity.Y;
        obstacle.Spin = state.AngularVelocity;
        obstacle.Restitution = ContactUpdate.MixRestitution(input.Shapes, input.Settings.RestitutionMix, record);
        obstacle.MostDriven = input.Driven.SpeedOf(input.Bodies, record.BodyA, record.BodyB);
        obstacle.Friction = input.Settings.FreezePairFriction
            ? input.Contacts.FirstFriction[contact]
            : ContactUpdate.MixFriction(input.Shapes, input.Settings.FrictionMix, record);
        if (input.Contacts.Surfaces.IsOn && input.Contacts.Surfaces[contact].IsSet != 0)
        {
            ref PairSurface surface = ref input.Contacts.Surfaces[contact];
            obstacle.Restitution = surface.Restitution;
            obstacle.Friction = surface.IsSpecial ? 0 : surface.Friction;
        }

        return obstacle;
    }

    /// <summary>
    /// The body flies or slides on to the next piece of one surface; it may sink in there as far as where the solver has it in hand.
    /// </summary>
    private static bool IsHidden(in SweepInput input, int contact, in Manifold manifold, in BodyPath path, double ahead, double time)
    {
        SeamInput seam;
        seam.Shapes = input.Shapes;
        seam.Bodies = input.Bodies;
        seam.Contacts = input.Contacts;
        seam.Ahead = (float)ahead;
        return HiddenContact.Is(seam, contact, manifold, path.PoseAt(time));
    }

    /// <summary>An approach slower than this is rest.</summary>
    /// <param name="input">The world.</param>
    /// <param name="gain">Acceleration of one as the other sees it.</param>
    /// <param name="normal">Of the contact.</param>
    public static double Slowest(in SweepInput input, Vector2 gain, Vector2 normal)
    {
        double weight = Math.Abs(((double)gain.X * normal.X) + ((double)gain.Y * normal.Y));
        return Math.Max(RestSubsteps * input.Substep * weight, input.Settings.BounceThreshold);
    }

    private void Guard(in SweepInput input, in FastMotion motion)
    {
        int body = motion.Body;
        BodyPath path = WayOf(input, motion);
        input.Listener.OnWay(this, body, path);
        if (FindGuarded(input, body, path, out double time) >= 0)
        {
            ref BodyPose pose = ref input.Bodies.Pose[body];
            pose.X = path.XAt(time);
            pose.Y = path.YAt(time);
            pose.Angle = path.AngleAt(time);
            FinishBodies.UpdateRotor(ref pose);
            TakeBackFall(input, body, (1 - time) * input.Dt);
        }
    }

    /// <summary>
    /// A body that is stopped has not fallen for the rest of the step, and is to have no speed of it: left with that, one that is stopped
    /// again and again gains the energy of each fall.
    /// </summary>
    private static void TakeBackFall(in SweepInput input, int body, double time)
    {
        Vector2 gravity = input.Settings.Gravity;
        ref BodyState state = ref input.Bodies.State[body];
        double falling = ((double)state.LinearVelocity.X * gravity.X) + ((double)state.LinearVelocity.Y * gravity.Y);
        if (falling > 0 && (input.Bodies.Flags[body] & BodyFlags.IgnoreGravity) == 0)
        {
            double square = ((double)gravity.X * gravity.X) + ((double)gravity.Y * gravity.Y);
            state.LinearVelocity -= (float)Math.Min(time, falling / square) * gravity;
        }
    }

    /// <summary>The way of a body that the solver moved, as if straight.</summary>
    private static BodyPath WayOf(in SweepInput input, in FastMotion motion)
    {
        BodyPath path = default;
        BodyPose end = input.Bodies.Pose[motion.Body];
        path.X = motion.X;
        path.Y = motion.Y;
        path.Angle = motion.Angle;
        path.VelocityX = end.X - motion.X;
        path.VelocityY = end.Y - motion.Y;
        path.Spin = end.Angle - motion.Angle;
        return path;
    }

    /// <summary>The candidate whose core such a body meets first, and when; -1: none.</summary>
    private int FindGuarded(in SweepInput input, int body, in BodyPath path, out double time)
    {
        int found = -1;
        time = 1;
        for (int i = 0; i < _count; i++)
        {
            if (FindGuardedTime(input, body, path, time, ref _candidates[i], out double at) && IsFirst(input, i, at, found, time))
            {
                found = i;
                time = at;
            }
        }

        return found;
    }

    /// <summary>
    /// What the solver had in hand, or what touched from the start, may sink in on: only the core must not pass. So may a body that
    /// has joints.
    /// </summary>
    private static bool FindGuardedTime(
        in SweepInput input, int body, in BodyPath path, double until, ref SweepCandidate candidate, out double time)
    {
        time = 1;
        ref ContactRecord record = ref input.Contacts.Records[candidate.Contact];
        bool isA = record.BodyA == body;
        float extent = Extent(input.Shapes, record, isA);
        BodyPath other = PathOf(input, isA ? record.BodyB : record.BodyA, input.Dt);
        if (IsClear(input, record, isA, path, other, extent))
        {
            return false;
        }

        var search = new TimeOfImpact(input.Shapes, record.PieceA, isA ? ref path : ref other, record.PieceB, isA ? ref other : ref path);
        double separation = search.SeparationAtStart();
        bool jointed = input.Joints.Degree(body) > 0;
        if (record.Color >= 0 || jointed || separation <= PairStage.SkinShare * extent)
        {
            candidate.Mode = SweepMode.Met;
            candidate.Target = Math.Min(separation, 0) - ((jointed ? JointedCoreShare : CoreShare) * extent);
        }

        if (!FindTime(input, ref search, extent, candidate, until, out time))
        {
            return false;
        }

        if (candidate.Mode == SweepMode.Met || !IsHiddenAt(input, candidate.Contact, isA, path, other, time))
        {
            return true;
        }

        candidate.Mode = SweepMode.Met;
        candidate.Target = -CoreShare * extent;
        return FindTime(input, ref search, extent, candidate, until, out time);
    }

    /// <summary>Whether what such a body meets then is hidden by something else that it meets.</summary>
    private static bool IsHiddenAt(in SweepInput input, int contact, bool isA, in BodyPath path, in BodyPath other, double time)
    {
        ref ContactRecord record = ref input.Contacts.Records[contact];
        if (record.Mover != (isA ? record.PieceA : record.PieceB))
        {
            return false;
        }

        float margin = (float)(4 * FastPairs.Tolerance(Extent(input.Shapes, record, isA)));
        PairInput pair = ImpactPose.Pair(
            input.Shapes, record.PieceA, record.PieceB, isA ? path : other, isA ? other : path, time, margin);
        Collision.Collide(pair, out Manifold manifold);
        return manifold.Count > 0 && IsHidden(input, contact, manifold, path, (time - 1) * input.Dt, time);
    }

    /// <summary>The candidate that is met first, and when; -1: none. At the same time, the pair with the lower pieces.</summary>
    private int FindFirst(in SweepInput input, int body, in BodyPath path, double left, out double time)
    {
        int found = -1;
        time = 1;
        for (int i = 0; i < _count; i++)
        {
            ref SweepCandidate candidate = ref _candidates[i];
            if (candidate.Mode == SweepMode.Passed)
            {
                continue;
            }

            if (FindTime(input, body, path, left, time, candidate, out double at) && IsFirst(input, i, at, found, time))
            {
                found = i;
                time = at;
            }
        }

        return found;
    }

    private bool IsFirst(in SweepInput input, int candidate, double at, int found, double time) =>
        found < 0 || at < time || (at == time && IsBefore(input, _candidates[candidate], _candidates[found]));

    private static bool IsBefore(in SweepInput input, in SweepCandidate a, in SweepCandidate b)
    {
        ContactRecord first = input.Contacts.Records[a.Contact];
        ContactRecord second = input.Contacts.Records[b.Contact];
        return first.PieceA != second.PieceA ? first.PieceA < second.PieceA : first.PieceB < second.PieceB;
    }

    private static bool FindTime(
        in SweepInput input, int body, in BodyPath path, double left, double until, in SweepCandidate candidate, out double time)
    {
        ref ContactRecord record = ref input.Contacts.Records[candidate.Contact];
        bool isA = record.BodyA == body;
        float extent = Extent(input.Shapes, record, isA);
        BodyPath other = PathOf(input, isA ? record.BodyB : record.BodyA, left);
        if (IsClear(input, record, isA, path, other, extent))
        {
            time = 1;
            return false;
        }

        var search = new TimeOfImpact(input.Shapes, record.PieceA, isA ? ref path : ref other, record.PieceB, isA ? ref other : ref path);
        return FindTime(input, ref search, extent, candidate, until, out time);
    }

    private static bool FindTime(
        in SweepInput input, ref TimeOfImpact search, float extent, in SweepCandidate candidate, double until, out double time)
    {
        ImpactQuery query;
        query.Tolerance = FastPairs.Tolerance(extent);
        query.From = 0;
        query.Until = Math.Min(1, until + FastPairs.MomentShare);
        if (candidate.Mode == SweepMode.Met)
        {
            query.Target = candidate.Target;
            return search.Find(query, out time, out _);
        }

        ref ContactRecord record = ref input.Contacts.Records[candidate.Contact];
        query.Target = -FastPairs.Glance(input.Shapes.Pieces[record.PieceA], input.Shapes.Pieces[record.PieceB]);
        query.Until = 1;
        if (!search.Find(query, out time, out _))
        {
            return false;
        }

        query.Target = 0;
        query.Until = 1;
        return search.Find(query, out time, out _);
    }

    /// <summary>They come nowhere so near that they would count as touching.</summary>
    private static bool IsClear(
        in SweepInput input, in ContactRecord record, bool isA, in BodyPath path, in BodyPath other, float extent) =>
        isA
            ? ClearWay.Holds(input.Shapes, record, path, other, ofA: false, PairStage.SkinShare * extent)
            : ClearWay.Holds(input.Shapes, record, other, path, ofA: true, PairStage.SkinShare * extent);

    private static float Extent(ShapeStore shapes, in ContactRecord record, bool isA) =>
        shapes.Pieces[isA ? record.PieceA : record.PieceB].Extent;

    /// <summary>Where the other body is in the time left: it is at the end of its step already.</summary>
    private static BodyPath PathOf(in SweepInput input, int body, double left)
    {
        BodyPath path = BodyPath.Resting(input.Bodies.Pose[body]);
        if ((input.Bodies.Flags[body] & BodyFlags.Static) == 0)
        {
            BodyState state = input.Bodies.State[body];
            path.VelocityX = state.LinearVelocity.X * left;
            path.VelocityY = state.LinearVelocity.Y * left;
            path.Spin = state.AngularVelocity * left;
            path.X -= path.VelocityX;
            path.Y -= path.VelocityY;
            path.Angle -= path.Spin;
        }

        return path;
    }

    private enum Meeting
    {
        /// <summary>No contact, or none that approaches.</summary>
        Missed,

        /// <summary>A handler cancelled the response; the body is where they met, and its way goes on.</summary>
        Refused,
        Struck,

        /// <summary>A handler moved, stopped or removed the body.</summary>
        Gone,
    }
}
