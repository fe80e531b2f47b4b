using System.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Shapes;

/// <summary>All pieces, colliders and their vertex pools.</summary>
internal sealed class ShapeStore
{
    private readonly ColumnSet _vertexSet = new ColumnSet();

    public ShapeStore()
    {
        Vertices = _vertexSet.Add<Vector2>();
        Normals = _vertexSet.Add<Vector2>();
        OutlineBefore = _vertexSet.Add<Vector2>();
        OutlineAfter = _vertexSet.Add<Vector2>();
    }

    public Column<Piece> Pieces { get; } = new Column<Piece>();

    public Column<ColliderInfo> Colliders { get; } = new Column<ColliderInfo>();

    public IdPool PieceIds { get; } = new IdPool();

    public IdPool ColliderIds { get; } = new IdPool();

    public Column<Vector2> Vertices { get; }

    /// <summary>Outward unit normal of edge i.</summary>
    public Column<Vector2> Normals { get; }

    public Column<Vector2> OutlineBefore { get; }

    public Column<Vector2> OutlineAfter { get; }
}
