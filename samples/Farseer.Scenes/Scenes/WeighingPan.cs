using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>
/// A heavy pan that swings on two springs with a hundred light balls in it: many contacts of one body, which weighs four hundred times as
/// much as each other.
/// </summary>
public sealed class WeighingPan : Scene
{
    private const int Balls = 100;
    private const float Radius = 0.1f;
    private const float BallMass = 0.5f;
    private const float PanMass = 200f;
    private const float Width = 21f;
    private const float Thickness = 0.5f;
    private const float Stiffness = 1250f;
    private const float Hook = 10f;
    private const float Amplitude = 0.2f;
    private const float Weight = (PanMass + (Balls * BallMass)) * Make.Gravity;
    private readonly List<Geom> _balls = [];
    private Body? _pan;

    public override string Name => "weighing-pan";

    public override string Title => "Weighing pan";

    public override string Description =>
        "A pan of 200 kg with 100 balls of 0.5 kg swings on two springs: its period tells the weight of all.";

    public override SceneView View => new(new Vector2(-12f, -2f), new Vector2(12f, 11f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        _balls.Clear();
        _pan = BodyFactory.Instance.CreateRectangleBody(simulator, Width, Thickness, PanMass);
        Make.NoDrag(_pan);
        GeomFactory.Instance.CreateRectangleGeom(simulator, _pan, Width, Thickness);
        foreach (float side in new[] { -1f, 1f })
        {
            var rim = new Vector2(side * 0.5f * (Width - Thickness), Thickness);
            GeomFactory.Instance.CreateRectangleGeom(simulator, _pan, Thickness, Thickness, rim, 0f);
            FixedLinearSpring spring = SpringFactory.Instance.CreateFixedLinearSpring(
                simulator, _pan, new Vector2(side * Hook, 0f), new Vector2(side * Hook, Hook), Stiffness, 0f);

            // The pan is let go below its rest, where the springs carry all of it and pull by the amplitude more.
            spring.RestLength = Hook - (Weight / (2f * Stiffness)) - Amplitude;
        }

        for (int i = 0; i < Balls; i++)
        {
            float x = 2f * Radius * (i - (0.5f * (Balls - 1)));
            Geom ball = Make.Circle(simulator, new Vector2(x, (0.5f * Thickness) + Radius), Radius);
            ball.Body.Mass = BallMass;
            ball.Body.MomentOfInertia = 0.5f * BallMass * Radius * Radius;
            _balls.Add(ball);
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double swing = Math.Sqrt(2.0 * Stiffness * Make.Gravity / Weight);
        double due = Amplitude * (1.0 - Math.Cos(swing * Steps * (double)Dt));
        double highest = 0.0;
        double lowest = 1.0;
        foreach (Geom ball in _balls)
        {
            double above = ball.Body.PositionY - _pan!.PositionY - (0.5 * Thickness) - Radius;
            highest = Math.Max(highest, above);
            lowest = Math.Min(lowest, above);
        }

        return
        [
            // 4e-5 is what the balls sink in and come back with the load.
            SceneOutcome.Error("height of the pan after five swings (m)", _pan!.PositionY, due, 2e-4),
            SceneOutcome.AtMost("turn of the pan (rad)", Math.Abs(_pan.TotalRotation), 1e-3),

            // The balls press with half a newton more or less than their five: they never leave the pan.
            SceneOutcome.AtMost("highest ball above the pan (m)", highest, 1e-3),
            SceneOutcome.AtMost("deepest ball in the pan (m)", -lowest, 2.0 * Make.Tolerance),
        ];
    }

}
