using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;

namespace Farseer.Engine.Continuous;

/// <content>What a free body meets on its way, and what happens then.</content>
internal sealed partial class FastBodySweep
{
    /// <summary>Things that a body meets at the same moment and that are resolved together.</summary>
    private const int MostTogether = 8;

    /// <summary>Turns of these, until none changes the velocities any more.</summary>
    private const int MostTurns = 256;

    /// <summary>The impact of a free body with a candidate, and with what else it meets at that moment.</summary>
    private Meeting Meet(in SweepInput input, in FreeLeg leg, double time, double left, int found)
    {
        ref SweepCandidate candidate = ref _candidates[found];
        Surface met = Look(input, leg, time, left, candidate);
        if (met.Manifold.Count == 0)
        {
            bool missed = candidate.Mode == SweepMode.Met;
            candidate.Mode = missed ? SweepMode.Passed : SweepMode.Met;
            candidate.Target = missed ? candidate.Target : met.Target;
            return Meeting.Missed;
        }

        candidate.Mode = SweepMode.Met;
        candidate.Target = met.Target;
        if (met.IsHidden)
        {
            return Meeting.Missed;
        }

        Mover after = leg.MoverAt(input.Bodies, time, left);
        if (!Impact.Approaches(after, met.Obstacle, met.Own))
        {
            return Meeting.Missed;
        }

        leg.Place(input, time, left);
        var seen = new BodySeen(input.Bodies, leg.Body);
        Span<Surface> surfaces = stackalloc Surface[MostTogether];
        int count = 0;
        bool accepted = input.Listener.OnImpact(candidate.Contact, met.Manifold);
        if (accepted)
        {
            met.Contact = candidate.Contact;
            surfaces[count++] = met;
        }

        for (int i = 0; accepted && i < _count && count < MostTogether && !seen.HasChanged(input.Bodies, leg.Body); i++)
        {
            ref SweepCandidate other = ref _candidates[i];
            if (i == found || other.Moves != 0 || other.Mode == SweepMode.Passed)
            {
                continue;
            }

            Surface beside = Look(input, leg, time, left, other);
            if (beside.Manifold.Count > 0
                && !beside.IsHidden
                && beside.Depth <= 2 * beside.Tolerance
                && Impact.Approaches(after, beside.Obstacle, beside.Own))
            {
                other.Mode = input.Listener.OnImpact(other.Contact, beside.Manifold) ? SweepMode.Met : SweepMode.Passed;
                other.Target = beside.Target;
                beside.Contact = other.Contact;
                surfaces[count] = beside;
                count += other.Mode == SweepMode.Met ? 1 : 0;
            }
        }

        if (seen.HasChanged(input.Bodies, leg.Body))
        {
            // A handler took the body into its own hands.
            return Meeting.Gone;
        }

        if (!accepted)
        {
            candidate.Mode = SweepMode.Passed;
            return Meeting.Refused;
        }

        Resolve(ref after, surfaces.Slice(0, count));
        if (input.Impulses != null)
        {
            NoteImpulses(input, leg, surfaces.Slice(0, count), time);
        }

        ref BodyState now = ref input.Bodies.State[leg.Body];
        now.LinearVelocity = new Vector2((float)after.VelocityX, (float)after.VelocityY);
        now.AngularVelocity = (float)after.Spin;
        if (met.Depth < 0 && met.Depth > -4 * met.Tolerance)
        {
            ref BodyPose pose = ref input.Bodies.Pose[leg.Body];
            pose.X -= met.Depth * met.Own.Normal.X;
            pose.Y -= met.Depth * met.Own.Normal.Y;
            candidate.Target = -met.Tolerance;
        }

        return Meeting.Struck;
    }

    private static void Resolve(ref Mover mover, Span<Surface> surfaces)
    {
        Mover before = mover;
        for (int i = 0; i < surfaces.Length; i++)
        {
            surfaces[i].Approach = Impact.Approach(mover, surfaces[i].Obstacle, surfaces[i].Own);
        }

        if (surfaces.Length == 1)
        {
            Impact.Resolve(ref mover, ref surfaces[0].Obstacle, surfaces[0].Own);
            surfaces[0].NoteGiven(before, mover);
            return;
        }

        // Each by itself first, then in turns until nothing changes: one after the other alone would throw a symmetric body into a spin.
        for (int i = 0; i < surfaces.Length; i++)
        {
            surfaces[i].Impact = new ImpactInTurns(mover, surfaces[i].Obstacle, surfaces[i].Own);
        }

        bool changed = true;
        for (int turn = 0; turn < MostTurns && changed; turn++)
        {
            changed = false;
            for (int i = 0; i < surfaces.Length; i++)
            {
                changed |= surfaces[i].Impact.Solve(ref mover, surfaces[i].Obstacle);
            }
        }

        for (int i = 0; i < surfaces.Length; i++)
        {
            before = mover;
            surfaces[i].Impact.Rub(ref mover, ref surfaces[i].Obstacle, surfaces[i].Own);
            surfaces[i].NoteGiven(before, mover);
            surfaces[i].Normal += surfaces[i].Impact.Given;
        }
    }

    /// <summary>Adds what the surfaces gave to the sums of the step.</summary>
    private static void NoteImpulses(in SweepInput input, in FreeLeg leg, Span<Surface> surfaces, double time)
    {
        for (int i = 0; i < surfaces.Length; i++)
        {
            ref Surface surface = ref surfaces[i];
            ContactRecord record = input.Contacts.Records[surface.Contact];
            bool isA = record.BodyA == leg.Body;
            Vector2 point = surface.Own.Point0.Anchor;
            point = surface.Own.Count > 1 ? (point + surface.Own.Point1.Anchor) / 2 : point;
            ContactImpulse given = default;
            given.Normal0 = surface.Normal;
            given.Tangent0 = surface.Tangent;
            given.Approach = (float)surface.Approach;
            given.X = leg.Path.XAt(time) + point.X;
            given.Y = leg.Path.YAt(time) + point.Y;
            given.Axis = isA ? -surface.Own.Normal : surface.Own.Normal;
            input.Impulses!.AddOnWay(surface.Contact, given);
        }
    }

    /// <summary>What a candidate shows to a body at a moment of its way.</summary>
    private static Surface Look(in SweepInput input, in FreeLeg leg, double time, double left, in SweepCandidate candidate)
    {
        int body = leg.Body;
        BodyPath path = leg.Path;
        ContactRecord record = input.Contacts.Records[candidate.Contact];
        bool isA = record.BodyA == body;
        int other = isA ? record.BodyB : record.BodyA;
        float extent = Extent(input.Shapes, record, isA);
        Surface surface = default;
        surface.Tolerance = FastPairs.Tolerance(extent);
        BodyPath otherPath = PathOf(input, other, left);
        PairInput pair = ImpactPose.Pair(
            input.Shapes,
            record.PieceA,
            record.PieceB,
            isA ? path : otherPath,
            isA ? otherPath : path,
            time,
            (float)(4 * surface.Tolerance));
        Collision.Collide(pair, out surface.Manifold);
        double depth = surface.Manifold.Count > 0 ? surface.Manifold.Point0.Separation : -CoreShare * extent;
        depth = surface.Manifold.Count > 1 ? Math.Min(depth, surface.Manifold.Point1.Separation) : depth;
        surface.Depth = depth;
        surface.Target = Math.Min(depth, surface.Tolerance) - (2 * surface.Tolerance);
        if (surface.Manifold.Count > 0)
        {
            surface.Obstacle =
                Describe(input, candidate.Contact, isA, otherPath.XAt(time) - path.XAt(time), otherPath.YAt(time) - path.YAt(time));
            surface.Obstacle.Slowest = Slowest(input, leg.Gain, surface.Manifold.Normal);
            surface.Own = isA ? Impact.Flip(surface.Manifold) : Impact.Shift(surface.Manifold, pair.Offset);
            surface.IsHidden = record.Mover == (isA ? record.PieceA : record.PieceB)
                && IsHidden(input, candidate.Contact, surface.Manifold, path, (time - 1) * left, time);
            surface.Target = surface.IsHidden ? Math.Min(depth, 0) - (CoreShare * extent) : surface.Target;
        }

        return surface;
    }

    /// <summary>A candidate at the moment of an impact.</summary>
    private struct Surface
    {
        public Manifold Manifold;

        /// <summary>The same as the mover sees it.</summary>
        public Manifold Own;
        public Obstacle Obstacle;
        public ImpactInTurns Impact;
        public int Contact;

        /// <summary>How fast the body came nearer, and what it was given along the normal that points at it, and across.</summary>
        public double Approach;
        public double Normal;
        public double Tangent;
        public double Depth;
        public double Tolerance;

        /// <summary>It is the next piece of a surface that the body meets.</summary>
        public bool IsHidden;

        /// <summary>How deep it may come before it is met again.</summary>
        public double Target;

        /// <summary>
        /// Notes what changed the body's velocity. The tangent turns with the normal, so its part is the same for both bodies.
        /// </summary>
        public void NoteGiven(in Mover before, in Mover after)
        {
            if (after.InverseMass > 0)
            {
                double x = (after.VelocityX - before.VelocityX) / after.InverseMass;
                double y = (after.VelocityY - before.VelocityY) / after.InverseMass;
                Normal += (x * Own.Normal.X) + (y * Own.Normal.Y);
                Tangent += (x * Own.Normal.Y) - (y * Own.Normal.X);
            }
        }
    }
}
