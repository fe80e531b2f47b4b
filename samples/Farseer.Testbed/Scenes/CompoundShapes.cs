using System.Collections.Generic;
using System.Linq;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Testbed.Scenes;

/// <summary>Bodies of several shapes: dumbbells, tables and triangles on a foot.</summary>
public sealed class CompoundShapes : TestScene
{
    private readonly List<b2Body> _bodies = [];

    public CompoundShapes()
    {
        Ground();
        for (int i = 0; i < 5; i++)
        {
            b2CircleDef left = Circle(0.5f, 2);
            left.localPosition.Set(-0.5f, 0.5f);
            b2CircleDef right = Circle(0.5f, 0.5f);
            right.localPosition.Set(0.5f, 0.5f);
            _bodies.Add(Add(-8, 1 + (2.2f * i), left, right));
            b2PolygonDef top = Box(1.5f, 0.15f, 4);
            b2PolygonDef leg1 = new() { density = 2 };
            leg1.SetAsOrientedBox(0.2f, 1, new b2Vec2(-1.3f, -0.9f));
            b2PolygonDef leg2 = new() { density = 2 };
            leg2.SetAsOrientedBox(0.2f, 1, new b2Vec2(1.3f, -0.9f));
            _bodies.Add(Add(6, 2.2f + (2.4f * i), top, leg1, leg2));
        }
    }

    public override string Name => "compound";

    public override string Description => "Bodies of several shapes pile up and come to rest.";

    public override int Steps => 600;

    public override IEnumerable<Outcome> Check()
    {
        yield return That("nothing fell through the ground", _bodies.All(b => b.GetWorldCenter().y > 0));
        yield return Near("fastest body", _bodies.Max(b => b.GetLinearVelocity().Length()), 0, 0.1);
    }
}
