using System;
using System.Numerics;
using Farseer.Engine.Numerics;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Area of a geom and its second moment about the place of its body, which mass and moment of inertia are in proportion to.
/// </summary>
internal readonly struct GeomArea
{
    private GeomArea(double area, double inertia)
    {
        Area = area;
        Inertia = inertia;
    }

    public double Area { get; }

    public double Inertia { get; }

    public static GeomArea Of(Geom geom)
    {
        GeomForm form = geom.Form!;
        switch (form.Kind)
        {
            case FormKind.Segment:
            case FormKind.Chain:
                return default;
            case FormKind.Circle:
                double disc = Math.PI * form.Radius * form.Radius;
                return About(disc, disc * form.Radius * form.Radius / 2, Vector2.Zero, geom);
            case FormKind.Box:
                double box = (double)form.Size.X * form.Size.Y;
                return About(
                    box, box * (((double)form.Size.X * form.Size.X) + ((double)form.Size.Y * form.Size.Y)) / 12, Vector2.Zero, geom);
            case FormKind.Capsule:
                double length = Vector2.Distance(form.Points[0], form.Points[1]);
                return About(
                    CapsuleArea(length, form.Radius), CapsuleInertia(length, form.Radius), (form.Points[0] + form.Points[1]) / 2, geom);
            case FormKind.Rounded:
                Vector2 size = form.Points[2] - form.Points[0];
                return About(
                    RoundedArea(size, form.Radius), RoundedInertia(size, form.Radius), (form.Points[0] + form.Points[2]) / 2, geom);
            default:
                Vertices outline = geom.LocalVertices;
                double area = Math.Abs(outline.GetArea());
                return About(area, area * outline.GetMomentOfInertia(), outline.GetCentroid(), geom);
        }
    }

    /// <summary>A rectangle 2r wide and as long as the axis, and a disc in two halves at its ends.</summary>
    public static double CapsuleArea(double length, double radius) => (2 * radius * length) + (Math.PI * radius * radius);

    /// <summary>About the middle. The centroid of a half disc is 4r/(3π) from its straight side, which is half the length away.</summary>
    public static double CapsuleInertia(double length, double radius)
    {
        double r = radius;
        double rectangle = 2 * r * length * ((length * length) + (4 * r * r)) / 12;
        double disc = Math.PI * r * r;
        double discs = disc * ((r * r / 2) + (length * length / 4) + (4 * r * length / (3 * Math.PI)));
        return rectangle + discs;
    }

    /// <summary>The rectangle within, a strip along each side, and a disc in four quarters at the corners.</summary>
    public static double RoundedArea(Vector2 size, double radius) =>
        ((double)size.X * size.Y) + (2 * radius * (size.X + (double)size.Y)) + (Math.PI * radius * radius);

    /// <summary>About the middle. The centroid of a quarter disc is 4r/(3π) from both its straight sides.</summary>
    public static double RoundedInertia(Vector2 size, double radius)
    {
        double w = size.X;
        double h = size.Y;
        double r = radius;
        double inner = w * h * ((w * w) + (h * h)) / 12;
        double above = 2 * w * r * ((((w * w) + (r * r)) / 12) + Square((h + r) / 2));
        double beside = 2 * h * r * ((((h * h) + (r * r)) / 12) + Square((w + r) / 2));
        double disc = Math.PI * r * r;
        double corners = disc * ((r * r / 2) + (((w * w) + (h * h)) / 4) + (4 * r * (w + h) / (3 * Math.PI)));
        return inner + above + beside + corners;
    }

    private static double Square(double x) => x * x;

    private static GeomArea About(double area, double inertia, Vector2 center, Geom geom)
    {
        StableMath.SinCos(geom.RotationOffset, out double sin, out double cos);
        Vector2 offset = geom.EffectiveOffset;
        double x = offset.X + (cos * center.X) - (sin * center.Y);
        double y = offset.Y + (sin * center.X) + (cos * center.Y);
        return new GeomArea(area, inertia + (area * ((x * x) + (y * y))));
    }
}
