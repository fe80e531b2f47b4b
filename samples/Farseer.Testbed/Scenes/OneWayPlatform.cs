using System.Collections.Generic;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Testbed.Scenes;

/// <summary>A platform that lets a ball through from below: its filter changes with the ball's place, between the steps.</summary>
public sealed class OneWayPlatform : TestScene
{
    private readonly b2Body _ball;
    private readonly b2Shape _platform;
    private bool _solid = true;
    private float _highest;

    public OneWayPlatform()
    {
        Ground();
        b2BodyDef def = new();
        def.position.Set(0, 5);
        _platform = World.CreateBody(def).CreateShape(Box(3, 0.2f, 0));
        _ball = Add(0, 1, Circle(0.5f));
        _ball.SetLinearVelocity(new b2Vec2(0, 14));
    }

    public override string Name => "one-way-platform";

    public override string Description => "A ball jumps through a platform and lands on it.";

    public override IEnumerable<Outcome> Check()
    {
        yield return That("it came through", _highest > 7);
        yield return Near("height", _ball.GetPosition().y, 5.7, 0.02);
    }

    protected override void Act(int step)
    {
        bool solid = _ball.GetPosition().y > 5.65f;
        if (solid != _solid)
        {
            _solid = solid;
            b2FilterData filter = _platform.GetFilterData();
            filter.maskBits = solid ? 0xFFFFu : 0;
            _platform.SetFilterData(filter);
            World.Refilter(_platform);
        }

        _highest = System.Math.Max(_highest, _ball.GetPosition().y);
    }
}
