using System;
using System.Numerics;
using Farseer.Engine.NarrowPhase;

namespace Farseer.Engine.Continuous;

/// <summary>A body in free flight as an impact finds it.</summary>
internal struct Mover
{
    public double VelocityX;
    public double VelocityY;
    public double Spin;
    public double InverseMass;
    public double InverseInertia;

    /// <summary>The length against which its speed of turning counts.</summary>
    public double Reach;

    public readonly double Speed => Math.Abs(VelocityX) + Math.Abs(VelocityY) + (Math.Abs(Spin) * Reach);
}

/// <summary>
/// What an impact meets: the other body, with the velocity of its surface. One that no impulse moves has no inverse mass.
/// </summary>
internal struct Obstacle
{
    /// <summary>Its centre from the mover's.</summary>
    public double X;
    public double Y;
    public double VelocityX;
    public double VelocityY;
    public double Spin;
    public double InverseMass;
    public double InverseInertia;
    public double Restitution;

    /// <summary>Speed up to which a restitution above 1 makes a rebound faster than its approach.</summary>
    public double MostDriven;
    public double Friction;

    /// <summary>An approach slower than this is rest and does not bounce.</summary>
    public double Slowest;
}

/// <summary>
/// The impact of a free body on another body, or on something that cannot move, at the moment and with the arms of the impact: both
/// points at once as a 2×2 complementarity problem, v' ≥ -e·v, then friction within its cone. With exact arms an impact never adds energy.
/// </summary>
internal static class Impact
{
    /// <summary>Slower than this share of the body's speed it does not approach, which leaves out rounding.</summary>
    private const double LeastApproach = 1e-6;

    /// <param name="mover">Its velocities are changed.</param>
    /// <param name="other">What it meets; its velocities are changed if it can move.</param>
    /// <param name="manifold">Points from the mover's centre; the normal points away from the obstacle.</param>
    /// <returns>False if no point approaches.</returns>
    public static bool Resolve(ref Mover mover, ref Obstacle other, in Manifold manifold)
    {
        if (!Approaches(mover, other, manifold))
        {
            return false;
        }

        var first = new Row(mover, other, manifold.Point0.Anchor, manifold.Normal);
        Row second = manifold.Count > 1 ? new Row(mover, other, manifold.Point1.Anchor, manifold.Normal) : default;

        double b0 = first.Velocity - first.Target(other);
        double x0;
        double x1 = 0;
        if (manifold.Count < 2)
        {
            x0 = Stop(first.K, b0);
        }
        else
        {
            Solve(first.K, second.K, Coupling(mover, other, first, second), b0, second.Velocity - second.Target(other), out x0, out x1);
        }

        double sum = x0 + x1;
        mover.VelocityX += mover.InverseMass * sum * manifold.Normal.X;
        mover.VelocityY += mover.InverseMass * sum * manifold.Normal.Y;
        mover.Spin += mover.InverseInertia * ((first.Arm * x0) + (second.Arm * x1));
        other.VelocityX -= other.InverseMass * sum * manifold.Normal.X;
        other.VelocityY -= other.InverseMass * sum * manifold.Normal.Y;
        other.Spin -= other.InverseInertia * ((first.OtherArm * x0) + (second.OtherArm * x1));
        Rub(ref mover, ref other, manifold.Point0.Anchor, manifold.Normal, x0);
        if (manifold.Count > 1)
        {
            Rub(ref mover, ref other, manifold.Point1.Anchor, manifold.Normal, x1);
        }

        return true;
    }

    /// <summary>Whether a point approaches, more than by rounding.</summary>
    public static bool Approaches(in Mover mover, in Obstacle other, in Manifold manifold) =>
        Approach(mover, other, manifold) > LeastApproach * mover.Speed;

    /// <summary>The greatest speed at which a point approaches; negative if all part.</summary>
    public static double Approach(in Mover mover, in Obstacle other, in Manifold manifold)
    {
        double first = new Row(mover, other, manifold.Point0.Anchor, manifold.Normal).Velocity;
        return manifold.Count < 2 ? -first : -Math.Min(first, new Row(mover, other, manifold.Point1.Anchor, manifold.Normal).Velocity);
    }

    /// <summary>Points from the mover as the pair's A: only the normal turns round.</summary>
    public static Manifold Flip(Manifold manifold)
    {
        manifold.Normal = -manifold.Normal;
        return manifold;
    }

    /// <summary>Points from the mover as the pair's B.</summary>
    public static Manifold Shift(Manifold manifold, Vector2 offset)
    {
        manifold.Point0.Anchor -= offset;
        manifold.Point1.Anchor -= offset;
        return manifold;
    }

    internal static double Coupling(in Mover mover, in Obstacle other, in Row a, in Row b) =>
        mover.InverseMass + (mover.InverseInertia * a.Arm * b.Arm) + (other.InverseMass + (other.InverseInertia * a.OtherArm * b.OtherArm));

    // Finds x ≥ 0 with w = K·x + b ≥ 0 and x·w = 0, case by case: both, the first, the second.
    internal static void Solve(double k11, double k22, double k12, double b0, double b1, out double x0, out double x1)
    {
        const double LeastDeterminant = 1e-9;
        double determinant = (k11 * k22) - (k12 * k12);
        if (determinant > LeastDeterminant * k11 * k22)
        {
            x0 = ((k12 * b1) - (k22 * b0)) / determinant;
            x1 = ((k12 * b0) - (k11 * b1)) / determinant;
            if (x0 >= 0 && x1 >= 0)
            {
                return;
            }
        }

        x0 = Stop(k11, b0);
        x1 = 0;
        if (b1 + (k12 * x0) >= 0)
        {
            return;
        }

        x1 = Stop(k22, b1);
        x0 = 0;
    }

    /// <summary>
    /// The impulse x ≥ 0 with K·x + b ≥ 0. What a handler has taken out of motion on the way does not answer, and gets none.
    /// </summary>
    internal static double Stop(double k, double b) => k > 0 ? Math.Max(0, -b / k) : 0;

    internal static void Rub(ref Mover mover, ref Obstacle other, Vector2 arm, Vector2 normal, double push)
    {
        // t = (ny, -nx), and r×t = -r·n.
        double turn = -(((double)arm.X * normal.X) + ((double)arm.Y * normal.Y));
        double otherTurn = -(((arm.X - other.X) * normal.X) + ((arm.Y - other.Y) * normal.Y));
        Velocity(mover, other, arm, out double x, out double y);
        double slide = (x * normal.Y) - (y * normal.X);
        double k = mover.InverseMass + (mover.InverseInertia * turn * turn)
            + (other.InverseMass + (other.InverseInertia * otherTurn * otherTurn));
        double bound = other.Friction * push;
        double impulse = k > 0 ? Math.Max(-bound, Math.Min(bound, -slide / k)) : 0;
        mover.VelocityX += mover.InverseMass * impulse * normal.Y;
        mover.VelocityY -= mover.InverseMass * impulse * normal.X;
        mover.Spin += mover.InverseInertia * impulse * turn;
        other.VelocityX -= other.InverseMass * impulse * normal.Y;
        other.VelocityY += other.InverseMass * impulse * normal.X;
        other.Spin -= other.InverseInertia * impulse * otherTurn;
    }

    /// <summary>Velocity of the mover's point relative to the obstacle's.</summary>
    private static void Velocity(in Mover mover, in Obstacle other, Vector2 arm, out double x, out double y)
    {
        x = mover.VelocityX - (mover.Spin * arm.Y) - (other.VelocityX - (other.Spin * (arm.Y - other.Y)));
        y = mover.VelocityY + (mover.Spin * arm.X) - (other.VelocityY + (other.Spin * (arm.X - other.X)));
    }

    internal readonly struct Row
    {
        public readonly double Arm;
        public readonly double OtherArm;
        public readonly double Velocity;
        public readonly double K;

        public Row(in Mover mover, in Obstacle other, Vector2 arm, Vector2 normal)
        {
            Arm = ((double)arm.X * normal.Y) - ((double)arm.Y * normal.X);
            OtherArm = ((arm.X - other.X) * normal.Y) - ((arm.Y - other.Y) * normal.X);
            Impact.Velocity(mover, other, arm, out double x, out double y);
            Velocity = (x * normal.X) + (y * normal.Y);
            K = mover.InverseMass + (mover.InverseInertia * Arm * Arm) + (other.InverseMass + (other.InverseInertia * OtherArm * OtherArm));
        }

        /// <summary>
        /// The speed at which the surfaces are to part at least. An impulse x at a point takes the energy -x·(v + v')/2, so one that parts
        /// already may come to approach as fast: stopped before, it would add energy. It is met again later.
        /// </summary>
        public double Target(in Obstacle other)
        {
            double back = -other.Restitution * Velocity;
            back = other.Restitution > 1 ? Math.Max(Math.Min(back, other.MostDriven), -Velocity) : back;
            return Velocity < -other.Slowest ? back : Math.Min(0, -Velocity);
        }
    }
}

/// <summary>
/// The impact of a body with one of several things that it meets at the same moment. Each point has the speed at which it is to part from
/// what it was before all of them; the impulses are found in turns, x ≥ 0 with v' ≥ -e·v and x·(v' + e·v) = 0, and of these energies none
/// is gained: Σ x·(v + v')/2 = (1 - e)·Σ x·v/2 ≤ 0, e being 1 where surfaces part.
/// </summary>
internal struct ImpactInTurns
{
    /// <summary>Share of the speeds below which a change is none.</summary>
    private const double LeastChange = 1e-12;

    private readonly Manifold _own;
    private readonly double _target0;
    private readonly double _target1;
    private double _x0;
    private double _x1;

    public ImpactInTurns(in Mover mover, in Obstacle other, in Manifold own)
    {
        this = default;
        _own = own;
        _target0 = new Impact.Row(mover, other, own.Point0.Anchor, own.Normal).Target(other);
        _target1 = own.Count > 1 ? new Impact.Row(mover, other, own.Point1.Anchor, own.Normal).Target(other) : 0;
    }

    /// <summary>One turn.</summary>
    /// <returns>True if it changed the velocities.</returns>
    public bool Solve(ref Mover mover, in Obstacle other)
    {
        var first = new Impact.Row(mover, other, _own.Point0.Anchor, _own.Normal);
        double old0 = _x0;
        double old1 = _x1;
        double b0 = first.Velocity - _target0 - (first.K * _x0);
        Impact.Row second = default;
        if (_own.Count < 2)
        {
            _x0 = Impact.Stop(first.K, b0);
        }
        else
        {
            second = new Impact.Row(mover, other, _own.Point1.Anchor, _own.Normal);
            double coupling = Impact.Coupling(mover, other, first, second);
            double b1 = second.Velocity - _target1 - (second.K * _x1) - (coupling * _x0);
            Impact.Solve(first.K, second.K, coupling, b0 - (coupling * _x1), b1, out _x0, out _x1);
        }

        double sum = _x0 - old0 + (_x1 - old1);
        mover.VelocityX += mover.InverseMass * sum * _own.Normal.X;
        mover.VelocityY += mover.InverseMass * sum * _own.Normal.Y;
        double spin = mover.InverseInertia * ((first.Arm * (_x0 - old0)) + (second.Arm * (_x1 - old1)));
        mover.Spin += spin;
        return (mover.InverseMass * Math.Abs(sum)) + (Math.Abs(spin) * mover.Reach) > LeastChange * mover.Speed;
    }

    /// <summary>What it pushed with.</summary>
    public readonly double Given => _x0 + _x1;

    /// <summary>Friction, within the cones of what was found.</summary>
    public readonly void Rub(ref Mover mover, ref Obstacle other, in Manifold own)
    {
        Impact.Rub(ref mover, ref other, own.Point0.Anchor, own.Normal, _x0);
        if (own.Count > 1)
        {
            Impact.Rub(ref mover, ref other, own.Point1.Anchor, own.Normal, _x1);
        }
    }
}
