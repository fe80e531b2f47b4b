using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>Ten boxes fall onto one another and come to rest as a tower.</summary>
public sealed class FallingStack : Scene
{
    private const int Count = 10;
    private readonly List<Geom> _boxes = [];
    private double _startEnergy;
    private PhysicsSimulator? _simulator;

    public override string Name => "falling-stack";

    public override string Title => "Falling stack";

    public override string Description => "Ten boxes drop 10 cm each and stand as a straight tower.";

    public override SceneView View => new(new Vector2(-8f, -1f), new Vector2(8f, 12f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 20f);
        _boxes.Clear();
        _startEnergy = 0.0;
        _simulator = simulator;
        for (int i = 0; i < Count; i++)
        {
            float height = 0.6f + (1.1f * i);
            _boxes.Add(Make.Box(simulator, new Vector2(0f, height), 1f, 1f));
            _startEnergy += Make.Gravity * height;
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double sag = 0.0;
        double drift = 0.0;
        double tilt = 0.0;
        for (int i = 0; i < Count; i++)
        {
            Vector2 position = _boxes[i].Body.Position;
            double ideal = i + 0.5;
            sag = Math.Max(sag, Math.Abs(position.Y - ideal));
            drift = Math.Max(drift, Math.Abs(position.X));
            tilt = Math.Max(tilt, Math.Abs(Measure.Angle(_boxes[i].Body)));
        }

        return
        [
            // Each of the ten contacts below a box may be off by a tenth of its resting depth of 1 mm, and the top box sums them.
            SceneOutcome.AtMost("height error of any box (m)", sag, Count * 0.1 * Make.Tolerance),

            // The fall is symmetrical, nothing pushes sideways: only rounding, far below a millimetre.
            SceneOutcome.AtMost("sideways drift (m)", drift, 1e-3),
            SceneOutcome.AtMost("tilt (rad)", tilt, 1e-3),
            SceneOutcome.AtMost("fastest point at the end (m/s)", Measure.FastestSpeed(_boxes), 1e-3),

            // Nothing here drives the boxes.
            SceneOutcome.AtMost("energy gained (J)", Measure.Energy(_simulator!) - _startEnergy, 0.0),
        ];
    }
}
