using System;

namespace Farseer.Accuracy;

/// <summary>A point or direction in double precision: metrics must not add rounding of their own.</summary>
internal readonly record struct Vec(double X, double Y)
{
    public double Length => Math.Sqrt((X * X) + (Y * Y));

    public static Vec operator +(Vec a, Vec b) => new(a.X + b.X, a.Y + b.Y);

    public static Vec operator -(Vec a, Vec b) => new(a.X - b.X, a.Y - b.Y);

    public static Vec operator *(double s, Vec a) => new(s * a.X, s * a.Y);

    public static double Dot(Vec a, Vec b) => (a.X * b.X) + (a.Y * b.Y);

    public static double Cross(Vec a, Vec b) => (a.X * b.Y) - (a.Y * b.X);

    public Vec Turned(double angle)
    {
        (double sin, double cos) = Math.SinCos(angle);
        return new((cos * X) - (sin * Y), (sin * X) + (cos * Y));
    }
}
