using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>
/// A link with the body behind it, as thick as its extent. Two bare lines overlap at no time by more than a hair: they are before each
/// other, and then through. Where links meet links, a search for how deep they go needs something that they can go into.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct SolidLink
{
    public const int Corners = 4;

    private fixed float _vertices[2 * Corners];
    private fixed float _normals[2 * Corners];

    public Vector2* Vertices => (Vector2*)Unsafe.AsPointer(ref _vertices[0]);

    public Vector2* Normals => (Vector2*)Unsafe.AsPointer(ref _normals[0]);

    /// <summary>Fills in the corners; a link's first edge is its face.</summary>
    public void Set(ShapeStore shapes, in Piece link)
    {
        Vector2 start = shapes.Vertices[link.VertexStart];
        Vector2 end = shapes.Vertices[link.VertexStart + 1];
        Vector2 normal = shapes.Normals[link.VertexStart];
        var along = new Vector2(-normal.Y, normal.X);
        Vector2 back = normal * link.Extent;
        Vertices[0] = start;
        Vertices[1] = end;
        Vertices[2] = end - back;
        Vertices[3] = start - back;
        Normals[0] = normal;
        Normals[1] = along;
        Normals[2] = -normal;
        Normals[3] = -along;
    }
}
