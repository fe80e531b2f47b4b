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

/// <summary>What an impact meets: the other body, with the velocity of its surface. One that no impulse moves has no inverse mass.</summary>
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
        var first = new Row(mover, other, manifold.Point0.Anchor, manifold.Normal);
        Row second = manifold.Count > 1 ? new Row(mover, other, manifold.Point1.Anchor, manifold.Normal) : default;
        double least = -LeastApproach * mover.Speed;
        if (first.Velocity >= least && (manifold.Count < 2 || second.Velocity >= least))
        {
            return false;
        }

        double b0 = first.Velocity - first.Target(other);
        double x0;
        double x1 = 0;
        if (manifold.Count < 2)
        {
            x0 = Math.Max(0, -b0 / first.K);
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

    private static double Coupling(in Mover mover, in Obstacle other, in Row a, in Row b) =>
        mover.InverseMass + (mover.InverseInertia * a.Arm * b.Arm) + (other.InverseMass + (other.InverseInertia * a.OtherArm * b.OtherArm));

    // Finds x ≥ 0 with w = K·x + b ≥ 0 and x·w = 0, case by case: both, the first, the second.
    private static void Solve(double k11, double k22, double k12, double b0, double b1, out double x0, out double x1)
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

        x0 = Math.Max(0, -b0 / k11);
        x1 = 0;
        if (b1 + (k12 * x0) >= 0)
        {
            return;
        }

        x1 = Math.Max(0, -b1 / k22);
        x0 = 0;
    }

    private static void Rub(ref Mover mover, ref Obstacle other, Vector2 arm, Vector2 normal, double push)
    {
        // t = (ny, -nx), and r×t = -r·n.
        double turn = -(((double)arm.X * normal.X) + ((double)arm.Y * normal.Y));
        double otherTurn = -(((arm.X - other.X) * normal.X) + ((arm.Y - other.Y) * normal.Y));
        Velocity(mover, other, arm, out double x, out double y);
        double slide = (x * normal.Y) - (y * normal.X);
        double k = mover.InverseMass + (mover.InverseInertia * turn * turn)
            + (other.InverseMass + (other.InverseInertia * otherTurn * otherTurn));
        double bound = other.Friction * push;
        double impulse = Math.Max(-bound, Math.Min(bound, -slide / k));
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

    private readonly struct Row
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

        public double Target(in Obstacle other)
        {
            double back = -other.Restitution * Velocity;
            back = other.Restitution > 1 ? Math.Max(Math.Min(back, other.MostDriven), -Velocity) : back;
            return Velocity < -other.Slowest ? back : 0;
        }
    }
}
