using System.Collections.Generic;
using System.Linq;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Testbed.Scenes;

/// <summary>A ray that turns, answered by the world's box query and each shape's own test.</summary>
public sealed class RayCast : TestScene
{
    private readonly List<(double Angle, float Lambda)> _hits = [];

    public RayCast()
        : base(0)
    {
        for (int i = 0; i < 12; i++)
        {
            double angle = i * System.Math.PI / 6;
            b2BodyDef def = new();
            def.position.Set((float)(8 * System.Math.Cos(angle)), (float)(8 * System.Math.Sin(angle)));
            World.CreateBody(def).CreateShape(i % 2 == 0 ? Circle(1, 0) : Box(1, 1, 0));
        }
    }

    public override string Name => "raycast";

    public override string Description => "A ray turns about the middle and finds what is nearest.";

    public override int Steps => 120;

    public override (float HalfWidth, float X, float Y) View => (14, 0, 0);

    public override IEnumerable<Outcome> Check()
    {
        yield return Near("hits", _hits.Count, 60, 12);
        yield return Near("nearest", 10 * _hits.Min(h => h.Lambda), 6.8, 0.3);
    }

    protected override void Act(int step)
    {
        double angle = 2 * System.Math.PI * step / Steps;
        b2Segment ray = new() { p2 = new b2Vec2((float)(10 * System.Math.Cos(angle)), (float)(10 * System.Math.Sin(angle))) };
        b2AABB box = new();
        box.lowerBound.SetV(b2Math.b2MinV(ray.p1, ray.p2));
        box.upperBound.SetV(b2Math.b2MaxV(ray.p1, ray.p2));
        List<b2Shape> found = [];
        World.Query(box, found, 100);
        float nearest = 1;
        bool hit = false;
        float[] lambda = new float[1];
        b2Vec2 normal = new();
        foreach (b2Shape shape in found)
        {
            if (shape.TestSegment(shape.GetBody()!.GetXForm(), lambda, normal, ray, nearest))
            {
                nearest = lambda[0];
                hit = true;
            }
        }

        if (hit)
        {
            _hits.Add((angle, nearest));
        }
    }
}
