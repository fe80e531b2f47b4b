using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// The contact that a pair will make on its way, as a row knows it: the normal is that of the impact, the arms are those of the
/// impact turned back to the start of the step, and the separations are those that these points then have along the normal.
/// </summary>
internal unsafe struct ForeseenImpact
{
    public Manifold Manifold;
    private ImpactArms _arms0;
    private ImpactArms _arms1;

    /// <param name="impact">Manifold at the impact, from A's centre there.</param>
    /// <param name="a">Way of A.</param>
    /// <param name="b">Way of B.</param>
    /// <param name="time">Share of the way at the impact.</param>
    /// <param name="radiusA">Rounding radius of A, along which a contact does not turn with it.</param>
    /// <param name="radiusB">Rounding radius of B.</param>
    /// <returns>False if no point is a gap at the start, though the pair meets later: a row would then push at once.</returns>
    public bool Set(in Manifold impact, in BodyPath a, in BodyPath b, double time, double radiusA, double radiusB)
    {
        Manifold = default;
        Manifold.Normal = impact.Normal;
        for (int k = 0; k < impact.Count; k++)
        {
            ManifoldPoint point = k == 0 ? impact.Point0 : impact.Point1;
            ImpactArms arms = Arms(point, impact.Normal, a, b, time, radiusA, radiusB, out double gap);
            if (gap < 0 && time > 0)
            {
                continue;
            }

            // Where it will be, from where A is now.
            point.Anchor += new Vector2((float)(a.XAt(time) - a.X), (float)(a.YAt(time) - a.Y));
            point.Separation = (float)gap;
            if (Manifold.Count == 0)
            {
                Manifold.Point0 = point;
                _arms0 = arms;
            }
            else
            {
                Manifold.Point1 = point;
                _arms1 = arms;
            }

            Manifold.Count++;
        }

        return Manifold.Count > 0;
    }

    public readonly void WriteArms(PairLanes* pairs, int lane)
    {
        Write(&pairs->Point0, lane, _arms0);
        Write(&pairs->Point1, lane, _arms1);
    }

    private static void Write(PointLanes* point, int lane, in ImpactArms arms)
    {
        point->NormalArmA[lane] = arms.NormalA;
        point->TangentArmA[lane] = arms.TangentA;
        point->NormalArmB[lane] = arms.NormalB;
        point->TangentArmB[lane] = arms.TangentB;
    }

    private static ImpactArms Arms(
        in ManifoldPoint point, Vector2 n, in BodyPath a, in BodyPath b, double time, double radiusA, double radiusB, out double gap)
    {
        double half = 0.5 * point.Separation;
        double ax = point.Anchor.X;
        double ay = point.Anchor.Y;
        double bx = ax - (b.XAt(time) - a.XAt(time));
        double by = ay - (b.YAt(time) - a.YAt(time));
        double normalA = (ax * n.X) + (ay * n.Y) - half - radiusA;
        double normalB = (bx * n.X) + (by * n.Y) + half + radiusB;
        double tangentA = (ax * n.Y) - (ay * n.X);
        double tangentB = (bx * n.Y) - (by * n.X);
        TurnBack(a.AngleAt(time) - a.Angle, ref normalA, ref tangentA);
        TurnBack(b.AngleAt(time) - b.Angle, ref normalB, ref tangentB);
        gap = ((b.X - a.X) * n.X) + ((b.Y - a.Y) * n.Y) + normalB - normalA - radiusA - radiusB;

        // The row takes half a gap and the radii off the arms again: see ContactRowWriter.
        return new ImpactArms
        {
            NormalA = (float)(normalA + (0.5 * gap) + radiusA),
            TangentA = (float)tangentA,
            NormalB = (float)(normalB - (0.5 * gap) - radiusB),
            TangentB = (float)tangentB,
        };
    }

    // The arm of the turned body is (c·N + s·T, c·T - s·N).
    private static void TurnBack(double angle, ref double normal, ref double tangent)
    {
        StableMath.SinCos(angle, out double sin, out double cos);
        double n = (cos * normal) - (sin * tangent);
        tangent = (cos * tangent) + (sin * normal);
        normal = n;
    }

    private struct ImpactArms
    {
        public float NormalA;
        public float TangentA;
        public float NormalB;
        public float TangentB;
    }
}
