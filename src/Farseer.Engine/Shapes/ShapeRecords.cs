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
/// A convex piece attached to a body, in body coordinates. The index of a piece is also its proxy in the broad phase.
/// Vertices, edge normals and outline normals lie in the pools of <c>ShapeStore</c> from <see cref="VertexStart"/> on.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal struct Piece
{
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

    /// <summary>Centre of the local bounds, in body coordinates.</summary>
    public Vector2 Center;

    /// <summary>
    /// A box's half sides along <see cref="Axis"/> and across it; for other kinds the rounding radius, and the radius of a circle about
    /// <see cref="Center"/> that holds the piece.
    /// </summary>
    public Vector2 Half;

    /// <summary>A box's own x axis, the normal of its edge 1, in body coordinates.</summary>
    public Vector2 Axis;
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

    /// <summary>Order of creation; the lower one of a pair is its A.</summary>
    public int Order;

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
