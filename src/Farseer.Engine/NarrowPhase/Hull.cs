using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>A piece as the contact routines see it: pointers into the pools, in body coordinates.</summary>
internal unsafe struct Hull
{
    public Vector2* Vertices;
    public Vector2* Normals;
    public Vector2* Before;
    public Vector2* After;
    public int Count;
    public float Radius;
    public PieceFlags Flags;

    public Hull(in PairInput pair, in Piece piece)
    {
        Vertices = pair.Vertices + piece.VertexStart;
        Normals = pair.Normals + piece.VertexStart;
        Before = pair.OutlineBefore + piece.VertexStart;
        After = pair.OutlineAfter + piece.VertexStart;
        Count = piece.VertexCount;
        Radius = piece.Radius;
        Flags = piece.Flags;
    }

    public readonly bool IsSeamed => Flags != PieceFlags.None;

    /// <summary>A line of a chain: its edge 0 is its face, edge 1 its back.</summary>
    public readonly bool IsLink => (Flags & PieceFlags.OneSided) != 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly int Next(int index) => index + 1 == Count ? 0 : index + 1;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly int Previous(int index) => index == 0 ? Count - 1 : index - 1;

    /// <summary>True if edge i lies on the outline (see <see cref="ShapeStore.OutlineAfter"/>).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool IsReal(int edge) => Flags == PieceFlags.None || (IsLink ? edge == 0 : After[edge] == Normals[edge]);

    /// <summary>
    /// True if vertex i is the open end of a chain: it has no neighbour, and admits what comes from beyond the link on either side.
    /// </summary>
    public readonly bool IsOpenEnd(int vertex) => IsLink && Before[vertex] == -After[vertex];

    /// <summary>
    /// True if a contact at vertex i may have the outward direction <paramref name="direction"/>; one that is out by less than
    /// the tolerance is moved to the border of the cone.
    /// </summary>
    public readonly bool Admits(int vertex, ref Vector2 direction) =>
        Flags == PieceFlags.None || OutlineCone.Clamp(Before[vertex], After[vertex], ref direction);
}

/// <summary>How one frame lies in another: point x of it is Rotation·x + Offset there.</summary>
internal struct Placement
{
    public Rotation Rotation;
    public Vector2 Offset;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector2 Apply(Vector2 v) => Rotation.Rotate(v) + Offset;
}
