using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes;

/// <summary>A platform whose <c>OnCollision</c> handler vetoes whatever comes from below.</summary>
public sealed class OneWayPlatform : Scene
{
    private const float Radius = 0.3f;
    private const float Top = 4f;
    private const float Thickness = 0.2f;
    private const float PassingSpeed = 0.5f;
    private static readonly float[] _launch = [7f, 10f, 12f, 14f];
    private readonly List<Geom> _balls = [];
    private readonly float[] _apex = new float[_launch.Length];

    public override string Name => "one-way";

    public override string Title => "One-way platform";

    public override string Description =>
        "Balls shot up pass the platform unslowed and land on it; the one too slow to clear it falls back.";

    public override int Steps => 360;

    public override SceneView View => new(new Vector2(-6f, -1f), new Vector2(6f, 11f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 30f);
        Geom platform = Make.Wall(simulator, new Vector2(0f, Top - (0.5f * Thickness)), 10f, Thickness);
        _balls.Clear();
        for (int i = 0; i < _launch.Length; i++)
        {
            Geom ball = Make.Circle(simulator, new Vector2(2f * (i - 1.5f), 1f), Radius);
            ball.Body.LinearVelocity = new Vector2(0f, _launch[i]);
            _apex[i] = 0f;
            _balls.Add(ball);
        }

        platform.OnCollision += (first, second, contacts) =>
        {
            // Solid for what is above the top and does not come up through it. A ball that sinks in by less than half its
            // radius counts as above; one that lies there trembles by less than the speed at which a ball comes through.
            Body other = first == platform ? second.Body : first.Body;
            return other.LinearVelocity.Y < PassingSpeed && other.Position.Y - (0.5f * Radius) > Top;
        };
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        for (int i = 0; i < _launch.Length; i++)
        {
            _apex[i] = Math.Max(_apex[i], _balls[i].Body.Position.Y);
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double apex = 0.0;
        double height = 0.0;
        int above = 0;
        for (int i = 0; i < _launch.Length; i++)
        {
            apex = Math.Max(apex, Math.Abs(_apex[i] - (1.0 + (_launch[i] * _launch[i] / (2.0 * Make.Gravity)))));

            // Surfaces that stand are held once they sank in by 1/256 of the smaller piece.
            double rest = i == 0 ? Radius : Top + Radius;
            height = Math.Max(height, Math.Abs(_balls[i].Body.Position.Y - rest));
            above += _balls[i].Body.Position.Y > Top ? 1 : 0;
        }

        // The apex may fall half a step away from the nearest sample: g (dt/2)² / 2.
        double sampling = 0.5 * Make.Gravity * 0.25 * Dt * Dt;
        return
        [
            SceneOutcome.AtMost("error of the height reached (m)", apex, sampling + 1e-4),
            SceneOutcome.Exactly("balls on the platform", above, _launch.Length - 1),
            SceneOutcome.AtMost("height error at rest (m)", height, 0.2 * Make.Tolerance),
        ];
    }
}
