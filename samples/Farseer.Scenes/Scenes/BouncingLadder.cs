using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>Eleven balls with restitution 0, 0.1, ... 1 fall from the same height: the first rebound reaches e² of it.</summary>
public sealed class BouncingLadder : Scene
{
    private const int Count = 11;
    private const float Radius = 0.4f;
    private const float Drop = 5f;
    private readonly List<Geom> _balls = [];
    private readonly float[] _apex = new float[Count];
    private readonly bool[] _bounced = new bool[Count];
    private readonly bool[] _done = new bool[Count];

    public override string Name => "bouncing-ladder";

    public override string Title => "Bouncing ladder of restitutions";

    public override string Description => "Balls with restitution 0 to 1 dropped from 5 m; each rebounds to e² of that.";

    public override SceneView View => new(new Vector2(-7f, -1f), new Vector2(7f, 6.5f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        _balls.Clear();
        Array.Clear(_apex);
        Array.Clear(_bounced);
        Array.Clear(_done);
        for (int i = 0; i < Count; i++)
        {
            float x = 1.2f * (i - (0.5f * (Count - 1)));
            float restitution = 0.1f * i;

            // The restitution of a pair is the mean of the two, so each ball has a plate of its own kind.
            Geom plate = Make.Wall(simulator, new Vector2(x, -0.5f), 1.1f, 1f);
            plate.RestitutionCoefficient = restitution;
            Geom ball = Make.Circle(simulator, new Vector2(x, Radius + Drop), Radius);
            ball.RestitutionCoefficient = restitution;
            _balls.Add(ball);
        }
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        for (int i = 0; i < Count; i++)
        {
            float height = _balls[i].Body.Position.Y - Radius;
            bool rising = _balls[i].Body.LinearVelocity.Y > 0f;
            if (!_bounced[i])
            {
                _bounced[i] = rising;
            }
            else if (!rising)
            {
                _done[i] = true;
            }

            if (_bounced[i] && !_done[i])
            {
                // Highest point of the parabola the ball is on now, so that the apex does not depend on where the steps fall.
                float v = _balls[i].Body.LinearVelocity.Y;
                _apex[i] = height + (v * v / (2f * Make.Gravity));
            }
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double worst = 0.0;
        for (int i = 0; i < Count; i++)
        {
            double e = 0.1 * i;
            worst = Math.Max(worst, Math.Abs(_apex[i] - (e * e * Drop)));
        }

        double energy = _balls[^1].Body.Position.Y - Radius
            + (_balls[^1].Body.LinearVelocity.LengthSquared() / (2.0 * Make.Gravity));
        return
        [
            // 1 % of the drop: the impact falls inside a step, and a hundredth is what a moment of impact off by 1/20 of a step costs.
            SceneOutcome.AtMost("error of the first rebound height (m)", worst, 0.01 * Drop),

            // Ten seconds are five bounces of the ball that loses nothing.
            SceneOutcome.Error("height kept by the ball with e = 1 (m)", energy, Drop, 0.02 * Drop),
            SceneOutcome.Error("height of the ball with e = 0 (m)", _balls[0].Body.Position.Y, Radius, 0.1 * Make.Tolerance),
        ];
    }
}
