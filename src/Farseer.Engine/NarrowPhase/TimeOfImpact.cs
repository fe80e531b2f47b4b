using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>What a search for a time of impact looks for, all relative to the sizes of the pair.</summary>
internal struct ImpactQuery
{
    /// <summary>The separation sought; negative: the pieces must overlap by as much.</summary>
    public double Target;

    /// <summary>How near to it the search ends, above 0.</summary>
    public double Tolerance;

    /// <summary>Shares of the way between which to look.</summary>
    public double From;
    public double Until;
}

/// <summary>
/// When two convex pieces first touch, each on its own curved and turning way. Conservative advancement: the greatest separation
/// over the axes of both pieces is a lower bound of their distance, and along one such axis, held fast, the pieces can be moved on
/// safely until a lower bound of the separation along it is used up. That bound follows each vertex with its present velocity less
/// what its arc may bend, so the steps are of second order and a search mostly ends after three to ten of them.
/// </summary>
/// <remarks>
/// Nearly all pairs are asked twice: how far apart they are where the ways begin, or whether they meet deeply enough, and then when. Where
/// the ways begin is looked at once.
/// </remarks>
internal unsafe ref struct TimeOfImpact
{
    /// <summary>Steps after which a search that still creeps counts as an impact: to stop too early is safe, to pass is not.</summary>
    private const int MaxSteps = 100;

    private const int Refinements = 4;

    private MovingHull _a;
    private MovingHull _b;
    private AxisAtStart _start;
    private readonly bool _links;
    private SolidLink _solidA;
    private SolidLink _solidB;

    /// <param name="shapes">The pieces.</param>
    /// <param name="pieceA">One of them.</param>
    /// <param name="a">The way of its body.</param>
    /// <param name="pieceB">The other.</param>
    /// <param name="b">The way of its body.</param>
    public TimeOfImpact(ShapeStore shapes, int pieceA, in BodyPath a, int pieceB, in BodyPath b)
    {
        _a.Begin(shapes, pieceA, a);
        _b.Begin(shapes, pieceB, b);
        ref Piece first = ref shapes.Pieces[pieceA];
        ref Piece second = ref shapes.Pieces[pieceB];
        _links = (first.Flags & second.Flags & PieceFlags.OneSided) != 0;
        if (_links)
        {
            _solidA.Set(shapes, first);
            _solidB.Set(shapes, second);
            _a.Thicken(first.Extent);
            _b.Thicken(second.Extent);
        }
    }

    /// <summary>The separation where the ways begin.</summary>
    public double SeparationAtStart()
    {
        if (!_start.IsKnown)
        {
            PointToSolids();
            MovingHull.MoveTo(0, ref _a, ref _b);
            _start.Separation = Separation(_a, _b, out _start.X, out _start.Y);
            _start.RotorA = _a.Rotor;
            _start.RotorB = _b.Rotor;
            _start.IsKnown = true;
        }

        return _start.Separation;
    }

    /// <summary>True if the separation falls to the target; <paramref name="time"/> is then the share of the way.</summary>
    public bool Find(in ImpactQuery query, out double time, out double separation)
    {
        time = query.From;
        separation = 0;
        PointToSolids();
        for (int step = 0; step < MaxSteps; step++)
        {
            double nx;
            double ny;
            if (time == 0)
            {
                separation = SeparationAtStart();
                nx = _start.X;
                ny = _start.Y;

                // An earlier search may have left them elsewhere.
                _a.Place(0, _start.RotorA);
                _b.Place(0, _start.RotorB);
            }
            else
            {
                MovingHull.MoveTo(time, ref _a, ref _b);
                separation = Separation(_a, _b, out nx, out ny);
            }

            if (separation <= query.Target + query.Tolerance)
            {
                return true;
            }

            double safe = SafeTime(_a, _b, nx, ny, time, query);
            if (!(time + safe < query.Until))
            {
                return false;
            }

            time += safe;
        }

        return true;
    }

    /// <summary>The corners are a part of this struct, which may have been moved since.</summary>
    private void PointToSolids()
    {
        if (_links)
        {
            _a.Become((SolidLink*)Unsafe.AsPointer(ref _solidA));
            _b.Become((SolidLink*)Unsafe.AsPointer(ref _solidB));
        }
    }

    /// <summary>
    /// Greatest separation over the edge normals of both, and over the line between two vertices where these are nearest.
    /// </summary>
    private static double Separation(in MovingHull a, in MovingHull b, out double nx, out double ny)
    {
        var best = new Axis { Separation = double.NegativeInfinity };
        Offer(a, b, 1, ref best);
        Offer(b, a, -1, ref best);
        if (best.Separation == double.NegativeInfinity)
        {
            // Two circles.
            a.ToWorld(a.Vertices[0], out double ax, out double ay);
            b.ToWorld(b.Vertices[0], out double bx, out double by);
            best.Separation = 0;
            best.X = 0;
            best.Y = 1;
            Refine(a, b, (b.X - a.X) + (bx - ax), (b.Y - a.Y) + (by - ay), ref best);
        }
        else if (best.Separation > 0)
        {
            AddCorner(a, b, ref best);
        }

        nx = best.X;
        ny = best.Y;
        return best.Separation - a.Radius - b.Radius;
    }

    /// <summary>Offers the edge normals of one piece; <paramref name="sign"/> is 1 if it is the pair's A, else -1.</summary>
    private static void Offer(in MovingHull own, in MovingHull other, int sign, ref Axis best)
    {
        double dx = other.X - own.X;
        double dy = other.Y - own.Y;
        for (int i = 0; i < own.Count && own.Count > 1; i++)
        {
            own.ToWorld(own.Normals[i], out double x, out double y);
            double base0 = ((double)own.Normals[i].X * own.Vertices[i].X) + ((double)own.Normals[i].Y * own.Vertices[i].Y);
            Offer(own, other, sign, i, x, y, (x * dx) + (y * dy) - base0, ref best);
            if (own.Count == 2)
            {
                // A segment ends as well: along it, from each of its ends.
                Offer(own, other, sign, i, y, -x, (y * dx) - (x * dy) + own.Lowest(-y, x), ref best);
            }
        }
    }

    private static void Offer(in MovingHull own, in MovingHull other, int sign, int edge, double x, double y, double start, ref Axis best)
    {
        double s = start + other.Lowest(x, y);
        if (s > best.Separation)
        {
            best.Separation = s;
            best.X = sign * x;
            best.Y = sign * y;
            best.Sign = sign;
            best.Edge = edge;
        }
    }

    /// <summary>Where the support vertex lies beyond the edge's ends, the nearest points are two vertices.</summary>
    private static void AddCorner(in MovingHull a, in MovingHull b, ref Axis best)
    {
        ref readonly MovingHull own = ref best.Sign > 0 ? ref a : ref b;
        ref readonly MovingHull other = ref best.Sign > 0 ? ref b : ref a;
        int next = best.Edge + 1 == own.Count ? 0 : best.Edge + 1;
        own.ToWorld(own.Vertices[best.Edge], out double sx, out double sy);
        own.ToWorld(own.Vertices[next], out double ex, out double ey);
        other.ToWorld(other.Vertices[other.LowestAt(best.Sign * best.X, best.Sign * best.Y)], out double wx, out double wy);
        wx += other.X - own.X;
        wy += other.Y - own.Y;
        double tx = ex - sx;
        double ty = ey - sy;
        double along = ((wx - sx) * tx) + ((wy - sy) * ty);
        if (along < 0)
        {
            Refine(a, b, best.Sign * (wx - sx), best.Sign * (wy - sy), ref best);
        }
        else if (along > (tx * tx) + (ty * ty))
        {
            Refine(a, b, best.Sign * (wx - ex), best.Sign * (wy - ey), ref best);
        }
    }

    /// <summary>Takes the direction if the pieces are farther apart along it.</summary>
    private static void Refine(in MovingHull a, in MovingHull b, double x, double y, ref Axis best)
    {
        double length = Math.Sqrt((x * x) + (y * y));
        if (!(length > 0))
        {
            return;
        }

        x /= length;
        y /= length;
        double s = Along(a, b, x, y);
        if (s > best.Separation)
        {
            best.Separation = s;
            best.X = x;
            best.Y = y;
        }
    }

    /// <summary>Separation of the cores along a direction.</summary>
    private static double Along(in MovingHull a, in MovingHull b, double x, double y) =>
        ((b.X - a.X) * x) + ((b.Y - a.Y) * y) + b.Lowest(x, y) + a.Lowest(-x, -y);

    /// <summary>
    /// How long the separation along n is sure to stay above the target. Its lower bound is a concave function of the time: a chord
    /// of it lies below it, so chords and halvings from the left never go too far.
    /// </summary>
    private static double SafeTime(in MovingHull a, in MovingHull b, double nx, double ny, double from, in ImpactQuery query)
    {
        ref readonly BodyPath pathA = ref a.Path;
        ref readonly BodyPath pathB = ref b.Path;
        double speed =
            ((pathB.VelocityXAt(from) - pathA.VelocityXAt(from)) * nx) + ((pathB.VelocityYAt(from) - pathA.VelocityYAt(from)) * ny);
        double gain = ((pathB.AccelerationX - pathA.AccelerationX) * nx) + ((pathB.AccelerationY - pathA.AccelerationY) * ny);
        double bend = a.Bend(from) + b.Bend(from) - Math.Min(gain, 0);
        var bound = new SeparationBound(a, b, nx, ny, speed, bend);

        // Chords aim at the middle of the tolerance: a straight way's chord would end on the target itself, above or below by rounding.
        double aim = 0.5 * query.Tolerance;
        double need = query.Target + a.Radius + b.Radius;
        double low = 0;
        double high = query.Until - from;
        bound.At(low, high, out double atLow, out double atHigh);
        atLow -= need;
        atHigh -= need;
        if (atHigh >= 0)
        {
            return double.PositiveInfinity;
        }

        for (int i = 0; i < Refinements && atLow > aim; i++)
        {
            // The middle of what is left beyond the chord, which but for rounding never goes too far, is asked for with it.
            double chord = low + ((high - low) * ((atLow - aim) / (atLow - atHigh)));
            double middle = 0.5 * (chord + high);
            bound.At(chord, middle, out double atChord, out double atMiddle);
            atChord -= need;
            if (atChord > 0)
            {
                low = chord;
                atLow = atChord;
            }
            else
            {
                middle = 0.5 * (low + high);
                bound.At(middle, middle, out atMiddle, out _);
            }

            atMiddle -= need;
            if (atMiddle > 0)
            {
                low = middle;
                atLow = atMiddle;
            }
            else
            {
                high = middle;
                atHigh = atMiddle;
            }
        }

        return low;
    }

    private struct Axis
    {
        public double Separation;
        public double X;
        public double Y;
        public int Sign;
        public int Edge;
    }

    /// <summary>What was found where the ways begin.</summary>
    private struct AxisAtStart
    {
        public bool IsKnown;
        public double Separation;
        public double X;
        public double Y;
        public HullRotor RotorA;
        public HullRotor RotorB;
    }
}
