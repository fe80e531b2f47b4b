using System.Numerics;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>Two pieces and their bodies' relative pose. All positions are differences from the centre of body A.</summary>
internal unsafe struct PairInput
{
    /// <summary>Pools of <see cref="ShapeStore"/>: vertices, edge normals and outline normals in body coordinates.</summary>
    public Vector2* Vertices;
    public Vector2* Normals;
    public Vector2* OutlineBefore;
    public Vector2* OutlineAfter;

    /// <summary>The pieces, in place: a pair is built for each contact, and two copied pieces would be most of its cost.</summary>
    public Piece* PieceA;
    public Piece* PieceB;
    public Rotation RotationA;
    public Rotation RotationB;

    /// <summary>Centre of body B minus centre of body A, formed in double precision.</summary>
    public Vector2 Offset;

    /// <summary>Points farther apart than this are left out.</summary>
    public float Margin;

    public readonly ref readonly Piece A => ref *PieceA;

    public readonly ref readonly Piece B => ref *PieceB;
}
