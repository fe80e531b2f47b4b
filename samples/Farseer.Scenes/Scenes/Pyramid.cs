using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>Two hundred and ten boxes, each row half a box in from the one below.</summary>
public sealed class Pyramid : Scene
{
    private const int Base = 20;
    private const float Pitch = 1.1f;
    private readonly List<Geom> _boxes = [];
    private readonly List<Vector2> _ideal = [];

    public override string Name => "pyramid";

    public override string Title => "Pyramid";

    public override string Description => "210 boxes stacked as a pyramid of 20 rows; it must stand without a box leaving its place.";

    public override SceneView View => new(new Vector2(-14f, -1f), new Vector2(14f, 21f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 40f);
        _boxes.Clear();
        _ideal.Clear();
        for (int row = 0; row < Base; row++)
        {
            for (int i = 0; i < Base - row; i++)
            {
                float x = Pitch * (i - (0.5f * (Base - row - 1)));
                float y = row + 0.5f;
                _boxes.Add(Make.Box(simulator, new Vector2(x, y), 1f, 1f, 0.6f));
                _ideal.Add(new Vector2(x, y));
            }
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double top = Math.Abs(_boxes[^1].Body.Position.Y - _ideal[^1].Y);
        double moved = 0.0;
        for (int i = 0; i < _boxes.Count; i++)
        {
            moved = Math.Max(moved, (_boxes[i].Body.Position - _ideal[i]).Length());
        }

        return
        [
            // Twenty contacts in line, each allowed to be off by its own resting depth (1 mm).
            SceneOutcome.AtMost("height error of the top box (m)", top, Base * Make.Tolerance),

            // Half of the resting depth of all rows in line.
            SceneOutcome.AtMost("farthest any box moved (m)", moved, 0.01),

            // Ten seconds are enough for a tower of 20 m to stop swaying.
            SceneOutcome.AtMost("fastest point at the end (m/s)", Measure.FastestSpeed(_boxes), 5e-3),
        ];
    }
}
