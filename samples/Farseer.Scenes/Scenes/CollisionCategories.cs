using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>Three shelves, each for one category of balls; and boxes of one group that share their place.</summary>
public sealed class CollisionCategories : Scene
{
    private const float Radius = 0.4f;
    private const float ShelfThickness = 0.4f;
    private const int PerKind = 3;
    private static readonly CollisionCategory[] _kinds = [CollisionCategory.Cat1, CollisionCategory.Cat2, CollisionCategory.Cat3];
    private readonly List<Geom> _balls = [];
    private readonly List<Geom> _group = [];

    public override string Name => "collision-categories";

    public override string Title => "Collision categories and groups";

    public override string Description =>
        "Every ball falls through the shelves of other categories and rests on its own; a group ignores itself.";

    public override int Steps => 360;

    public override SceneView View => new(new Vector2(-7f, -1f), new Vector2(10f, 11f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 30f);
        _balls.Clear();
        _group.Clear();
        for (int kind = 0; kind < _kinds.Length; kind++)
        {
            Geom shelf = Make.Wall(simulator, new Vector2(0f, ShelfTop(kind) - (0.5f * ShelfThickness)), 11f, ShelfThickness);
            Only(shelf, _kinds[kind]);
        }

        for (int i = 0; i < PerKind * _kinds.Length; i++)
        {
            Geom ball = Make.Circle(simulator, new Vector2(1.1f * (i - 4), 9.5f), Radius);
            Only(ball, _kinds[i % _kinds.Length]);
            _balls.Add(ball);
        }

        for (int i = 0; i < 3; i++)
        {
            Geom box = Make.Box(simulator, new Vector2(7.5f + (0.2f * i), 2f + i), 1f, 1f);
            box.CollisionGroup = 10;
            _group.Add(box);
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        int onShelf = 0;
        double height = 0.0;
        for (int i = 0; i < _balls.Count; i++)
        {
            double error = Math.Abs(_balls[i].Body.Position.Y - (ShelfTop(i % _kinds.Length) + Radius));
            onShelf += error < 0.1 ? 1 : 0;
            height = Math.Max(height, error);
        }

        double grouped = 0.0;
        foreach (Geom box in _group)
        {
            grouped = Math.Max(grouped, Math.Abs(box.Body.Position.Y - 0.5));
        }

        return
        [
            SceneOutcome.Exactly("balls on the shelf of their category", onShelf, _balls.Count),
            SceneOutcome.AtMost("height error of any ball (m)", height, 0.2 * Make.Tolerance),

            // The three boxes overlap by 0.8 m: each rests on the floor as if it were alone.
            SceneOutcome.AtMost("height error of the grouped boxes (m)", grouped, 0.2 * Make.Tolerance),
        ];
    }

    private static float ShelfTop(int kind) => 7f - (2.5f * kind);

    private static void Only(Geom geom, CollisionCategory category)
    {
        geom.CollisionCategories = category;
        geom.CollidesWith = category;
    }
}
