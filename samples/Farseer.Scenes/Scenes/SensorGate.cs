using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>Balls fall through a sensor: it counts them in and out and does not touch them.</summary>
public sealed class SensorGate : Scene
{
    private const int Count = 8;
    private const float Radius = 0.3f;
    private const float GateTop = 5f;
    private const float GateHeight = 0.4f;
    private readonly List<Geom> _balls = [];
    private readonly int[] _enteredAt = new int[Count];
    private readonly int[] _leftAt = new int[Count];
    private readonly int[] _leaves = new int[Count];
    private readonly float[] _startHeight = new float[Count];
    private Geom? _twin;
    private int _step;
    private double _twinDifference;

    public override string Name => "sensor-gate";

    public override string Title => "Sensor gate";

    public override string Description => "Eight balls fall through a sensor: eight in, eight out, each on time, none slowed.";

    public override int Steps => 300;

    public override SceneView View => new(new Vector2(-8f, -1f), new Vector2(10f, 11f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 30f);
        Geom gate = Make.Wall(simulator, new Vector2(0f, GateTop - (0.5f * GateHeight)), 14f, GateHeight);
        gate.IsSensor = true;
        _balls.Clear();
        _step = 0;
        _twinDifference = 0.0;
        Array.Fill(_enteredAt, -1);
        Array.Fill(_leftAt, -1);
        Array.Clear(_leaves);
        for (int i = 0; i < Count; i++)
        {
            _startHeight[i] = 6f + (0.5f * i);
            Geom ball = Make.Circle(simulator, new Vector2(1.5f * (i - (0.5f * (Count - 1))), _startHeight[i]), Radius);
            Watch(gate, ball, i);
            _balls.Add(ball);
        }

        // As high as the last ball, but beside the gate.
        _twin = Make.Circle(simulator, new Vector2(9f, _startHeight[^1]), Radius);
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        _step = step;
        _twinDifference = Math.Max(_twinDifference, Math.Abs(_twin!.Body.Position.Y - _balls[^1].Body.Position.Y));
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        int entered = 0;
        int left = 0;
        double early = 0.0;
        for (int i = 0; i < Count; i++)
        {
            entered += _enteredAt[i] >= 0 ? 1 : 0;
            left += _leaves[i] == 1 && _leftAt[i] > _enteredAt[i] ? 1 : 0;
            double fall = _startHeight[i] - Radius - GateTop;
            double ideal = Math.Sqrt(2.0 * fall / Make.Gravity) / Dt;
            early = Math.Max(early, Math.Abs(_enteredAt[i] - ideal));
        }

        return
        [
            SceneOutcome.Exactly("balls seen entering", entered, Count),
            SceneOutcome.Exactly("balls seen leaving once", left, Count),

            // An overlap is seen at the first update that begins with it: up to one step after the moment itself.
            SceneOutcome.AtMost("entry off its moment (steps)", early, 1.01),
            SceneOutcome.AtMost("height against a ball beside the gate (m)", _twinDifference, 0.0),
        ];
    }

    private void Watch(Geom gate, Geom ball, int index)
    {
        ball.OnCollision += (first, second, contacts) =>
        {
            if ((first == gate || second == gate) && _enteredAt[index] < 0)
            {
                _enteredAt[index] = _step;
            }

            return true;
        };
        ball.OnSeparation += (first, second) =>
        {
            if (first == gate || second == gate)
            {
                _leftAt[index] = _step;
                _leaves[index]++;
            }
        };
    }
}
