using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>Four boxes on a slope of 30 degrees: two slide as Coulomb says, two stay.</summary>
public sealed class FrictionRamp : Scene
{
    private const double Slope = Math.PI / 6.0;
    private const float Side = 1f;
    private const float RampFriction = 0.5f;

    // Downhill the most slippery one leads, so that no box catches another.
    private static readonly float[] _pairFriction = [0.25f, 0.4f, 0.65f, 0.9f];
    private readonly List<Geom> _boxes = [];
    private readonly List<Vector2> _start = [];

    public override string Name => "friction-ramp";

    public override string Title => "Friction ramp";

    public override string Description =>
        "Boxes with friction 0.25, 0.4, 0.65 and 0.9 on 30 degrees: two slide by a = g (sin - mu cos), two stay.";

    public override int Steps => 180;

    public override SceneView View => new(new Vector2(-14f, -8f), new Vector2(14f, 8f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Wall(simulator, Vector2.Zero, 60f, 1f, (float)-Slope, RampFriction);
        _boxes.Clear();
        _start.Clear();
        for (int i = 0; i < _pairFriction.Length; i++)
        {
            Vector2 position = (Along * (2.5f - (3f * i))) + (Normal * (0.5f + (0.5f * Side)));

            // Friction of a pair is the mean of the two.
            Geom box = Make.Box(simulator, position, Side, Side, (2f * _pairFriction[i]) - RampFriction);
            box.Body.Rotation = (float)-Slope;
            _boxes.Add(box);
            _start.Add(position);
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        List<SceneOutcome> outcomes = [];
        double time = Steps * (double)Dt;
        for (int i = 0; i < _pairFriction.Length; i++)
        {
            double run = Vector2.Dot(_boxes[i].Body.Position - _start[i], Along);
            double acceleration = Math.Max(0.0, Make.Gravity * (Math.Sin(Slope) - (_pairFriction[i] * Math.Cos(Slope))));
            double ideal = 0.5 * acceleration * time * time;
            string name = FormattableString.Invariant($"way error at mu = {_pairFriction[i]:0.00} (m)");

            // Half a per cent of the way for the sliding ones; a box that sticks may not creep by its resting depth.
            outcomes.Add(SceneOutcome.Error(name, run, ideal, ideal > 0.0 ? 0.005 * ideal : Make.Tolerance));
        }

        return outcomes;
    }

    private static Vector2 Along => new((float)Math.Cos(Slope), (float)-Math.Sin(Slope));

    private static Vector2 Normal => new((float)Math.Sin(Slope), (float)Math.Cos(Slope));
}
