using System;

namespace Farseer.Accuracy.General;

/// <summary>A convex body that flies freely, in double precision and without an engine.</summary>
internal sealed record Flyer(Vec[] Outline, Vec Position, double Angle, Vec Velocity, double Spin, double Mass, double Inertia)
{
    public double Energy => 0.5 * ((Mass * Vec.Dot(Velocity, Velocity)) + (Inertia * Spin * Spin));

    /// <summary>What an actor of one convex piece is about to do.</summary>
    public static Flyer Of(Actor actor) => new(
        actor.Pieces[0],
        actor.Position,
        actor.Angle,
        actor.Velocity,
        actor.Spin,
        actor.IsStatic ? double.PositiveInfinity : actor.Mass,
        actor.IsStatic ? double.PositiveInfinity : actor.Inertia);

    public Flyer After(double time) => this with { Position = Position + (time * Velocity), Angle = Angle + (time * Spin) };

    public Vec[] Placed() => Outlines.Placed(Outline, Position, Angle);

    /// <summary>After an impulse at a point.</summary>
    public Flyer Struck(Vec impulse, Vec point) => this with
    {
        Velocity = Velocity + ((1 / Mass) * impulse),
        Spin = Spin + (Vec.Cross(point - Position, impulse) / Inertia),
    };

    public Vec VelocityAt(Vec point)
    {
        Vec arm = point - Position;
        return Velocity + new Vec(-Spin * arm.Y, Spin * arm.X);
    }
}

/// <summary>Where two convex bodies first touch.</summary>
/// <param name="Time">From the start.</param>
/// <param name="A">The first body at that time.</param>
/// <param name="B">The second.</param>
/// <param name="Point">The corner that touches.</param>
/// <param name="Normal">Of the side that is touched, from A to B.</param>
/// <param name="IsOnePoint">False: two sides lie along each other, or two corners meet, within a tolerance.</param>
internal sealed record Touch(double Time, Flyer A, Flyer B, Vec Point, Vec Normal, bool IsOnePoint);

/// <summary>Finds the first touch of two convex polygons in free flight, and what Newton's rule makes of it.</summary>
internal static class FirstTouch
{
    /// <summary>Sides that lie along each other up to this, rad, are no touch at one point; nor are corners this near, m.</summary>
    private const double Ambiguous = 1e-4;

    private const double Closed = 1e-11;
    private const int MostSteps = 100_000;

    /// <summary>The first touch before a time, or null.</summary>
    public static Touch? Find(Flyer a, Flyer b, double until)
    {
        double nearing = Nearing(a) + Nearing(b);
        double time = 0;
        for (int i = 0; i < MostSteps && time < until; i++)
        {
            Flyer nowA = a.After(time);
            Flyer nowB = b.After(time);
            Axis axis = Separation(nowA.Placed(), nowB.Placed(), out bool isOnePoint);
            if (axis.Gap <= Closed)
            {
                return new Touch(time, nowA, nowB, axis.Point, axis.Normal, isOnePoint);
            }

            // No point moves faster than this, so nothing can have closed before.
            time += axis.Gap / nearing;
        }

        return null;
    }

    /// <summary>Whether bodies that have just touched keep apart until a time after it.</summary>
    public static bool StayApart(Flyer a, Flyer b, double time)
    {
        const int Looks = 64;
        for (int i = 1; i <= Looks; i++)
        {
            double at = time * i / Looks;
            if (Separation(a.After(at).Placed(), b.After(at).Placed(), out _).Gap <= 0)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Both bodies after one frictionless impact at one point: they part with e times the speed of approach.</summary>
    public static (Flyer A, Flyer B) Newton(Touch touch, double restitution)
    {
        Vec n = touch.Normal;
        double approach = Vec.Dot(touch.A.VelocityAt(touch.Point) - touch.B.VelocityAt(touch.Point), n);
        double armA = Vec.Cross(touch.Point - touch.A.Position, n);
        double armB = Vec.Cross(touch.Point - touch.B.Position, n);
        double give = (1 / touch.A.Mass) + (1 / touch.B.Mass) + (armA * armA / touch.A.Inertia) + (armB * armB / touch.B.Inertia);
        double impulse = (1 + restitution) * approach / give;
        return (touch.A.Struck(-impulse * n, touch.Point), touch.B.Struck(impulse * n, touch.Point));
    }

    private static double Nearing(Flyer body)
    {
        double farthest = 0;
        foreach (Vec corner in body.Outline)
        {
            farthest = Math.Max(farthest, corner.Length);
        }

        return body.Velocity.Length + (Math.Abs(body.Spin) * farthest);
    }

    private static Axis Separation(Vec[] a, Vec[] b, out bool isOnePoint)
    {
        Axis best = new(double.MinValue, default, default, 0);
        double next = double.MinValue;
        for (int side = 0; side < a.Length + b.Length; side++)
        {
            Axis axis = side < a.Length ? Along(a, side, b, 1) : Along(b, side - a.Length, a, -1);
            if (axis.Gap > best.Gap)
            {
                next = best.Gap;
                best = axis;
            }
            else
            {
                next = Math.Max(next, axis.Gap);
            }
        }

        // Where corners meet, two sides are as far away as each other.
        isOnePoint = best.Lean > Ambiguous && next < best.Gap - Ambiguous;
        return best;
    }

    /// <summary>How far the nearest corner of another outline is from a side, and how it leans.</summary>
    private static Axis Along(Vec[] owner, int side, Vec[] other, double sign)
    {
        Vec edge = owner[(side + 1) % owner.Length] - owner[side];
        Vec normal = (1 / edge.Length) * new Vec(edge.Y, -edge.X);
        int nearest = 0;
        double gap = double.MaxValue;
        for (int i = 0; i < other.Length; i++)
        {
            double distance = Vec.Dot(other[i] - owner[side], normal);
            if (distance < gap)
            {
                gap = distance;
                nearest = i;
            }
        }

        double lean = double.MaxValue;
        for (int turn = -1; turn <= 1; turn += 2)
        {
            Vec beside = other[(nearest + turn + other.Length) % other.Length] - other[nearest];
            lean = Math.Min(lean, Math.Asin(Math.Clamp(Vec.Dot(beside, normal) / beside.Length, -1, 1)));
        }

        return new Axis(gap, other[nearest], sign * normal, lean);
    }

    private readonly record struct Axis(double Gap, Vec Point, Vec Normal, double Lean);
}
