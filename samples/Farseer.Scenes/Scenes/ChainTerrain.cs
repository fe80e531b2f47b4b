using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>One long chain as ground: a smooth box glides over eighty seams, balls settle in three valleys.</summary>
public sealed class ChainTerrain : Scene
{
    private const float Speed = 3f;
    private const float SeamPitch = 0.25f;
    private const int Seams = 80;
    private const float ValleyWidth = 4f;
    private const float Radius = 0.5f;
    private const int Valleys = 3;
    private const float Underground = 2f;
    private static readonly float _depth = (float)(0.5 * ValleyWidth * Math.Tan(Math.PI / 6.0));
    private readonly List<Geom> _balls = [];
    private Geom? _box;
    private float _startX;
    private double _lift;

    public override string Name => "chain-terrain";

    public override string Title => "Chain terrain";

    public override string Description => "A frictionless box glides over 80 seams without a bump; balls settle at the bottom of valleys.";

    public override int Steps => 360;

    public override SceneView View => new(new Vector2(-1f, -3f), new Vector2(33f, 4f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        List<Vector2> points = [];
        for (int i = 0; i <= Seams; i++)
        {
            points.Add(new Vector2(SeamPitch * i, 0f));
        }

        float x = SeamPitch * Seams;
        _balls.Clear();
        for (int i = 0; i < Valleys; i++)
        {
            points.Add(new Vector2(x + (0.5f * ValleyWidth), -_depth));
            points.Add(new Vector2(x + ValleyWidth, 0f));

            // Each starts a little farther off the middle of its valley.
            // Friction of a pair is the mean of the two: rough balls, but a smooth box, on the smooth ground.
            _balls.Add(Make.Circle(simulator, new Vector2(x + (0.5f * ValleyWidth) + (0.3f * i), 0.6f), Radius, 1f));
            x += ValleyWidth;
        }

        // A chain is solid on the side that looks left on the way from the first point on when y is up, here upwards:
        // the points go from right to left and then back underground.
        points.Reverse();
        points.Add(new Vector2(0f, -Underground));
        points.Add(new Vector2(x, -Underground));
        Body ground = BodyFactory.Instance.CreateBody(simulator, 1f, 1f);
        ground.IsStatic = true;
        Geom chain = GeomFactory.Instance.CreateChainGeom(simulator, ground, new Vertices(points.ToArray()), true);
        chain.FrictionCoefficient = 0f;

        _startX = 1f;
        _box = Make.Box(simulator, new Vector2(_startX, 0.25f), 0.5f, 0.5f, 0f);
        _box.Body.LinearVelocity = new Vector2(Speed, 0f);
        _lift = 0.0;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt) =>
        _lift = Math.Max(_lift, Math.Abs(_box!.Body.Position.Y - 0.25));

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double settled = 0.0;
        for (int i = 0; i < Valleys; i++)
        {
            double x = (SeamPitch * Seams) + (ValleyWidth * (i + 0.5));
            double y = -_depth + (Radius / Math.Cos(Math.PI / 6.0));
            Vector2 position = _balls[i].Body.Position;
            settled = Math.Max(settled, Math.Max(Math.Abs(position.X - x), Math.Abs(position.Y - y)));
        }

        double time = Steps * (double)Dt;
        return
        [
            SceneOutcome.Error("way of the gliding box (m)", _box!.Body.Position.X, _startX + (Speed * time), 1e-3),
            SceneOutcome.Error("speed of the gliding box (m/s)", _box.Body.LinearVelocity.X, Speed, 1e-3),
            SceneOutcome.AtMost("bump of the gliding box (m)", _lift, 0.1 * Make.Tolerance),
            SceneOutcome.AtMost("ball off the bottom of its valley (m)", settled, 5e-3),
        ];
    }
}
