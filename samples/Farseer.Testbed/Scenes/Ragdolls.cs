using System.Collections.Generic;
using System.Linq;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace Farseer.Testbed.Scenes;

/// <summary>Three figures of eleven parts on hinges with limits fall on steps.</summary>
public sealed class Ragdolls : TestScene
{
    private readonly List<b2RevoluteJoint> _joints = [];

    public Ragdolls()
    {
        Ground();
        for (int i = 0; i < 3; i++)
        {
            MakeDoll(-8 + (8 * i), 9 + i);
            b2BodyDef step = new();
            step.position.Set(-7.2f + (8 * i), 1);
            World.CreateBody(step).CreateShape(Box(0.8f, 1, 0));
        }
    }

    public override string Name => "ragdolls";

    public override string Description => "Figures on hinges with limits fall on steps and stay whole.";

    public override IEnumerable<Outcome> Check()
    {
        yield return Near("widest gap of a hinge", _joints.Max(j => b2Math.b2Distance(j.GetAnchor1(), j.GetAnchor2())), 0, 0.02);
        yield return Near(
            "largest overrun of a limit",
            _joints.Max(j => System.Math.Max(j.GetLowerLimit() - j.GetJointAngle(), j.GetJointAngle() - j.GetUpperLimit())),
            0,
            0.05);
        yield return That("all parts are above the ground", _joints.All(j => j.GetBody2().GetPosition().y > 0));
    }

    private void MakeDoll(float x, float y)
    {
        b2Body chest = Add(x, y + 2.8f, Box(0.5f, 0.3f));
        b2Body belly = Add(x, y + 2.2f, Box(0.5f, 0.3f));
        b2Body hips = Add(x, y + 1.6f, Box(0.5f, 0.3f));
        b2Body head = Add(x, y + 3.5f, Circle(0.4f));
        Join(chest, head, x, y + 3.1f, 0.7f);
        Join(chest, belly, x, y + 2.5f, 0.26f);
        Join(belly, hips, x, y + 1.9f, 0.26f);
        foreach (int side in new[] { -1, 1 })
        {
            b2Body upper = Add(x + (side * 0.95f), y + 2.9f, Box(0.45f, 0.16f));
            b2Body lower = Add(x + (side * 1.75f), y + 2.9f, Box(0.4f, 0.15f));
            Join(chest, upper, x + (side * 0.55f), y + 2.9f, 1.4f);
            Join(upper, lower, x + (side * 1.35f), y + 2.9f, 1.2f);
            b2Body thigh = Add(x + (side * 0.25f), y + 0.85f, Box(0.18f, 0.5f));
            b2Body shin = Add(x + (side * 0.25f), y - 0.05f, Box(0.15f, 0.45f));
            Join(hips, thigh, x + (side * 0.25f), y + 1.3f, 0.5f);
            Join(thigh, shin, x + (side * 0.25f), y + 0.4f, 0.5f);
        }
    }

    private void Join(b2Body a, b2Body b, float x, float y, float range)
    {
        b2RevoluteJointDef def = new() { enableLimit = true, lowerAngle = -range, upperAngle = range };
        def.Initialize(a, b, new b2Vec2(x, y));
        _joints.Add((b2RevoluteJoint)World.CreateJoint(def));
    }
}
