using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>Six equal balls in a row without gravity: the push travels through, only the last ball leaves.</summary>
public sealed class NewtonsLine : Scene
{
    private const int Count = 6;
    private const float Radius = 0.5f;
    private const float Speed = 5f;

    // More than the 8 cm a ball does in a step, so that each collision is a pair's own affair.
    private const float Gap = 0.25f;
    private readonly List<Geom> _balls = [];

    public override string Name => "newtons-line";

    public override string Title => "Newton's line";

    public override string Description => "An elastic ball hits five at rest: the last one leaves with its speed, the others stay.";

    public override int Steps => 180;

    public override SceneView View => new(new Vector2(-7f, -3f), new Vector2(15f, 3f));

    public override void Build(PhysicsSimulator simulator)
    {
        simulator.Gravity = Vector2.Zero;
        _balls.Clear();
        for (int i = 0; i < Count; i++)
        {
            float x = i == 0 ? -5f : (i - 1) * ((2f * Radius) + Gap);
            Geom ball = Make.Circle(simulator, new Vector2(x, 0f), Radius);
            ball.RestitutionCoefficient = 1f;
            _balls.Add(ball);
        }

        _balls[0].Body.LinearVelocity = new Vector2(Speed, 0f);
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double momentum = 0.0;
        double energy = 0.0;
        double others = 0.0;
        double mass = _balls[0].Body.Mass;
        for (int i = 0; i < Count; i++)
        {
            Vector2 v = _balls[i].Body.LinearVelocity;
            momentum += v.X;
            energy += v.LengthSquared();
            others = i < Count - 1 ? Math.Max(others, v.Length()) : others;
        }

        return
        [
            SceneOutcome.Error("speed of the last ball (m/s)", _balls[^1].Body.LinearVelocity.X, Speed, 0.01 * Speed),
            SceneOutcome.AtMost("speed left in the others (m/s)", others, 0.01 * Speed),

            // Impulses come in equal and opposite pairs: only rounding is left.
            SceneOutcome.Error("momentum, relative", momentum / Speed, 1.0, 1e-5),
            SceneOutcome.Error("energy, relative", energy / (Speed * Speed), 1.0, 0.01),
            SceneOutcome.Error("mass of a ball (kg)", mass, Math.PI * Radius * Radius, 1e-6),
        ];
    }
}
