using System.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>What a geom collides as; its vertices are for drawing and for the queries of the original.</summary>
internal enum FormKind
{
    /// <summary>Any simple polygon.</summary>
    Outline,

    /// <summary>A true circle of <see cref="GeomForm.Radius"/>.</summary>
    Circle,

    /// <summary>A rectangle about the origin of <see cref="GeomForm.Size"/>.</summary>
    Box,

    /// <summary>All points within <see cref="GeomForm.Radius"/> of a segment.</summary>
    Capsule,

    /// <summary>All points within <see cref="GeomForm.Radius"/> of a convex polygon.</summary>
    Rounded,

    /// <summary>A line without thickness that collides on both sides.</summary>
    Segment,

    /// <summary>Lines that collide on one side, without seams.</summary>
    Chain,
}

/// <summary>The shape of a geom before it is an engine shape. Geoms that copy one another share it; it never changes.</summary>
[NotState(Why.Fixed)]
internal sealed class GeomForm
{
    private ShapeGeometry? _shape;

    public GeomForm(FormKind kind, Vector2[] points, float radius, Vector2 size, bool loop, int edges = 0)
    {
        Kind = kind;
        Points = points;
        Radius = radius;
        Size = size;
        IsLoop = loop;
        Edges = edges;
    }

    public FormKind Kind { get; }

    /// <summary>Outline, segment or chain; the ends of a capsule's segment; the corners that are rounded; empty otherwise.</summary>
    public Vector2[] Points { get; }

    public float Radius { get; }

    /// <summary>Width and height of a box.</summary>
    public Vector2 Size { get; }

    public bool IsLoop { get; }

    /// <summary>Corners of the outline by which a circle is drawn; 0 of others.</summary>
    public int Edges { get; }

    /// <summary>
    /// That of an outline is built once and shared by copies: cutting a concave one costs time. The others are as quick to build as to
    /// keep, and would be a fifth of what a geom keeps.
    /// </summary>
    public ShapeGeometry Shape => Kind == FormKind.Outline ? _shape ??= Build() : Build();

    /// <summary>Whether the two say the same; outlines are not compared.</summary>
    public bool IsSameAs(GeomForm other) =>
        Kind == other.Kind && (Kind is FormKind.Box or FormKind.Circle) && Radius == other.Radius && Size == other.Size
        && Edges == other.Edges;

    public static GeomForm Circle(float radius, int edges) =>
        new GeomForm(FormKind.Circle, System.Array.Empty<Vector2>(), radius, default, false, edges);

    public static GeomForm Box(float width, float height) =>
        new GeomForm(FormKind.Box, System.Array.Empty<Vector2>(), 0, new Vector2(width, height), false);

    public static GeomForm Outline(Vertices vertices) => new GeomForm(FormKind.Outline, vertices.ToArray(), 0, default, true);

    /// <summary>The outline of a box or a circle, which follows from what it is; null of others.</summary>
    public Vertices? OwnOutline() => Kind switch
    {
        FormKind.Box => Vertices.CreateRectangle(Size.X, Size.Y),
        FormKind.Circle => Vertices.CreateCircle(Radius, Edges),
        _ => null,
    };

    private ShapeGeometry Build() => Kind switch
    {
        FormKind.Circle => ShapeBuilder.Circle(Radius),
        FormKind.Box => ShapeBuilder.Box(Size.X, Size.Y),
        FormKind.Capsule => ShapeBuilder.Capsule(Points[0], Points[1], Radius),
        FormKind.Rounded => ShapeBuilder.Polygon(Points, Radius),
        FormKind.Segment => ShapeBuilder.Segment(Points[0], Points[1]),
        FormKind.Chain => ShapeBuilder.Chain(Points, IsLoop),
        _ => ShapeBuilder.Polygon(Points),
    };
}
