using System.Collections.Generic;
using System.Linq;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Testbed.Scenes;

/// <summary>Fast bodies and a thin wall, and a bullet against a plank that can move.</summary>
public sealed class FastBodies : TestScene
{
    private readonly List<b2Body> _thrown = [];
    private readonly b2Body _bullet;
    private readonly b2Body _plank;

    public FastBodies()
        : base(0)
    {
        b2BodyDef wall = new();
        wall.position.Set(10, 0);
        World.CreateBody(wall).CreateShape(Box(0.01f, 30, 0));
        for (int i = 0; i < 8; i++)
        {
            b2Body body = i % 2 == 0 ? Add(-10, -14 + (3 * i), Circle(0.2f)) : Add(-10, -14 + (3 * i), Box(0.2f, 0.2f));
            body.SetLinearVelocity(new b2Vec2(100 * (i + 1), 0));
            _thrown.Add(body);
        }

        _plank = Add(0, 12, Box(0.05f, 2));
        _bullet = Add(new b2BodyDef { isBullet = true, position = new b2Vec2(-15, 12) }, Circle(0.2f));
        _bullet.SetLinearVelocity(new b2Vec2(400, 0));
    }

    public override string Name => "fast-bodies";

    public override string Description => "Bodies of 100 to 800 m/s stop at a wall of 2 cm; a bullet takes a plank along.";

    public override int Steps => 60;

    public override IEnumerable<Outcome> Check()
    {
        yield return That("none passed the wall", _thrown.All(b => b.GetPosition().x < 10));
        yield return That("the bullet did not pass the plank", _bullet.GetPosition().x < _plank.GetPosition().x + 0.3f);
    }
}
