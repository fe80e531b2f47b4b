using System.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>Kinds of convex pieces. Every piece is the hull of its vertices, rounded by its radius.</summary>
internal enum ShapeKind : byte
{
    Circle,
    Capsule,
    Segment,
    Polygon,

    /// <summary>A polygon of four corners at right angles.</summary>
    Box,
}

/// <summary>
/// One convex piece in collider coordinates. Vertices are in positive order (x axis towards y axis); edge i runs from vertex i
/// to vertex i+1. A piece that is part of a larger outline (concave polygon, chain) marks its inner edges in
/// <see cref="SeamEdges"/> and carries, per vertex, the outward normals of the two outline edges that meet there; a contact
/// normal at that vertex must lie between them, which is what makes seams unfelt.
/// </summary>
internal sealed class PieceGeometry
{
    public PieceGeometry(ShapeKind kind, Vector2[] vertices, float radius)
    {
        Kind = kind;
        Vertices = vertices;
        Radius = radius;
    }

    public ShapeKind Kind { get; }

    public Vector2[] Vertices { get; }

    /// <summary>Rounding radius; 0 for a sharp polygon, the radius itself for a circle.</summary>
    public float Radius { get; }

    /// <summary>True per edge that lies inside the outline; null: none.</summary>
    public bool[]? SeamEdges { get; set; }

    /// <summary>Per vertex, outward normals of the outline edge before and after it; null: the piece's own edges.</summary>
    public Vector2[]? OutlineNormalBefore { get; set; }

    public Vector2[]? OutlineNormalAfter { get; set; }

    /// <summary>A segment that collides only on the side of its outward normal (links of a chain).</summary>
    public bool OneSided { get; set; }

    /// <summary>
    /// How far the body behind a one-sided segment reaches, on an average over its outline; infinite where nothing bounds it.
    /// </summary>
    public float Thickness { get; set; } = float.PositiveInfinity;
}

/// <summary>A collider's shape: one convex piece or several. Immutable; colliders of many bodies may share it.</summary>
internal sealed class ShapeGeometry
{
    public ShapeGeometry(PieceGeometry[] pieces) => Pieces = pieces;

    public PieceGeometry[] Pieces { get; }
}
