using System;
using System.Linq;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Testbed;

/// <summary>Draws a world in letters, by its debug drawing.</summary>
public sealed class TextDraw : b2DebugDraw
{
    private const int Columns = 100;
    private const int Rows = 36;

    private readonly char[][] _cells = [.. Enumerable.Range(0, Rows).Select(_ => new string(' ', Columns).ToCharArray())];
    private readonly (float HalfWidth, float X, float Y) _view;

    private TextDraw((float HalfWidth, float X, float Y) view) => _view = view;

    public static string Picture(TestScene scene)
    {
        TextDraw draw = new(scene.View);
        draw.SetFlags(e_shapeBit | e_jointBit);
        scene.World.SetDebugDraw(draw);
        scene.World.DrawDebugData();
        scene.World.SetDebugDraw(null);
        return string.Join('\n', draw._cells.Select(r => new string(r).TrimEnd())) + "\n";
    }

    public override void DrawSolidPolygon(b2Vec2[] vertices, int vertexCount, b2Color color)
    {
        for (int i = 0; i < vertexCount; i++)
        {
            Line(vertices[i], vertices[(i + 1) % vertexCount], '#');
        }
    }

    public override void DrawSolidCircle(b2Vec2 center, float radius, b2Vec2 axis, b2Color color)
    {
        const int Parts = 40;
        for (int i = 0; i < Parts; i++)
        {
            double angle = 2 * Math.PI * i / Parts;
            Dot(center.x + (radius * Math.Cos(angle)), center.y + (radius * Math.Sin(angle)), 'o');
        }
    }

    public override void DrawSegment(b2Vec2 p1, b2Vec2 p2, b2Color color) => Line(p1, p2, '.');

    private void Line(b2Vec2 from, b2Vec2 to, char letter)
    {
        int parts = 1 + (int)(b2Math.b2Distance(from, to) * Columns / _view.HalfWidth);
        for (int i = 0; i <= Math.Min(parts, 2000); i++)
        {
            double at = i / (double)parts;
            Dot(from.x + (at * (to.x - from.x)), from.y + (at * (to.y - from.y)), letter);
        }
    }

    private void Dot(double x, double y, char letter)
    {
        // A letter is about twice as high as it is wide.
        double scale = Columns / (2 * _view.HalfWidth);
        int column = (int)Math.Round(((x - _view.X) * scale) + (Columns / 2.0));
        int row = (int)Math.Round((Rows / 2.0) - ((y - _view.Y) * scale / 2));
        if (column >= 0 && column < Columns && row >= 0 && row < Rows)
        {
            _cells[row][column] = letter;
        }
    }
}
