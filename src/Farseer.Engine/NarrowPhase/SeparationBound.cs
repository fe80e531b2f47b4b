using System;
using System.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.NarrowPhase;

/// <summary>
/// A lower bound of how far apart two pieces on their ways are along a direction n that is held fast: every vertex goes on as fast as now,
/// and the ways bend by no more than they can. Asked for at two times at once, of both pieces side by side, for most of a search for a time
/// of impact asks for it.
/// </summary>
/// <remarks>d·(ω×r) = ω·(r×d), so in the time t each vertex r adds to d·r the part of it along ω·t·d turned by a right angle.</remarks>
internal readonly unsafe ref struct SeparationBound
{
    private readonly Vector2* _verticesA;
    private readonly Vector2* _verticesB;
    private readonly int _lastA;
    private readonly int _lastB;
    private readonly double _offset;
    private readonly double _speed;
    private readonly double _bend;

#if NET8_0_OR_GREATER
    // Of B at the first time and at the second, then of A.
    private readonly Vector256<double> _x;
    private readonly Vector256<double> _y;
    private readonly Vector256<double> _spin;
    private readonly Vector256<double> _cos;
    private readonly Vector256<double> _sin;
#else
    private readonly double _x;
    private readonly double _y;
    private readonly double _spinA;
    private readonly double _spinB;
    private readonly HullRotor _rotorA;
    private readonly HullRotor _rotorB;
#endif

    /// <param name="a">One piece, where it is now.</param>
    /// <param name="b">The other, which lies in the direction of n.</param>
    /// <param name="nx">The direction.</param>
    /// <param name="ny">Likewise.</param>
    /// <param name="speed">How fast B's centre goes away from A's along n.</param>
    /// <param name="bend">How fast that can become less.</param>
    public SeparationBound(in MovingHull a, in MovingHull b, double nx, double ny, double speed, double bend)
    {
        _verticesA = a.Vertices;
        _verticesB = b.Vertices;
        _lastA = a.Count - 1;
        _lastB = b.Count - 1;
        _offset = ((b.X - a.X) * nx) + ((b.Y - a.Y) * ny);
        _speed = speed;
        _bend = bend;
#if NET8_0_OR_GREATER
        _x = BThenA(nx, -nx);
        _y = BThenA(ny, -ny);
        _spin = BThenA(b.Spin, a.Spin);
        _cos = BThenA(b.Rotor.Cos, a.Rotor.Cos);
        _sin = BThenA(b.Rotor.Sin, a.Rotor.Sin);
#else
        _x = nx;
        _y = ny;
        _spinA = a.Spin;
        _spinB = b.Spin;
        _rotorA = a.Rotor;
        _rotorB = b.Rotor;
#endif
    }

    /// <summary>The bound for the cores of the pieces, from now on after two shares of the way.</summary>
    public void At(double first, double second, out double atFirst, out double atSecond)
    {
#if NET8_0_OR_GREATER
        Vector128<double> time = Vector128.Create(first, second);
        Vector128<double> lowestB;
        Vector128<double> lowestA;
        if (Avx.IsSupported)
        {
            LowestOfBoth(time, out lowestB, out lowestA);
        }
        else
        {
            lowestB = Lowest(_verticesB, _lastB, _x.GetLower(), _y.GetLower(), _cos.GetLower(), _sin.GetLower(), _spin.GetLower() * time);
            lowestA = Lowest(_verticesA, _lastA, _x.GetUpper(), _y.GetUpper(), _cos.GetUpper(), _sin.GetUpper(), _spin.GetUpper() * time);
        }

        Vector128<double> along = Vector128.Create(_offset) + lowestB + lowestA;
        along += time * (Vector128.Create(_speed) - (Vector128.Create(0.5) * time * Vector128.Create(_bend)));
        atFirst = along.ToScalar();
        atSecond = along.GetElement(1);
#else
        atFirst = At(first);
        atSecond = At(second);
#endif
    }

#if NET8_0_OR_GREATER
    /// <summary>The lowest vertex of each piece at two times.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void LowestOfBoth(Vector128<double> time, out Vector128<double> lowestB, out Vector128<double> lowestA)
    {
        Vector256<double> turn = _spin * Vector256.Create(time, time);
        Vector256<double> dx = _x + (turn * _y);
        Vector256<double> dy = _y - (turn * _x);
        Vector256<double> x = (_cos * dx) + (_sin * dy);
        Vector256<double> y = (_cos * dy) - (_sin * dx);
        Vector256<double> lowest = Heights(0, x, y);
        for (int i = 1; i <= Math.Max(_lastA, _lastB); i++)
        {
            Vector256<double> heights = Heights(i, x, y);
            lowest = Vector256.ConditionalSelect(Vector256.LessThan(heights, lowest), heights, lowest);
        }

        lowestB = lowest.GetLower();
        lowestA = lowest.GetUpper();
    }

    /// <summary>The same of one piece, with vectors that hold no more.</summary>
    private static Vector128<double> Lowest(
        Vector2* vertices,
        int last,
        Vector128<double> nx,
        Vector128<double> ny,
        Vector128<double> cos,
        Vector128<double> sin,
        Vector128<double> turn)
    {
        Vector128<double> dx = nx + (turn * ny);
        Vector128<double> dy = ny - (turn * nx);
        Vector128<double> x = (cos * dx) + (sin * dy);
        Vector128<double> y = (cos * dy) - (sin * dx);
        Vector128<double> lowest = Vector128.Create(double.PositiveInfinity);
        for (int i = 0; i <= last; i++)
        {
            Vector128<double> heights = (x * Vector128.Create((double)vertices[i].X)) + (y * Vector128.Create((double)vertices[i].Y));
            lowest = Vector128.ConditionalSelect(Vector128.LessThan(heights, lowest), heights, lowest);
        }

        return lowest;
    }

    /// <summary>Of a vertex of each; a piece that has no more repeats its last one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector256<double> Heights(int vertex, Vector256<double> x, Vector256<double> y)
    {
        double* b = (double*)(_verticesB + Math.Min(vertex, _lastB));
        double* a = (double*)(_verticesA + Math.Min(vertex, _lastA));
        Vector256<double> both = Avx.ConvertToVector256Double(Vector128.Create(*b, *a).AsSingle());
        return (x * Vector256.Shuffle(both, Vector256.Create(0, 0, 2, 2))) + (y * Vector256.Shuffle(both, Vector256.Create(1, 1, 3, 3)));
    }

    private static Vector256<double> BThenA(double b, double a) => Vector256.Create(b, b, a, a);
#else
    private double At(double time)
    {
        double along = _offset + Lowest(_verticesB, _lastB, _rotorB, _x, _y, _spinB * time)
            + Lowest(_verticesA, _lastA, _rotorA, -_x, -_y, _spinA * time);
        return along + (time * (_speed - (0.5 * time * _bend)));
    }

    private static double Lowest(Vector2* vertices, int last, HullRotor rotor, double x, double y, double turn)
    {
        double dx = x + (turn * y);
        double dy = y - (turn * x);
        return HullHeights.Lowest(vertices, last + 1, rotor.ToLocalX(dx, dy), rotor.ToLocalY(dx, dy));
    }
#endif
}
