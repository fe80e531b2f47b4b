using System.Collections.Generic;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Testbed.Scenes;

/// <summary>Water, by forces before each step: lift by the part of a box that is under the surface, and drag.</summary>
public sealed class Buoyancy : TestScene
{
    private const float Surface = 5;
    private readonly List<(b2Body Body, float Density)> _boxes = [];

    public Buoyancy()
    {
        Ground();
        foreach (float density in new[] { 0.25f, 0.5f, 0.75f, 2f })
        {
            _boxes.Add((Add(-6 + (4 * _boxes.Count), 9, Box(1, 1, density)), density));
        }
    }

    public override string Name => "buoyancy";

    public override string Description => "Boxes float as deep as they are dense, and the heavy one lies on the ground.";

    public override int Steps => 900;

    public override IEnumerable<Outcome> Check()
    {
        foreach ((b2Body body, float density) in _boxes)
        {
            double wanted = density < 1 ? Surface + 1 - (2 * density) : 1;
            yield return Near($"height at density {density}", body.GetPosition().y, wanted, 0.03);
        }
    }

    protected override void Act(int step)
    {
        foreach ((b2Body body, _) in _boxes)
        {
            float depth = b2Math.b2Clamp(Surface - (body.GetPosition().y - 1), 0, 2);
            b2Vec2 v = body.GetLinearVelocity();
            b2Vec2 force = new(-2 * depth * v.x, (10 * 2 * depth) - (2 * depth * v.y));
            body.ApplyForce(force, body.GetWorldCenter());
        }
    }
}
