using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Farseer.Hunt.Calls;

namespace Farseer.Hunt.Running;

/// <summary>What must hold after each step, for both facades.</summary>
internal sealed class Invariants(Profile profile, Observer observer)
{
    /// <summary>
    /// Energy may rise by this share of what there was to begin with: contacts of turning corners and steps of changing length gain
    /// some in single impacts
    /// and lose more in others.
    /// </summary>
    private const double EnergyShare = 0.25;

    /// <summary>
    /// A height by which everything may be lifted besides: overlaps at the start, slacks of limits, margins of contacts; metres.
    /// </summary>
    private const double Lift = 0.1;

    /// <summary>Momentum is a sum of products of floats that are rounded in each substep of each contact.</summary>
    private const double MomentumShare = 1e-3;

    /// <summary>The floor's surface is at 0 and it is 2 thick: what is deeper than half of it has come through.</summary>
    private const double Through = -1;

    /// <summary>Where the floor ends.</summary>
    private const double FloorHalf = 95;

    private readonly Dictionary<object, Start> _starts = new(ReferenceEqualityComparer.Instance);

    /// <returns>What does not hold, or null.</returns>
    public (string Kind, string Text, double Excess)? After(object world, float dt, IEnumerable<object> items, bool isCalm)
    {
        if (observer.Problems.Count > 0)
        {
            return (observer.Problems[0].Kind, observer.Problems[0].Text, 1);
        }

        if (profile != Profile.Extreme && observer.Quarantined.Count > 0)
        {
            return ("quarantine", observer.Quarantined[0], 1);
        }

        foreach (object item in items.Where(i => observer.IsStepped(world, i)).Concat(observer.MoreItems(world)))
        {
            if (Values.FirstUnsound(item) is { } unsound && !observer.MayBeInfinite(item, unsound.Name))
            {
                return ("not finite: " + unsound.Name, Say($"{item.GetType().Name} {unsound.Value}"), 1);
            }
        }

        if (isCalm && observer.Lists(world) is { } wrong)
        {
            return (wrong.Split(':')[0], wrong, 1);
        }

        return profile < Profile.Ordinary ? Untouched(world, dt) : null;
    }

    private static string Say(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    private List<BodyFact> Moving(object world) => observer.Bodies(world).Where(b => b.Moves).ToList();

    private (string Kind, string Text, double Excess)? Untouched(object world, float dt)
    {
        List<BodyFact> bodies = Moving(world);
        if (!_starts.TryGetValue(world, out Start? start))
        {
            // The first step takes the bodies in.
            _starts.Add(world, new Start(observer.Bodies(world), observer.Gravity(world), observer.HasContacts(world)));
            return null;
        }

        if (!start.IsPassive || bodies.Count != start.Count)
        {
            // A body that rolled off the floor has left its world.
            return null;
        }

        double energy = Start.Energy(bodies, start.Gravity);
        if (energy > start.Most)
        {
            return ("energy", Say($"{energy:g5} J after {start.First:g5} J, at most {start.Most:g5} J, in a step of {dt} s"),
                (energy - start.First) / (start.Most - start.First));
        }

        start.HasTouched |= observer.HasContacts(world);
        if (profile == Profile.Passive && start.HasTouched && !start.IsFree && start.IsAbove && bodies.Where(b => b.Y < Through
            && Math.Abs(b.X) < FloorHalf).Select(b => (BodyFact?)b).FirstOrDefault() is { } below)
        {
            return ("below the floor", Say($"{below}"), 1);
        }

        if (profile == Profile.Free && start.IsFree)
        {
            double x = bodies.Sum(b => b.Mass * b.Vx) - start.MomentumX;
            double y = bodies.Sum(b => b.Mass * b.Vy) - start.MomentumY;
            if (Math.Abs(x) + Math.Abs(y) > start.MostMomentumError)
            {
                return ("momentum", Say($"({x:g5}, {y:g5}) kg m/s came from nowhere, at most {start.MostMomentumError:g3}"),
                    (Math.Abs(x) + Math.Abs(y)) / start.MostMomentumError);
            }
        }

        return null;
    }

    /// <summary>What an untouched world began with.</summary>
    private sealed class Start
    {
        public Start(List<BodyFact> all, (double X, double Y) gravity, bool touches)
        {
            List<BodyFact> bodies = all.Where(b => b.Moves).ToList();
            Gravity = gravity;
            Count = bodies.Count;
            First = Energy(bodies, gravity);
            IsFree = bodies.Count == all.Count;
            IsAbove = bodies.TrueForAll(b => b.Y > 0);

            // What has a velocity and no finite mass or inertia is a drive, and what overlaps from the beginning is pushed out.
            IsPassive = !touches && all.All(b => (b.Moves && (b.Inertia > 0 || b.Spin == 0)) || (!b.Moves && b.Kinetic == 0
                && b.Vx == 0 && b.Vy == 0 && b.Spin == 0));
            double weight = bodies.Sum(b => b.Mass) * Math.Sqrt((gravity.X * gravity.X) + (gravity.Y * gravity.Y));
            double kinetic = bodies.Sum(b => b.Kinetic);
            double falls = bodies.Sum(b => b.Mass * Math.Abs(gravity.Y * b.Y));
            Most = First + (EnergyShare * (kinetic + falls)) + (Lift * weight) + 1e-6;
            MomentumX = bodies.Sum(b => b.Mass * b.Vx);
            MomentumY = bodies.Sum(b => b.Mass * b.Vy);
            MostMomentumError = (MomentumShare * bodies.Sum(b
                => b.Mass * (Math.Abs(b.Vx) + Math.Abs(b.Vy) + Math.Sqrt(b.Kinetic / b.Mass)))) + 1e-6;
        }

        /// <summary>Nobody is fixed.</summary>
        public bool IsFree { get; }

        /// <summary>Nobody's middle was in the floor: a line all around in the floor touches nothing, and falls out of it.</summary>
        public bool IsAbove { get; }

        /// <summary>Something has touched: there is a floor.</summary>
        public bool HasTouched { get; set; }

        public bool IsPassive { get; }

        public (double X, double Y) Gravity { get; }

        public int Count { get; }

        public double First { get; }

        public double Most { get; }

        public double MomentumX { get; }

        public double MomentumY { get; }

        public double MostMomentumError { get; }

        public static double Energy(List<BodyFact> bodies, (double X, double Y) gravity) =>
            bodies.Sum(b => b.Kinetic - (b.Mass * ((gravity.X * b.X) + (gravity.Y * b.Y))));
    }
}
