using System.Numerics;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Views;

namespace Farseer.Samples.Drawing;

/// <summary>Puts a second world of a scene where it belongs in the picture.</summary>
internal sealed class CompanionDraw : IDebugDraw
{
    private readonly IDebugDraw _picture;
    private readonly SceneCompanion _companion;

    public CompanionDraw(IDebugDraw picture, SceneCompanion companion)
    {
        _picture = picture;
        _companion = companion;
    }

    public void DrawLine(Vector2 start, Vector2 end, DebugColor color) => _picture.DrawLine(Place(start), Place(end), color);

    public void DrawPolygon(Vertices vertices, DebugColor line, DebugColor fill)
    {
        Vertices placed = new();
        foreach (Vector2 vertex in vertices)
        {
            placed.Add(Place(vertex));
        }

        _picture.DrawPolygon(placed, line, fill);
    }

    public void DrawCircle(Vector2 center, float radius, DebugColor line, DebugColor fill) =>
        _picture.DrawCircle(Place(center), radius * _companion.Scale, line, fill);

    public void DrawPoint(Vector2 position, float size, DebugColor color) => _picture.DrawPoint(Place(position), size, color);

    private Vector2 Place(Vector2 point) => new(
        (float)(((point.X + _companion.ShiftX) * _companion.Scale) + _companion.Offset.X),
        (point.Y * _companion.Scale) + _companion.Offset.Y);
}
