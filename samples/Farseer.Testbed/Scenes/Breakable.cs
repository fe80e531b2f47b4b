using System.Collections.Generic;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;

namespace Farseer.Testbed.Scenes;

/// <summary>
/// A bar that breaks in two where it is hit hard: the listener notes the impulse, and the bar is exchanged after the step.
/// </summary>
public sealed class Breakable : TestScene
{
    private readonly Listener _listener = new();
    private b2Body? _bar;
    private int _pieces = 1;

    public Breakable()
    {
        Ground();
        b2BodyDef support = new();
        support.position.Set(-2, 1);
        World.CreateBody(support).CreateShape(Box(0.2f, 1, 0));
        support.position.Set(2, 1);
        World.CreateBody(support).CreateShape(Box(0.2f, 1, 0));
        _bar = Add(0, 2.2f, Box(2.5f, 0.2f));
        Add(0, 12, Box(0.5f, 0.5f, 10));
        _listener.Watched = _bar;
        World.SetContactListener(_listener);
    }

    public override string Name => "breakable";

    public override string Description => "A bar holds its own weight and breaks in two when a heavy box falls on it.";

    public override IEnumerable<Outcome> Check()
    {
        yield return That("the bar broke", _pieces == 2);
    }

    protected override void After(int step)
    {
        if (_bar is not null && _listener.Hardest > 20)
        {
            World.SetContactListener(null);
            float y = _bar.GetPosition().y;
            World.DestroyBody(_bar);
            _bar = null;
            Add(-1.25f, y, Box(1.2f, 0.2f));
            Add(1.25f, y, Box(1.2f, 0.2f));
            _pieces = 2;
        }
    }

    private sealed class Listener : b2ContactListener
    {
        public b2Body? Watched { get; set; }

        public float Hardest { get; private set; }

        public override void Result(b2ContactResult point)
        {
            if (ReferenceEquals(point.shape1.GetBody(), Watched) || ReferenceEquals(point.shape2.GetBody(), Watched))
            {
                Hardest = System.Math.Max(Hardest, point.normalImpulse);
            }
        }
    }
}
