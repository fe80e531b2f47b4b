using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json.Nodes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Fidelity.Flash;

/// <summary>Draws a scene and writes the calls down.</summary>
internal sealed class FlashDrawing : b2DebugDraw
{
    private readonly FlashScene _scene;
    private readonly JsonArray _calls = [];

    private FlashDrawing(FlashScene scene) => _scene = scene;

    public static JsonNode? Of(FlashScene scene, IEnumerable<string> flags)
    {
        FlashDrawing drawing = new(scene);
        drawing.SetFlags(flags.Aggregate(0u, (sum, name) => sum | (uint)typeof(b2DebugDraw).GetField(name)!.GetValue(null)!));
        scene.World.SetDebugDraw(drawing);
        scene.World.DrawDebugData();
        scene.World.SetDebugDraw(null);
        return new JsonObject { ["calls"] = drawing._calls };
    }

    public override void DrawPolygon(b2Vec2[] vertices, int vertexCount, b2Color color) =>
        Note(nameof(DrawPolygon), color, List(vertices, vertexCount));

    public override void DrawSolidPolygon(b2Vec2[] vertices, int vertexCount, b2Color color) =>
        Note(nameof(DrawSolidPolygon), color, List(vertices, vertexCount));

    public override void DrawCircle(b2Vec2 center, float radius, b2Color color) => Note(nameof(DrawCircle), color, Of(center), radius);

    public override void DrawSolidCircle(b2Vec2 center, float radius, b2Vec2 axis, b2Color color)
        => Note(nameof(DrawSolidCircle), color, Of(center), radius, Of(axis));

    public override void DrawSegment(b2Vec2 p1, b2Vec2 p2, b2Color color) => Note(nameof(DrawSegment), color, Of(p1), Of(p2));

    public override void DrawXForm(b2XForm xf) => Note(nameof(DrawXForm), null, Of(xf.position), Of(xf.R.col1), Of(xf.R.col2));

    private void Note(string kind, b2Color? color, params JsonNode?[] numbers)
    {
        JsonArray call = [kind];
        if (color is not null)
        {
            call.Add("#" + color.color.ToString("x6", CultureInfo.InvariantCulture));
        }

        foreach (JsonNode? number in numbers)
        {
            call.Add(number);
        }

        _calls.Add(call);
    }

    private JsonNode? Of(b2Vec2 v) => FlashValues.Write(_scene, v);

    private JsonArray List(b2Vec2[] vertices, int count) => new(vertices.Take(count).Select(Of).ToArray());
}
