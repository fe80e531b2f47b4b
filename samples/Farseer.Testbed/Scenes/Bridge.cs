using System.Collections.Generic;
using System.Linq;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace Farseer.Testbed.Scenes;

/// <summary>Thirty planks on hinges between two abutments, with loads on them.</summary>
public sealed class Bridge : TestScene
{
    private readonly List<b2Joint> _hinges = [];
    private readonly List<b2Body> _loads = [];

    public Bridge()
    {
        b2Body ground = Ground();
        b2Body before = ground;
        b2RevoluteJointDef hinge = new();
        for (int i = 0; i < 30; i++)
        {
            b2Body plank = Add(-14.5f + i, 5, Box(0.5f, 0.125f, 20, 0.2f));
            hinge.Initialize(before, plank, new b2Vec2(-15 + i, 5));
            _hinges.Add(World.CreateJoint(hinge));
            before = plank;
        }

        hinge.Initialize(before, ground, new b2Vec2(15, 5));
        _hinges.Add(World.CreateJoint(hinge));
        _loads.Add(Add(-4, 8, Box(0.5f, 0.5f)));
        _loads.Add(Add(3, 9, Circle(0.5f)));
    }

    public override string Name => "bridge";

    public override string Description => "Thirty planks on hinges carry what falls on them.";

    public override IEnumerable<Outcome> Check()
    {
        yield return Near("widest gap of a hinge", _hinges.Max(h => b2Math.b2Distance(h.GetAnchor1(), h.GetAnchor2())), 0, 0.01);
        yield return That("the loads are above the ground", _loads.All(b => b.GetPosition().y > 1));
    }
}
