using System.Collections.Generic;
using System.Linq;
using Box2D.Dynamics;

namespace Farseer.Testbed.Scenes;

/// <summary>Ten boxes on one another.</summary>
public sealed class Stack : TestScene
{
    private readonly List<b2Body> _boxes = [];

    public Stack()
    {
        Ground();
        for (int i = 0; i < 10; i++)
        {
            _boxes.Add(Add(0, 0.5f + (1.02f * i), Box(0.5f, 0.5f)));
        }
    }

    public override string Name => "stack";

    public override string Description => "Ten boxes on one another stay where they are.";

    public override IEnumerable<Outcome> Check()
    {
        yield return Near("height of the highest", _boxes[^1].GetPosition().y, 9.5, 0.06);
        yield return Near("farthest to the side", _boxes.Max(b => System.Math.Abs(b.GetPosition().x)), 0, 0.02);
    }
}
