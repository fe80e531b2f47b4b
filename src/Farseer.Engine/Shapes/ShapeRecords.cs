using System;
using System.Numerics;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Shapes;

[Flags]
internal enum PieceFlags : byte
{
    None = 0,

    /// <summary>Has seam edges or outline normals that limit the contact normal.</summary>
    Seamed = 1,
    OneSided = 2,
}

/// <summary>
/// Which kernels for lanes can do a piece. The values are bits of the flags of a side, so that no step works them out again.
/// </summary>
[Flags]
internal enum PieceTraits : ushort
{
    None = 0,

    /// <summary>A box that the box kernel can do.</summary>
    Box = 32,

    /// <summary>A circle.</summary>
    Circle = 64,

    /// <summary>A hull without seams, of two to <see cref="Piece.MostLaneCorners"/> corners.</summary>
    Hull = 1024,

    /// <summary>A box whose own axes are not those of its body.</summary>
    Tilted = 2048,
}

/// <summary>
/// A convex piece attached to a body, in body coordinates. The index of a piece is also its proxy in the broad phase.
/// Vertices, edge normals and outline normals lie in the pools of <c>ShapeStore</c> from <see cref="VertexStart"/> on.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal struct Piece
{
    /// <summary>Hulls with more corners are left to the code for one pair.</summary>
    public const int MostLaneCorners = 8;

    public int Body;
    public int Collider;
    public int VertexStart;
    public int VertexCount;
    public float Radius;

    /// <summary>Greatest distance of a point of the piece from the body's centre.</summary>
    public float Reach;

    /// <summary>Half the shorter side of the piece's local bounds: its own length scale.</summary>
    public float Extent;

    public ShapeKind Kind;
    public PieceFlags Flags;
    public PieceTraits Traits;

    /// <summary>Centre of the local bounds, in body coordinates.</summary>
    public Vector2 Center;

    /// <summary>A box's own x axis, the normal of its edge 1, in body coordinates; for other kinds the x axis.</summary>
    public Vector2 Axis;

    /// <summary>
    /// A box's half sides along <see cref="Axis"/> and across it; for other kinds the rounding radius, and the radius of a circle about
    /// <see cref="Center"/> that holds the piece.
    /// </summary>
    public Vector2 Half;
}

[Flags]
internal enum ColliderFlags : uint
{
    None = 0,
    Alive = 1,
    CollisionEnabled = 2,
    ResponseEnabled = 4,

    /// <summary>The facade wants <c>OnContact</c> for this collider.</summary>
    WantsContact = 8,

    /// <summary>The facade wants <c>OnSeparation</c> for this collider.</summary>
    WantsSeparation = 16,

    /// <summary>Its pairs are asked about: see <c>IPairSurfaces</c>.</summary>
    OwnSurface = 32,
}

/// <summary>A collider (the facade's Geom): filter, material and the pieces it is made of.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct ColliderInfo
{
    public int Body;
    public ColliderFlags Flags;
    public float Friction;
    public float Restitution;

    /// <summary>Colliders of the same non-zero group do not collide.</summary>
    public int Group;
    public uint Categories;
    public uint CollidesWith;

    /// <summary>First piece; the others follow in the piece table's collider chain.</summary>
    public int FirstPiece;
    public int PieceCount;

    public int UserIndex;
}

internal struct ColliderDef
{
    public ColliderFlags Flags;
    public float Friction;
    public float Restitution;
    public int Group;
    public uint Categories;
    public uint CollidesWith;
    public Vector2 Offset;
    public float RotationOffset;
    public int UserIndex;
}
