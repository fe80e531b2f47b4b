using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes;

/// <summary>A body made of a drawing with a hole: polygons without holes on one body.</summary>
public sealed class BitmapBody : Scene
{
    private const float Pixel = 0.1f;

    private static readonly string[] _drawing =
    [
        "..############..",
        ".##############.",
        "################",
        "####........####",
        "####........####",
        "####........####",
        "####........####",
        "################",
        "################",
        "################",
    ];

    private readonly List<Geom> _parts = [];
    private Body? _body;
    private double _area;

    public override string Name => "bitmap-body";

    public override string Title => "Body from a bitmap";

    public override string Description =>
        "A drawing with a hole becomes polygons of one body, which falls on its flat side and keeps a ball in its hole.";

    public override SceneView View => new(new Vector2(-2f, -0.5f), new Vector2(2f, 3f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 20f);
        int width = _drawing[0].Length;
        var bits = new uint[width * _drawing.Length];
        for (int i = 0; i < bits.Length; i++)
        {
            // The rows from the bottom up: y points up here.
            bits[i] = _drawing[_drawing.Length - 1 - (i / width)][i % width] == '#' ? uint.MaxValue : 0u;
        }

        _parts.Clear();
        _area = 0.0;
        _body = new Body { Position = new Vector2(0f, 1.5f), Mass = 2f, MomentOfInertia = 0.6f };
        Make.NoDrag(_body);
        simulator.Add(_body);
        foreach (Vertices part in Vertices.CreatePolygons(bits, width, _drawing.Length, new Vector2(8f, 5f), 20, 0f))
        {
            part.Scale(new Vector2(Pixel));
            _area += part.GetArea();
            var geom = new Geom(_body, part, 0f) { FrictionCoefficient = 0.5f };
            _parts.Add(geom);
            simulator.Add(geom);
        }

        Make.Circle(simulator, new Vector2(0f, 1.5f), 0.1f);
    }

    public override IReadOnlyList<SceneOutcome> Check() =>
    [
        SceneOutcome.AtLeast("polygons", _parts.Count, 2),
        SceneOutcome.Error("their area (m²)", _area, ((16 * 10) - 2 - 4 - 32) * Pixel * Pixel, 1e-4),
        SceneOutcome.Error("height of the body (m)", _body!.PositionY, 5 * Pixel, 2.0 * Make.Tolerance),
        SceneOutcome.AtMost("tilt (rad)", System.Math.Abs(Measure.Angle(_body)), 1e-3),
    ];
}
