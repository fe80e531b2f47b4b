using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>Two hundred balls of five sizes poured into a bin.</summary>
public sealed class CirclePile : Scene
{
    private const int Count = 200;
    private const float BinWidth = 8f;
    private readonly List<Geom> _balls = [];
    private PhysicsSimulator? _simulator;
    private double _area;

    public override string Name => "circle-pile";

    public override string Title => "Circle pile";

    public override string Description =>
        "200 balls of five sizes fall into a bin; they fill it as densely as round things do, and lie still.";

    public override int Steps => 1500;

    public override SceneView View => new(new Vector2(-9f, -1f), new Vector2(9f, 14f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        _simulator = simulator;
        Make.Floor(simulator, 20f);
        Make.Wall(simulator, new Vector2((-0.5f * BinWidth) - 0.5f, 10f), 1f, 22f);
        Make.Wall(simulator, new Vector2((0.5f * BinWidth) + 0.5f, 10f), 1f, 22f);
        _balls.Clear();
        _area = 0.0;
        for (int i = 0; i < Count; i++)
        {
            int row = i / 11;
            int column = i % 11;
            float radius = 0.2f + (0.03f * (i * 7 % 5));

            // Odd rows stand a quarter of a place aside, or the balls would fall into straight columns.
            float x = (0.7f * (column - 5)) + ((row & 1) == 0 ? 0f : 0.17f);
            _balls.Add(Make.Circle(simulator, new Vector2(x, 0.5f + (0.75f * row)), radius, 0.3f));
            _area += Math.PI * radius * radius;
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        int inside = 0;
        double centre = 0.0;
        foreach (Geom ball in _balls)
        {
            Vector2 position = ball.Body.Position;
            inside += Math.Abs(position.X) < 0.5f * BinWidth && position.Y > 0f ? 1 : 0;
            centre += position.Y * ball.Body.Mass / _area;
        }

        // A bin filled evenly to height H has its centre of mass at H / 2.
        double density = _area / (2.0 * centre * BinWidth);
        return
        [
            SceneOutcome.Exactly("balls in the bin", inside, Count),

            // Loose random packing of discs is about 0.77; walls and the uneven top make it look looser. Hexagonal is 0.907.
            SceneOutcome.AtLeast("share of the area filled", density, 0.70),
            SceneOutcome.AtMost("share of the area filled", density, 0.907),
            // The fall presses the pile together; 25 s are enough to push all of it out again.
            SceneOutcome.AtMost("largest penetration (m)", _simulator!.LargestPenetration, 3.0 * Make.Tolerance),
            SceneOutcome.AtMost("fastest point at the end (m/s)", Measure.FastestSpeed(_balls), 0.02),
        ];
    }
}
